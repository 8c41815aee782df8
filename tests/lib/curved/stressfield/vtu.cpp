#include "refusal.hpp"
#include "stressfield/read.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <zlib.h>

namespace filum::stressfield {
namespace {

std::string base64(const std::string& bytes) {
    static const char* const kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) out += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63U];
    }
    return out;
}

// How a file is written.
struct Style {
    const char* format = "ascii";
    bool wide = false, big = false, packed = false, raw = false;
};

class Writer {
  public:
    explicit Writer(Style style) : style_(style) {}

    template <class T>
    void array(const std::string& type, const std::string& name, int components, const std::vector<T>& values) {
        text_ += "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
                 std::to_string(components) + "\" format=\"" + style_.format + "\"";
        const bool appended = std::string(style_.format) == "appended";
        if (appended) text_ += " offset=\"" + std::to_string(appended_.size()) + "\"";
        text_ += ">\n";
        if (std::string(style_.format) == "ascii")
            for (const T v : values) text_ += " " + std::to_string(v);
        else
            (appended ? appended_ : text_) += encoded(bytes(values));
        text_ += "\n</DataArray>\n";
    }
    void add(const std::string& text) { text_ += text; }

    std::string file(const std::string& type = "UnstructuredGrid") const {
        std::string out = "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type + "\" version=\"1.0\" byte_order=\"" +
                          (style_.big ? "BigEndian" : "LittleEndian") + "\"";
        if (style_.wide) out += " header_type=\"UInt64\"";
        if (style_.packed) out += " compressor=\"vtkZLibDataCompressor\"";
        out += ">\n<" + type + ">\n" + text_ + "</" + type + ">\n";
        if (!appended_.empty())
            out += std::string("<AppendedData encoding=\"") + (style_.raw ? "raw" : "base64") + "\">\n_" + appended_ +
                   "\n</AppendedData>\n";
        return out + "</VTKFile>\n";
    }

  private:
    template <class T>
    std::string bytes(const std::vector<T>& values) const {
        std::string out;
        for (T v : values) {
            char b[sizeof(T)];
            std::memcpy(b, &v, sizeof(T));
            if (style_.big) std::reverse(b, b + sizeof(T));
            out.append(b, sizeof(T));
        }
        return out;
    }
    std::string counts(const std::vector<std::uint64_t>& values) const {
        if (style_.wide) return bytes(values);
        return bytes(std::vector<std::uint32_t>(values.begin(), values.end()));
    }
    std::string encoded(const std::string& data) const {
        const auto text = [&](const std::string& b) { return style_.raw ? b : base64(b); };
        if (!style_.packed) return text(counts({data.size()}) + data);
        constexpr std::size_t kBlock = 64;                              // small, to have several
        const std::size_t full = data.size() < kBlock ? 32768 : kBlock; // of a single block it says nothing
        std::vector<std::uint64_t> head = {(data.size() + kBlock - 1) / kBlock, full, data.size() % kBlock};
        std::string blocks;
        for (std::size_t at = 0; at < data.size(); at += kBlock) {
            const std::string block = data.substr(at, kBlock);
            uLongf size = compressBound(block.size());
            std::string packed(size, '\0');
            compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(block.data()),
                     block.size());
            blocks += packed.substr(0, size);
            head.push_back(size);
        }
        return text(counts(head)) + text(blocks);
    }

    Style style_;
    std::string text_, appended_;
};

std::vector<double> stress(int points, int components) {
    std::vector<double> out;
    for (int i = 0; i < points * components; ++i) out.push_back(0.25 * i - 3);
    return out;
}

// Two tetrahedra, 5 points.
std::string grid(Style style, int components = 6, const std::string& name = "S_X",
                 const std::string& type = "UnstructuredGrid") {
    Writer w(style);
    w.add("<Piece NumberOfPoints=\"5\" NumberOfCells=\"2\">\n<PointData>\n");
    w.array<float>("Float32", "u", 3, std::vector<float>(15, 1));
    w.array<double>("Float64", name, components, stress(5, components));
    w.array<double>("Float64", "TOSTRAIN", 6, stress(5, 6));
    w.add("</PointData>\n<Points>\n");
    w.array<float>("Float32", "Points", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1.5F});
    w.add("</Points>\n<Cells>\n");
    w.array<std::int64_t>("Int64", "connectivity", 1, {0, 1, 2, 3, 0, 2, 1, 4});
    w.array<std::int32_t>("Int32", "offsets", 1, {4, 8});
    w.array<std::uint8_t>("UInt8", "types", 1, {10, 10});
    w.add("</Cells>\n</Piece>\n");
    return w.file(type);
}

