#include "refusal.hpp"
#include "stressfield/read.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace filum::stressfield {
namespace {

Samples csv(const std::string& text, const std::string& columns = "", Notes* notes = nullptr) {
    Notes own;
    ReadOptions o;
    o.columns = columns;
    return read(text, "it", o, notes != nullptr ? *notes : own);
}

std::string csv_fault(const std::string& text, Exit exit, const std::string& columns = "") {
    return refusal(exit, text, [&] { csv(text, columns); });
}

TEST(Csv, TensorByHeaderInAnyOrderUnitsAndLineEnds) {
    const auto s = csv(
        "\xef\xbb\xbfNode,SYY [MPa],SXX [MPa],SZZ,SXY,SYZ,SXZ,\"X Location (mm)\",Y Location (mm),Z Location (mm)\r\n"
        "7,2,1,3,4,5,6,10,20,30\r\n");
    ASSERT_EQ(s.points.size(), 1U);
    EXPECT_EQ(s.points[0], (Vec3{10, 20, 30}));
    EXPECT_EQ(s.cases[0].tensors[0], (Tensor{1, 2, 3, 4, 5, 6}));
    EXPECT_TRUE(s.cases[0].principals.empty());
}

TEST(Csv, SeparatorsAndDecimalCommas) {
    for (const std::string text :
         {"1,5;0;0;3;0;0\n", "1.5\t0\t0\t3\t0\t0\n", "1.5 0  0 3 0 0 \n", "# what\n\n 1.5, 0, 0, 3, 0, 0,\n"}) {
        const auto s = csv(text);
        ASSERT_EQ(s.points.size(), 1U) << text;
        EXPECT_EQ(s.points[0].x, 1.5) << text;
        EXPECT_EQ(s.cases[0].principals[0][0], 3) << text;
        EXPECT_TRUE(std::isinf(s.cases[0].principals[0][1])) << text;
        EXPECT_EQ(s.cases[0].directions[0], (Vec3{3, 0, 0})) << text;
    }
}

TEST(Csv, FilesOfOtherKindsAreNamed) {
    const std::pair<std::string, std::string> kinds[] = {
        {"# vtk DataFile Version 3.0\nx\nASCII\n", "VTK's old kind"},
        {"<?xml version=\"1.0\"?>\n<!DOCTYPE Xdmf>\n<Xdmf Version=\"3.0\"/>", "XDMF"},
        {std::string("\x89HDF\r\n\x1a\n\0\0", 10), "HDF5"},
        {std::string("PK\x03\x04\0\0", 6), "spreadsheet"},
        {"$MeshFormat\n4.1 0 8\n", "Gmsh"},
        {"    -1\n  2411\n 1 1 1\n", "universal file"},
        {"*Heading\n*Node\n1, 0., 0., 0.\n", "input of a finite element program"},
        {"** a comment\n*NODE\n1,0,0,0\n", "input of a finite element program"},
        {"\n   Abaqus 2021      Date 1-Jan\n  THE FOLLOWING TABLE IS PRINTED\n", "printed text of Abaqus"},
        {std::string("d\0\0\0xyz", 7), "binary file"}};
    for (const auto& [text, kind] : kinds) EXPECT_TRUE(has(csv_fault(text, Exit::bad_input), kind)) << kind;
}

TEST(Csv, PrincipalsGoWithTheDirection) {
    const auto s = csv("x,y,z,s1x,s1y,s1z,s1,s2,s3\n0,0,0,0,0,-2,-1,-3,-5\n");
    EXPECT_EQ(s.cases[0].principals[0], (Principal{-1, -3, -5}));
    EXPECT_EQ(s.cases[0].directions[0], (Vec3{0, 0, -2}));
    EXPECT_EQ(about(s.cases[0].directions[0], s.cases[0].principals[0]), (Tensor{-4, -4, -1, 0, 0, 0}));
}

TEST(Csv, ColumnsByOption) {
    const auto s = csv("9 9 1 2 3 0 4 0\n", "-,-,x,y,z,vx,vy,vz");
    EXPECT_EQ(s.points[0], (Vec3{1, 2, 3}));
    EXPECT_EQ(s.cases[0].directions[0], (Vec3{0, 4, 0}));
    EXPECT_TRUE(has(csv_fault("1 2 3 4\n", Exit::usage, "x,y,z,strain"), "strain"));
    EXPECT_TRUE(has(csv_fault("1 2 3 4\n", Exit::usage, "x,y,x"), "twice"));
    EXPECT_TRUE(has(csv_fault("1 2 3 4\n", Exit::usage, "x,y,z"), "sxx"));
    EXPECT_TRUE(has(csv_fault("1 2 3 4 5\n", Exit::bad_input, "x,y,z,vx,vy,vz"), "6 columns"));
}

TEST(Csv, UnitsAndNames) {
    Notes notes;
    const auto s = read("1 0 0 3 0 0\n", "it", {.names = "pull", .unit = "m", .stress_unit = "kPa"}, notes);
    EXPECT_EQ(s.points[0].x, 1000);
    EXPECT_DOUBLE_EQ(s.cases[0].principals[0][0], 0.003);
    EXPECT_EQ(s.cases[0].name, "pull");
    for (const char* name : {"a,b", "a b", "a.b", "/"})
        EXPECT_THROW(read("1 0 0 3 0 0\n", "it", {.names = name}, notes), Error) << name;
}

TEST(Csv, WhatIsNotFiniteIsLeftOutAndNoted) {
    Notes notes;
    const auto s =
        csv("x,y,z,s1x,s1y,s1z\n1,0,0,3,0,0\nnan,0,0,3,0,0\n2,0,0,NaN,0,0\n3,0,0,,0,0\n4,0,0,1e999,0,0\n", "", &notes);
    EXPECT_EQ(s.points.size(), 1U);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].count, 4U);
    EXPECT_TRUE(has(csv_fault("x,y,z,s1x,s1y,s1z,s1\n0,0,0,nan,0,0,1\n", Exit::bad_input), "no sample"));
    EXPECT_TRUE(has(csv_fault("nan 0 0 1 0 0\n", Exit::bad_input), "no sample"));
}

