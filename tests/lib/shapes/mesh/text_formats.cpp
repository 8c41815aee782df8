// Text as other programs write it: line ends of any kind, words behind the end of a line, a keyword on a number.
#include "base/error.hpp"
#include "mesh/read.hpp"

#include <algorithm>
#include <cctype>
#include <gtest/gtest.h>

using namespace filum;

namespace text_formats {

std::string with_ends(std::string text, const std::string& end) {
    std::string out;
    for (const char c : text)
        if (c == '\n')
            out += end;
        else
            out += c;
    return out;
}

const std::string kStl =
    "solid a part\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n"
    "  endloop\n endfacet\nendsolid a part\n";
const std::string kObj = "# a part\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 \\\n 3//1\n";
const std::string kPly = "ply\nformat ascii 1.0\ncomment a part\nelement vertex 3\nproperty float x\nproperty float y\n"
                         "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                         "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string kOff = "OFF\n# a part\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

void expect_triangle(const std::string& text, const std::string& name, std::size_t notes = 0) {
    const mesh::File file = mesh::read(text, name);
    EXPECT_EQ(file.notes.size(), notes) << name;
    ASSERT_EQ(file.mesh.triangles.size(), 1U) << name;
    EXPECT_EQ(file.mesh.vertices[1], (geom::Vec3{1, 0, 0})) << name;
}

} // namespace text_formats

TEST(TextFormats, LinesEndInAnyWay) {
    using namespace text_formats;
    for (const std::string end : {"\n", "\r\n", "\r"})
        for (const auto& [name, text] : {std::pair{"stl", kStl}, {"obj", kObj}, {"ply", kPly}, {"off", kOff}})
            expect_triangle(with_ends(text, end), name);
}

TEST(TextFormats, LinesAreCountedInAnyWay) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        try {
            mesh::read(text_formats::with_ends("v 0 0 0\nv 1 0\n", end), "it");
            ADD_FAILURE();
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find("line 2"), std::string::npos) << e.what();
        }
    }
}

TEST(TextFormats, BinaryPlyMayBeginWithALineEndOfItsOwn) {
    // The first byte of the data is an LF.
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        std::string text = text_formats::with_ends(
            "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty uchar x\nproperty uchar y\n"
            "property uchar z\nelement face 1\nproperty list uchar uchar vertex_indices\nend_header\n",
            end);
        const char data[] = {10, 0, 0, 1, 0, 0, 0, 1, 0, 3, 0, 1, 2};
        text.append(data, sizeof data);
        const mesh::File file = mesh::read(text, "it");
        EXPECT_TRUE(file.notes.empty());
        EXPECT_EQ(file.mesh.vertices[0], (geom::Vec3{10, 0, 0}));
    }
}

TEST(TextFormats, WordsBehindTheEndOfAnStlLineArePassedOver) {
    std::string text = text_formats::kStl;
    text.replace(text.find("endfacet"), 8, "endfacet of color 7");
    text_formats::expect_triangle(text, "behind endfacet", 1);
    text = text_formats::kStl;
    text.replace(text.find("endloop"), 7, "endloop 3");
    text_formats::expect_triangle(text, "behind endloop", 1);
    text = text_formats::kStl;
    text.replace(text.find("endfacet"), 8, "end facet");
    EXPECT_THROW(mesh::read(text, "it"), Error);
    std::string line = text_formats::with_ends(text_formats::kStl.substr(13), " "); // all on one line
    text_formats::expect_triangle("solid\n" + line, "one line");
}

TEST(TextFormats, AnStlMayStandOnOneLine) {
    using namespace text_formats;
    for (const std::string head : {"", "solid", "solid a part", "solid part #3", "SOLID facet", "solid normal facet"})
        for (const std::string tail : {"endsolid", "endsolid a part", "ENDSOLID part #3\n", "endsolid\n\n"})
            for (const std::string blank : {" ", "  ", "\t"}) {
                std::string facets = kStl.substr(14, kStl.find("endsolid") - 14);
                if (head.starts_with("SOLID"))
                    std::transform(facets.begin(), facets.end(), facets.begin(),
                                   [](char c) { return static_cast<char>(std::toupper(c)); });
                const std::string line = with_ends(head + "\n" + facets + tail, blank);
                expect_triangle(line, line);
                const mesh::File twice = mesh::read(line + blank + line, line);
                EXPECT_EQ(twice.mesh.triangles.size(), 2U) << line;
            }
}

TEST(TextFormats, AnOffKeywordMayStandOnItsFirstNumber) {
    for (const std::string head : {"OFF3 1 0\n", "OFF 3 1 0\n", "OFF\n3 1 0\n"})
        text_formats::expect_triangle(head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", head);
    text_formats::expect_triangle("COFF3 1 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n3 0 1 2\n", "COFF3");
    EXPECT_THROW(mesh::read("OFFSET 3\n", "it"), Error);
    text_formats::expect_triangle("off\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "off");
    EXPECT_THROW(mesh::read("offset 3\n", "it"), Error);
}

TEST(TextFormats, PaddingBehindTheTextIsNoPartOfIt) {
    const std::string facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    for (const std::string& text :
         std::vector<std::string>{"solid a\n" + facet + "endsolid a\n", "\xef\xbb\xbfsolid a\n" + facet + "endsolid\n",
                                  "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", text_formats::kOff})
        for (const std::string& padding :
             {std::string("\x1a"), std::string(1, '\0'), std::string(600, '\0'), std::string("\x1a\0\0", 3)})
            text_formats::expect_triangle(text + padding, text + " padded");
}

TEST(TextFormats, AVertexOfAnObjMayGoOnOnTheNextLine) {
    text_formats::expect_triangle("v 0 \\\n0 0\nv 1 0\\\r\n 0\nv 0 1 0\nf 1 \\\n2 3\n", "continued");
}