Samples vtu(const std::string& text, const std::string& columns = "", Notes* notes = nullptr) {
    Notes own;
    return read(text, "it", {.columns = columns}, notes != nullptr ? *notes : own);
}

std::string vtu_fault(const std::string& text, Exit exit, const std::string& columns = "") {
    return refusal(exit, text, [&] { vtu(text, columns); });
}

const std::vector<Style> kStyles = {{"ascii"},
                                    {"binary"},
                                    {"binary", true},
                                    {"binary", false, true},
                                    {"binary", false, false, true},
                                    {"binary", true, true, true},
                                    {"appended"},
                                    {"appended", true, false, true},
                                    {"appended", false, false, false, true},
                                    {"appended", true, false, true, true},
                                    {"appended", false, true, true, true}};

TEST(Vtu, AllEncodingsGiveTheSame) {
    for (const Style& style : kStyles) {
        const auto s = vtu(grid(style));
        const std::string what = std::string(style.format) + (style.wide ? " wide" : "") + (style.big ? " big" : "") +
                                 (style.packed ? " packed" : "") + (style.raw ? " raw" : "");
        ASSERT_EQ(s.points.size(), 5U) << what;
        EXPECT_EQ(s.points[4], (Vec3{0, 0, -1.5})) << what;
        ASSERT_EQ(s.elements.size(), 2U) << what;
        EXPECT_EQ(s.elements[1].shape, Shape::tet4) << what;
        EXPECT_EQ(s.nodes, (std::vector<std::uint32_t>{0, 1, 2, 3, 0, 2, 1, 4})) << what;
        ASSERT_EQ(s.cases.size(), 1U) << what; // no displacements, no strains
        EXPECT_EQ(s.cases[0].name, "S_X") << what;
        EXPECT_EQ(s.cases[0].tensors[4], (Tensor{3, 3.25, 3.5, 3.75, 4, 4.25})) << what;
    }
}

TEST(Vtu, NineNumbersAndVectors) {
    const std::string nine = grid({"binary"}, 9, "Stress Tensor");
    EXPECT_TRUE(has(vtu_fault(nine, Exit::bad_input), "not symmetric"));
    Notes notes;
    const auto averaged = read(nine, "it", {.order = "xx,xy,xz,yx,yy,yz,zx,zy,zz"}, notes);
    EXPECT_EQ(averaged.cases[0].name, "Stress-Tensor");
    EXPECT_EQ(averaged.cases[0].tensors[0], (Tensor{-3, -2, -1, -2.5, -1.5, -2}));
    const auto vectors = vtu(grid({"ascii"}, 3, "S1"), "S1");
    EXPECT_EQ(vectors.cases[0].directions[1], (Vec3{-2.25, -2, -1.75}));
    EXPECT_DOUBLE_EQ(vectors.cases[0].principals[1][0], norm(Vec3{-2.25, -2, -1.75}));
    EXPECT_EQ(vtu(grid({"ascii"}), "u,S_X").cases.size(), 2U);
}

TEST(Vtu, PiecesAreOneGrid) {
    std::string text = grid({"ascii"});
    const std::size_t from = text.find("<Piece"), to = text.find("</Unstr");
    const std::string piece = text.substr(from, to - from);
    const auto s = vtu(text.insert(to, piece));
    EXPECT_EQ(s.points.size(), 10U);
    EXPECT_EQ(s.nodes[15], 9U);
    EXPECT_EQ(s.cases[0].tensors.size(), 10U);
    EXPECT_TRUE(has(vtu_fault(text.insert(to, with(piece, "S_X", "S_Y")), Exit::bad_input), "pieces"));
}

