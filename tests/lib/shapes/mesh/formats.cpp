// Every format gives back the mesh that was written; variants; what is no mesh.
#include "base/error.hpp"
#include "mesh/place.hpp"
#include "mesh/read.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

using namespace filum;
using namespace filum::mesh;

namespace {

Exit exit_of(const std::string& bytes) {
    try {
        read(bytes, "it");
    } catch (const Error& e) {
        return e.exit();
    }
    return Exit::ok;
}

std::string what_of(const std::string& bytes) {
    try {
        read(bytes, "it");
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

// Through memory: g++ 12 -O2 drops double -> float -> double where it vectorises.
double as_float(double v) {
    const volatile float f = static_cast<float>(v);
    return f;
}

// Coordinates that a float holds exactly, so that every format can carry them.
Mesh sample(int which) {
    Mesh m = which == 0   ? shapes::box({-3, 1, 0}, {4, 2.5, 8})
             : which == 1 ? shapes::sphere(7, 3)
                          : shapes::torus(9, 2, 40, 17);
    for (Vec3& v : m.vertices) v = {as_float(v.x), as_float(v.y), as_float(v.z)};
    return m;
}

struct Written {
    Kind kind;
    std::string bytes;
};
std::vector<Written> all_formats(const Mesh& m) {
    return {{Kind::stl_binary, shapes::stl_binary(m)},
            {Kind::stl_binary, shapes::stl_binary(m, "solid looks like text facet normal")},
            {Kind::stl_ascii, shapes::stl_ascii(m)},
            {Kind::stl_ascii, "\xef\xbb\xbf \r\n" + shapes::stl_ascii(m, "\r\n")},
            {Kind::obj, shapes::obj(m)},
            {Kind::off, shapes::off(m)},
            {Kind::off, shapes::off(m, "COFF", " 0.5 0.5 0.5 1")},
            {Kind::off, shapes::off(m, "NOFF", " 0 0 1")},
            {Kind::ply, shapes::ply(m, shapes::Ply::ascii)},
            {Kind::ply, shapes::ply(m, shapes::Ply::little)},
            {Kind::ply, shapes::ply(m, shapes::Ply::big)},
            {Kind::amf, shapes::amf(shapes::amf_object(m, "1"))},
            {Kind::threemf, shapes::threemf(m)}};
}

} // namespace

TEST(Formats, AllGiveBackWhatWasWritten) {
    for (int which = 0; which < 3; ++which) {
        const Mesh m = sample(which);
        for (const auto& [kind, bytes] : all_formats(m)) {
            SCOPED_TRACE(static_cast<int>(kind));
            const File f = read(bytes, "it");
            EXPECT_EQ(f.kind, kind);
            EXPECT_TRUE(f.notes.empty());
            EXPECT_EQ(f.mesh.vertices.size(), m.vertices.size());
            ASSERT_EQ(f.mesh.triangles.size(), m.triangles.size());
            for (std::size_t t = 0; t < m.triangles.size(); ++t)
                for (std::size_t k = 0; k < 3; ++k)
                    ASSERT_EQ(f.mesh.vertices[f.mesh.triangles[t][k]], m.vertices[m.triangles[t][k]]);
        }
    }
}

TEST(Formats, MinusZeroWeldsWithZero) {
    Mesh m = shapes::box({0, 0, 0}, {1, 1, 1});
    std::string bytes = shapes::stl_binary(m);
    for (std::size_t t = 0; t < m.triangles.size(); t += 2)
        for (std::size_t k = 0; k < 9; ++k) {
            float v = 0;
            char* at = bytes.data() + 84 + 50 * t + 12 + 4 * k;
            std::memcpy(&v, at, 4);
            v = v == 0 ? -0.0F : v;
            std::memcpy(at, &v, 4);
        }
    EXPECT_EQ(read(bytes, "it").mesh.vertices.size(), 8U);
}

TEST(Formats, AnStlThatCountsFewerTrianglesThanItHoldsIsRefused) {
    const std::string whole = shapes::stl_binary(shapes::sphere(5, 2));
    std::uint32_t held = 0;
    std::memcpy(&held, whole.data() + 80, 4);
    for (const std::uint32_t count : {0U, 1U, held / 2, held - 1}) {
        std::string bytes = whole;
        std::memcpy(bytes.data() + 80, &count, 4);
        const std::string why = "announces " + std::to_string(count) + " triangles and holds " + std::to_string(held);
        try {
            read(bytes, "it");
            ADD_FAILURE() << count;
        } catch (const Error& e) {
            EXPECT_EQ(e.exit(), Exit::bad_input);
            EXPECT_NE(std::string(e.what()).find(why), std::string::npos) << e.what();
        }
    }
    EXPECT_EQ(read(whole + std::string(100, '\0'), "it").mesh.triangles.size(), held); // padding
    EXPECT_EQ(read(whole + whole, "it").mesh.triangles.size(), 2 * held);              // a second mesh
}

TEST(Obj, PolygonsNegativeIndicesAndContinuedLines) {
    const File f = read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                        "f 4 3 2 1\nf -4/7 -3//8 \\\n -2 -1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nl 1 2\n",
                        "it");
    EXPECT_EQ(f.mesh.triangles.size(), 12U);
    EXPECT_NEAR(volume(f.mesh), 1, 1e-12);
}

TEST(Obj, AConcavePolygonHasTheRightVolume) {
    std::string text; // an L, extruded by 2
    const double xy[6][2] = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    for (const int z : {0, 2})
        for (const auto& p : xy)
            text += "v " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(z) + "\n";
    text += "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\n";
    for (int k = 1; k <= 6; ++k) {
        const int n = k % 6 + 1;
        text += "f " + std::to_string(k) + " " + std::to_string(n) + " " + std::to_string(n + 6) + " " +
                std::to_string(k + 6) + "\n";
    }
    EXPECT_NEAR(volume(read(text, "it").mesh), 10, 1e-9);
}

TEST(Obj, FaultsAreNamedWithTheirLine) {
    EXPECT_EQ(exit_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"), Exit::bad_input);
    EXPECT_EQ(exit_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n"), Exit::bad_input);
    EXPECT_EQ(exit_of("v 0 0\n"), Exit::bad_input);
    try {
        read("v 0 0 0\nv 1 x 0\n", "'a.obj'");
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("'a.obj': line 2"), std::string::npos) << e.what();
    }
}

TEST(Ply, OtherElementsArePassedOver) {
    const std::string text = "ply\r\nformat ascii 1.0\r\nelement camera 1\r\nproperty float f\r\nproperty list uchar "
                             "int l\r\nelement vertex "
                             "3\r\nproperty float z\r\nproperty float y\r\nproperty float x\r\nelement face "
                             "1\r\nproperty uchar c\r\nproperty list "
                             "uchar int vertex_index\r\nelement edge 1\r\nproperty int a\r\nend_header\r\n1.5 2 4 "
                             "5\r\n3 0 0\r\n0 1 0\r\n0 0 1\r\n9 3 0 1 2\r\n1\r\n";
    const Mesh m = read(text, "it").mesh;
    ASSERT_EQ(m.triangles.size(), 1U);
    EXPECT_EQ(m.vertices[m.triangles[0][0]], (Vec3{0, 0, 3}));
    EXPECT_EQ(m.vertices[m.triangles[0][2]], (Vec3{1, 0, 0}));
}

TEST(ThreeMf, UnitsComponentsAndTransforms) {
    const std::string unit_box = shapes::model_mesh(shapes::box({0, 0, 0}, {1, 1, 1}));
    const std::string model =
        "<model unit=\"inch\"><resources><object id=\"1\">" + unit_box +
        "</object><object id=\"2\"><components><component objectid=\"1\"/>"
        "<component objectid=\"1\" transform=\"-2 0 0 0 1 0 0 0 1 10 0 0\"/></components></object></resources>"
        "<build><item objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 0 0 5\"/>"
        "<item objectid=\"1\" printable=\"0\"/></build></model>";
    const File f = read(shapes::archive(model), "it");
    EXPECT_EQ(f.mesh.triangles.size(), 24U);
    EXPECT_EQ(f.notes.size(), 1U);                             // the item that is not to be printed
    EXPECT_NEAR(volume(f.mesh), 3 * 25.4 * 25.4 * 25.4, 1e-6); // the mirrored one faces outwards, too
    const Box3 b = bounds(f.mesh);
    EXPECT_NEAR(b.lo.x, -25.4, 1e-9);
    EXPECT_NEAR(b.hi.y, 254, 1e-9);
    EXPECT_NEAR(b.lo.z, 127, 1e-9);
}

// PrusaSlicer puts all bodies of an object in one mesh, and says which triangles are whose.
TEST(ThreeMf, ModifiersOfPrusaslicerAreNoMaterial) {
    Mesh both = shapes::box({0, 0, 0}, {10, 10, 10});
    const Mesh body = shapes::box({2, 2, 2}, {5, 5, 15});
    for (const auto& t : body.triangles) both.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
    both.vertices.insert(both.vertices.end(), body.vertices.begin(), body.vertices.end());
    const auto of = [&](const std::string& type) {
        const std::string config = "<config><object id=\"1\"><volume firstid=\"0\" lastid=\"11\"><metadata "
                                   "type=\"volume\" key=\"volume_type\" value=\"ModelPart\"/></volume><volume "
                                   "firstid=\"12\" lastid=\"23\"><metadata type=\"volume\" key=\"volume_type\" "
                                   "value=\"" +
                                   type + "\"/></volume></object></config>";
        return read(shapes::archive("<model><resources><object id=\"1\">" + shapes::model_mesh(both) +
                                        "</object></resources><build><item objectid=\"1\"/></build></model>",
                                    {{"Metadata/Slic3r_PE_model.config", config}}),
                    "it");
    };
    EXPECT_EQ(of("ModelPart").mesh.triangles.size(), 24U);
    EXPECT_TRUE(of("ModelPart").notes.empty());
    for (const char* type : {"ParameterModifier", "SupportEnforcer", "SupportBlocker", "NegativeVolume"}) {
        const File f = of(type);
        EXPECT_NEAR(volume(f.mesh), 1000, 1e-9) << type;
        ASSERT_EQ(f.bodies.size(), 1U) << type;
        if (f.bodies[0].what == Body::Purpose::negative) continue; // who cuts it away, or cannot, notes that
        ASSERT_EQ(f.notes.size(), 1U) << type;
        EXPECT_EQ(f.notes[0].count, 1U);
    }
    EXPECT_EQ(
        exit_of(shapes::archive("<model><resources/><build/></model>", {{"Metadata/Slic3r_PE_model.config", "<a"}})),
        Exit::bad_input);
}

// Bambu Studio and OrcaSlicer give each body an object of its own.
TEST(ThreeMf, ModifiersOfBambuStudioAreNoMaterial) {
    const std::string model =
        "<model><resources><object id=\"1\">" + shapes::model_mesh(shapes::box({0, 0, 0}, {10, 10, 10})) +
        "</object><object id=\"2\">" + shapes::model_mesh(shapes::box({2, 2, 2}, {5, 5, 15})) +
        "</object><object id=\"3\"><components><component objectid=\"1\"/><component objectid=\"2\"/></components>"
        "</object></resources><build><item objectid=\"3\"/></build></model>";
    const std::string config = "<config><object id=\"3\"><part id=\"1\" subtype=\"normal_part\"/><part id=\"2\" "
                               "subtype=\"modifier_part\"/></object></config>";
    EXPECT_EQ(read(shapes::archive(model), "it").mesh.triangles.size(), 24U);
    const File f = read(shapes::archive(model, {{"Metadata/model_settings.config", config}}), "it");
    EXPECT_NEAR(volume(f.mesh), 1000, 1e-9);
    ASSERT_EQ(f.notes.size(), 1U);
}

TEST(ThreeMf, CirclesAndTooManyCopiesEnd) {
    EXPECT_EQ(exit_of(shapes::archive("<model><resources><object id=\"1\"><components><component "
                                      "objectid=\"1\"/></components></object></resources>"
                                      "<build><item objectid=\"1\"/></build></model>")),
              Exit::bad_input);
    const auto nested = [](int copies, bool apart) {
        std::string out =
            "<model><resources><object id=\"0\">" + shapes::model_mesh(shapes::box({0, 0, 0}, {1, 1, 1})) + "</object>";
        for (int i = 1; i <= copies; ++i) // 2^copies boxes
            out += "<object id=\"" + std::to_string(i) + "\"><components><component objectid=\"" +
                   std::to_string(i - 1) + "\"/><component objectid=\"" + std::to_string(i - 1) + "\"" +
                   (apart ? " transform=\"1 0 0 0 1 0 0 0 1 " + std::to_string(1 << i) + " 0 0\"" : "") +
                   "/></components></object>";
        return shapes::archive(out + "</resources><build><item objectid=\"" + std::to_string(copies) +
                               "\"/></build></model>");
    };
    EXPECT_EQ(exit_of(nested(22, true)), Exit::bad_input);
    const File same = read(nested(22, false), "it"); // all in one place
    EXPECT_EQ(same.mesh.triangles.size(), 12U);
    ASSERT_EQ(same.notes.size(), 1U);
    EXPECT_EQ(same.notes[0].count, 22U);
    EXPECT_EQ(exit_of("PK\x03\x04 no zip at all, but long enough for one to be looked for in here"), Exit::bad_input);
}

TEST(Read, ASizeThatIsNotThereIsNeverAllocated) {
    std::string stl = shapes::stl_binary(shapes::box({0, 0, 0}, {1, 1, 1}));
    const std::uint32_t many = 100000000;
    std::memcpy(stl.data() + 80, &many, 4);
    EXPECT_NE(exit_of(stl), Exit::ok);
    EXPECT_EQ(exit_of("OFF\n4000000000 1 0\n0 0 0\n"), Exit::truncated);
    EXPECT_EQ(exit_of("OFF\n99999999999999999999 1 0\n0 0 0\n"), Exit::bad_input);
    const std::string body = "property float x\nproperty float y\nproperty float z\n";
    for (const std::string format : {"ascii", "binary_little_endian"})
        EXPECT_EQ(exit_of("ply\nformat " + format + " 1.0\nelement vertex 9000000000000000000\n" + body +
                          "end_header\n0 0 0\n"),
                  Exit::truncated);
    EXPECT_EQ(exit_of("ply\nformat binary_little_endian 1.0\nelement vertex 9000000000000000000\nend_header\n"),
              Exit::bad_input);
    EXPECT_EQ(exit_of("ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uint uint "
                      "vertex_indices\nend_header\n\xff\xff\xff\xff"),
              Exit::truncated);
}

TEST(Read, CornersThatAreNoNumberAreLeftOutAndSaid) {
    Mesh m = shapes::sphere(5, 2);
    m.vertices[7].y = std::nan("");
    m.vertices[9].x = INFINITY;
    for (const auto& bytes :
         {shapes::stl_binary(m), shapes::stl_ascii(m), shapes::obj(m), shapes::ply(m, shapes::Ply::little)}) {
        const File f = read(bytes, "it");
        std::size_t lost = 0;
        for (const auto& t : m.triangles)
            for (const auto v : t)
                if (v == 7 || v == 9) {
                    ++lost;
                    break;
                }
        EXPECT_EQ(f.mesh.triangles.size(), m.triangles.size() - lost);
        ASSERT_EQ(f.notes.size(), 1U);
        EXPECT_EQ(f.notes[0].count, lost);
        for (const Vec3& v : f.mesh.vertices)
            EXPECT_TRUE(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z));
    }
}

TEST(ThreeMf, WhatWouldUnfoldToTooMuchIsRefusedBeforeItIsMade) {
    std::string model = "<model><resources><object id=\"0\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex "
                        "x=\"1\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"1\" z=\"2\"/></vertices><triangles>";
    for (int t = 0; t < 1000; ++t) model += "<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>";
    model += "</triangles></mesh></object></resources><build>";
    for (int i = 0; i < 17000; ++i)
        model += "<item objectid=\"0\" transform=\"1 0 0 0 1 0 0 0 1 " + std::to_string(i) + " 0 0\"/>";
    EXPECT_NE(what_of(shapes::archive(model + "</build></model>")).find("17000000 triangles"), std::string::npos);
}

TEST(Read, SeveralStlFilesInOneAreReadOrRefused) {
    const Mesh m = shapes::box({0, 0, 0}, {1, 2, 3}), n = shapes::box({5, 0, 0}, {6, 2, 3});
    const auto binary = [](const Mesh& mesh) { return shapes::stl_binary(mesh); };
    const auto ascii = [](const Mesh& mesh) { return shapes::stl_ascii(mesh); };
    const File both = read(binary(m) + binary(n), "it");
    EXPECT_NEAR(volume(both.mesh), 12, 1e-6);
    ASSERT_EQ(both.notes.size(), 1U);
    EXPECT_EQ(both.notes[0].amount, 12);
    EXPECT_NEAR(volume(read(binary(m) + binary(n) + binary(shapes::moved(m, {20, 0, 0})), "it").mesh), 18, 1e-6);
    EXPECT_NEAR(volume(read(ascii(m) + ascii(n), "it").mesh), 12, 1e-6);
    EXPECT_NE(what_of(binary(m) + ascii(n)).find("give the files one by one"), std::string::npos);
    EXPECT_NE(what_of(ascii(m) + binary(n)), "");
    for (const auto& [kind, one] : all_formats(m)) {
        if (kind != Kind::ply && kind != Kind::off && kind != Kind::obj) continue;
        EXPECT_EQ(read(one, "it").notes.size(), 0U) << one.substr(0, 30);
        EXPECT_GE(read(one + one, "it").notes.size(), 1U) << one.substr(0, 30);
    }
}

TEST(Read, ForeignFilesAreNamed) {
    const std::string stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                            "endloop\nendfacet\nendsolid\n";
    std::string wide = "\xff\xfe", big;
    for (const char c : stl) {
        wide += std::string{c, '\0'};
        big += std::string{'\0', c};
    }
    const std::pair<std::string, const char*> kinds[] = {{wide, "UTF-16"},
                                                         {big, "UTF-16"},
                                                         {"glTF" + std::string(300, '\2'), "GLB"},
                                                         {"; made by hand\n" + stl, "1 line before 'solid'"},
                                                         {"// made\n// by hand\n" + stl, "2 lines before 'solid'"},
                                                         {"<?xml version=\"1.0\"?>\n<amf unit=\"mm\">", "AMF"},
                                                         {"{\"asset\": {\"version\": \"2.0\"}}", "glTF"},
                                                         {"\x1f\x8b\x08" + std::string(300, '\1'), "gzip"},
                                                         {"GCDE" + std::string(300, '\1'), "binary G-code"},
                                                         {"PK\x05\x06" + std::string(18, '\0'), "holds no mesh"},
                                                         {"ISO-10303-21;\n", "STEP"}};
    for (const auto& [bytes, name] : kinds) EXPECT_NE(what_of(bytes).find(name), std::string::npos) << what_of(bytes);
    EXPECT_EQ(read("# made by hand\n" + stl, "it").mesh.triangles.size(), 1U);
}

TEST(Read, WhatIsNoMesh) {
    EXPECT_EQ(exit_of(""), Exit::truncated);
    EXPECT_EQ(exit_of("hello\n"), Exit::bad_input);
    EXPECT_EQ(exit_of(std::string(500, '\0')), Exit::bad_input);
    EXPECT_EQ(exit_of("solid empty\nendsolid empty\n"), Exit::bad_input);
    EXPECT_EQ(exit_of("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"), Exit::truncated);
    EXPECT_EQ(exit_of("OFF BINARY\n"), Exit::bad_input);
    EXPECT_EQ(exit_of("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), Exit::bad_input);
    EXPECT_EQ(exit_of("v 0 0 0\nv 0 0 0\nv 1 0 0\nf 1 2 3\n"), Exit::bad_input); // no area
    EXPECT_EQ(exit_of(std::string("\x0e\x09\x00\x89\x46\x69lum\n", 10) + "\x15" + std::string(4, '\1')),
              Exit::bad_input);
}

// Cut anywhere, a binary file says that it was cut; a text either does or is a mesh with less in it.
TEST(Read, CutAnywhere) {
    const Mesh m = sample(0);
    for (const auto& [kind, bytes] : all_formats(m))
        for (std::size_t n = 0; n < bytes.size(); n += 1 + n / 97) {
            const std::string part = bytes.substr(0, n);
            const Exit exit = exit_of(part);
            const bool binary = kind == Kind::stl_binary || kind == Kind::threemf;
            if (binary) {
                ASSERT_NE(exit, Exit::ok) << static_cast<int>(kind) << " cut after " << n;
            }
            ASSERT_TRUE(exit == Exit::ok || exit == Exit::bad_input || exit == Exit::truncated);
        }
}

// Flipped bytes give an error or a mesh that keeps its promises.
TEST(Read, FlippedBytes) {
    std::uint64_t state = 1;
    const auto random = [&] { return (state = state * 6364136223846793005ULL + 1442695040888963407ULL) >> 33; };
    for (const auto& [kind, bytes] : all_formats(sample(0)))
        for (int round = 0; round < 200; ++round) {
            std::string broken = bytes;
            for (std::uint64_t k = 1 + random() % 4; k > 0; --k)
                broken[random() % broken.size()] = static_cast<char>(random());
            try {
                const File f = read(broken, "it");
                for (const auto& t : f.mesh.triangles)
                    for (const auto v : t) ASSERT_LT(v, f.mesh.vertices.size());
                for (const Vec3& v : f.mesh.vertices)
                    ASSERT_TRUE(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z));
            } catch (const Error& e) {
                ASSERT_TRUE(e.exit() == Exit::bad_input || e.exit() == Exit::truncated);
            }
        }
}