TEST(Csv, SamplesAtOnePlaceAreAveraged) {
    Notes notes;
    const auto s = csv("1 0 0 3 0 0\n0 0 0 1 0 0\n1 0 0 -5 0 0\n", "", &notes);
    ASSERT_EQ(s.points.size(), 2U);
    EXPECT_EQ(std::abs(s.cases[0].directions[1].x), 1); // for any signs
    EXPECT_EQ(s.cases[0].principals[1][0], 4);
    ASSERT_EQ(notes.size(), 1U);
}

// One load case after the other, without a column that tells them apart, in any number and size.
TEST(Csv, TablesOneAfterTheOtherAreRefused) {
    const auto rows = [](int places, double stress) {
        std::string out;
        for (int i = 0; i < places; ++i)
            out += std::to_string(i % 3) + " " + std::to_string(i / 3) + " 0 " + std::to_string(stress + i) + " 0 0\n";
        return out;
    };
    const std::string header = "x y z s1x s1y s1z\n";
    for (const int places : {1, 2, 7, 12})
        for (const int times : {2, 3, 5})
            for (const bool repeated : {false, true}) {
                std::string text = header;
                for (int k = 0; k < times; ++k) text += (repeated && k > 0 ? header : "") + rows(places, 1 + k);
                const std::string words =
                    "lists the same " + std::to_string(places) + " places " + std::to_string(times);
                EXPECT_TRUE(has(csv_fault(text, Exit::bad_input), words)) << text;
                std::string same = header; // the same stresses again do no harm
                for (int k = 0; k < times; ++k) same += rows(places, 1);
                EXPECT_EQ(csv(same).points.size(), static_cast<std::size_t>(places));
            }
    // corners of two elements: a place comes again, but not all of them in the same order
    EXPECT_EQ(csv(header + "0 0 0 1 0 0\n1 0 0 2 0 0\n1 0 0 3 0 0\n2 0 0 4 0 0\n").points.size(), 3U);
    EXPECT_EQ(csv(header + "0 0 0 1 0 0\n1 0 0 2 0 0\n1 0 0 3 0 0\n0 0 0 4 0 0\n").points.size(), 2U);
}

TEST(Csv, StressesThatNoMaterialBearsNeedAUnit) {
    const std::string text = "x,y,z,sxx,syy,szz,sxy,syz,szx\n0,0,0,2e7,0,0,0,0,0\n1,0,0,3e7,0,0,0,0,0\n";
    EXPECT_TRUE(has(csv_fault(text, Exit::bad_input), "--stress-unit"));
    Notes notes;
    EXPECT_DOUBLE_EQ(read(text, "it", {.stress_unit = "Pa"}, notes).cases[0].tensors[0][0], 20);
    EXPECT_DOUBLE_EQ(read(text, "it", {.stress_unit = "MPa"}, notes).cases[0].tensors[0][0], 2e7);
    // a few peaks, as at sharp corners, say nothing
    EXPECT_EQ(csv("0 0 0 1e9 0 0\n1 0 0 1 0 0\n2 0 0 1 0 0\n").points.size(), 3U);
}

TEST(Csv, HalfATensorBesideAVectorIsNoTensor) {
    const auto s = csv("x,y,z,s11,s1x,s1y,s1z\n1,2,3,9,0,0,5\n");
    EXPECT_TRUE(s.cases[0].tensors.empty());
    EXPECT_EQ(s.cases[0].directions[0], (Vec3{0, 0, 5}));
}

TEST(Csv, FaultsAreNamed) {
    EXPECT_TRUE(
        has(csv_fault("a,b,c,x,y,z,s1x,s1y,s1z\n1,2,3,4,5,6\n", Exit::bad_input), "has 6 columns, the header 9"));
    EXPECT_TRUE(has(csv_fault("", Exit::truncated), "empty"));
    EXPECT_TRUE(has(csv_fault("solid part\nendsolid\n", Exit::bad_input), "no table"));
    EXPECT_TRUE(has(csv_fault("x,y,z,a,b,c\n1,2,3,4,5,6\n", Exit::bad_input), "--columns"));
    EXPECT_TRUE(has(csv_fault("1,2,3,4,5,6,7,8,9\n", Exit::bad_input), "--columns"));
    EXPECT_TRUE(has(csv_fault("x,y,z,s1x,s1y,s1z\n1,2,3,4,5,6\n1,2,3,4,5\n1,2,3,4,5,6\n", Exit::bad_input),
                    "line 3: it has 5"));
    EXPECT_TRUE(has(csv_fault("x,y,z,s1x,s1y,s1z\n1,2,3,4,5,6\n1,2,3,four,5,6\n1,2,3,4,5,6\n", Exit::bad_input),
                    "line 3: 'four'"));
    EXPECT_TRUE(has(csv_fault("x,y,z,s1x,s1y,s1z\n1,2,3,4,5,6\n1,2,3,4", Exit::truncated), "ends inside line 3"));
    EXPECT_TRUE(has(csv_fault("\x1f\x8b\x08", Exit::truncated), "gzip"));
    EXPECT_TRUE(has(csv_fault("\x1f\x8bnothing of the kind", Exit::bad_input), "gzip"));
}

} // namespace
} // namespace filum::stressfield