TEST(Vtu, CellsOfOtherTypesAreNotedAndPointsRemain) {
    Notes notes;
    const auto s = vtu(with(grid({"ascii"}), " 10 10", " 42 42"), "", &notes);
    EXPECT_TRUE(s.elements.empty());
    EXPECT_EQ(s.points.size(), 5U);
    ASSERT_EQ(notes.size(), 3U); // also strains left out, and an order that is assumed
    EXPECT_EQ(notes[2].count, 2U);
}

TEST(Vtu, AnArrayOfAnyWidthCostsNoMemory) {
    const std::string text = with(grid({"ascii"}), "Name=\"u\" NumberOfComponents=\"3\"",
                                  "Name=\"u\" NumberOfComponents=\"4000000000\" ComponentName0=\"XX\"");
    EXPECT_EQ(vtu(text).cases.size(), 1U);
}

TEST(Vtu, FaultsAreNamed) {
    const std::string ascii = grid({"ascii"}), binary = grid({"binary"}), packed = grid({"binary", false, false, true});
    EXPECT_TRUE(has(vtu_fault(grid({"ascii"}, 6, "S_X", "PolyData"), Exit::bad_input), "PolyData"));
    EXPECT_TRUE(has(vtu_fault(with(packed, "vtkZLibDataCompressor", "vtkLZ4DataCompressor"), Exit::bad_input), "LZ4"));
    EXPECT_TRUE(has(vtu_fault(with(ascii, " 0.000000 -1.500000", " 0.000000"), Exit::bad_input), "14 numbers, not 15"));
    EXPECT_TRUE(has(vtu_fault(with(ascii, " 0.000000 -1.500000", " 0.000000 down"), Exit::bad_input), "no number"));
    EXPECT_TRUE(has(vtu_fault(with(ascii, " 0.000000 -1.500000", " 0.000000 nan"), Exit::bad_input), "finite"));
    EXPECT_TRUE(has(vtu_fault(with(ascii, " 0 2 1 4", " 0 2 1 5"), Exit::bad_input), "no point"));
    EXPECT_TRUE(has(vtu_fault(with(ascii, " 4 8", " 4 9"), Exit::bad_input), "offsets"));
    EXPECT_TRUE(has(vtu_fault(with(ascii, " 10 10", " 10 24"), Exit::bad_input), "type 24 has 4 nodes"));
    EXPECT_TRUE(has(vtu_fault(with(ascii, "S_X", "strain"), Exit::bad_input), "6 or 9"));
    EXPECT_TRUE(has(vtu_fault(with(with(with(ascii, "<PointData>", "<CellData>"), "</PointData>", "</CellData>"),
                                   "<Points>", "<PointData/><Points>"),
                              Exit::bad_input),
                    "cells"));
    EXPECT_TRUE(has(vtu_fault(ascii, Exit::usage, "S_Z"), "'S_X'"));
    EXPECT_TRUE(has(vtu_fault(with(ascii, "</PointData>", ""), Exit::bad_input), "XML"));
    EXPECT_TRUE(has(vtu_fault("# vtk DataFile Version 3.0\n", Exit::bad_input), ".vtu"));
    const std::size_t data = binary.find("Name=\"S_X\"");
    const std::size_t begin = binary.find(">\n", data) + 2, end = binary.find("\n<", begin);
    EXPECT_TRUE(has(vtu_fault(std::string(binary).erase(begin + 40, end - begin - 40), Exit::truncated), "'S_X'"));
    EXPECT_TRUE(has(vtu_fault(std::string(binary).replace(begin + 40, 1, "*"), Exit::bad_input), "base64"));
    const std::size_t there = packed.find(">\n", packed.find("Name=\"S_X\"")) + 2;
    EXPECT_TRUE(has(vtu_fault(std::string(packed).replace(there + 60, 8, "AAAAAAAA"), Exit::bad_input), "zlib"));
}

TEST(Vtu, EveryCutIsSeen) {
    for (const Style& style : {Style{"ascii"}, Style{"appended", true, false, true, true}}) {
        const std::string whole = grid(style);
        for (std::size_t size = 20; size + 12 < whole.size(); size += 7)
            EXPECT_TRUE(has(vtu_fault(whole.substr(0, size), Exit::truncated), "ends")) << size;
    }
}

} // namespace
} // namespace filum::stressfield
