// Closed meshes made by rule, and the same written in every file format, for the tests of mesh and slice.
#pragma once

#include "mesh/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <string>

namespace shapes {

using filum::mesh::Mesh;
using filum::mesh::Triangle;
using filum::mesh::Vec3;

inline Mesh box(Vec3 lo, Vec3 hi) {
    Mesh m;
    for (int i = 0; i < 8; ++i)
        m.vertices.push_back({(i & 1) != 0 ? hi.x : lo.x, (i & 2) != 0 ? hi.y : lo.y, (i & 4) != 0 ? hi.z : lo.z});
    m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return m;
}

inline Mesh torus(double major, double minor, std::uint32_t n, std::uint32_t k) {
    Mesh m;
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < k; ++j) {
            const double u = 2 * std::numbers::pi * i / n, v = 2 * std::numbers::pi * j / k;
            const double r = major + minor * std::cos(v);
            m.vertices.push_back({r * std::cos(u), r * std::sin(u), minor * std::sin(v)});
            const auto at = [&](std::uint32_t a, std::uint32_t b) { return (a % n) * k + b % k; };
            m.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            m.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return m;
}

inline Mesh sphere(double radius, int depth) {
    Mesh m;
    m.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    m.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int d = 0; d < depth; ++d) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
        const auto mid = [&](std::uint32_t a, std::uint32_t b) {
            const auto [it, fresh] =
                middle.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(m.vertices.size()));
            if (fresh) m.vertices.push_back(0.5 * (m.vertices[a] + m.vertices[b]));
            return it->second;
        };
        std::vector<Triangle> finer;
        for (const auto& t : m.triangles) {
            const auto a = mid(t[0], t[1]), b = mid(t[1], t[2]), c = mid(t[2], t[0]);
            finer.insert(finer.end(), {{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}});
        }
        m.triangles = std::move(finer);
    }
    for (Vec3& v : m.vertices) v = radius / norm(v) * v;
    return m;
}

inline Mesh moved(Mesh m, Vec3 by) {
    for (Vec3& v : m.vertices) v = v + by;
    return m;
}

inline Mesh inverted(Mesh m) {
    for (auto& t : m.triangles) std::swap(t[1], t[2]);
    return m;
}

inline Mesh together(Mesh a, const Mesh& b) {
    const auto n = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& t : b.triangles) a.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
    return a;
}

// --- files

template <class T>
void put(std::string& out, T v, bool swap = false) {
    char b[sizeof(T)];
    std::memcpy(b, &v, sizeof(T));
    if (swap) std::reverse(b, b + sizeof(T));
    out.append(b, sizeof(T));
}

inline std::string text(const Vec3& v) {
    char b[120];
    std::snprintf(b, sizeof b, "%.17g %.17g %.17g", v.x, v.y, v.z);
    return b;
}

inline std::string stl_binary(const Mesh& m, std::string head = "made by a test") {
    std::string out = std::move(head);
    out.resize(80, ' ');
    put(out, static_cast<std::uint32_t>(m.triangles.size()));
    for (const auto& t : m.triangles) {
        for (int k = 0; k < 3; ++k) put(out, 0.0F);
        for (const auto v : t) {
            put(out, static_cast<float>(m.vertices[v].x));
            put(out, static_cast<float>(m.vertices[v].y));
            put(out, static_cast<float>(m.vertices[v].z));
        }
        put(out, std::uint16_t{0});
    }
    return out;
}

inline std::string stl_ascii(const Mesh& m, const std::string& eol = "\n") {
    std::string out = "solid some part" + eol;
    for (const auto& t : m.triangles) {
        out += " facet normal 0 0 0" + eol + "  outer loop" + eol;
        for (const auto v : t) out += "   vertex " + text(m.vertices[v]) + eol;
        out += "  endloop" + eol + " endfacet" + eol;
    }
    return out + "endsolid some part" + eol;
}

inline std::string obj(const Mesh& m) {
    std::string out = "# a comment\nmtllib none.mtl\no part\n";
    for (const auto& v : m.vertices) out += "v " + text(v) + "\n";
    out += "vn 0 0 1\nvt 0 0\n";
    for (const auto& t : m.triangles)
        out += "f " + std::to_string(t[0] + 1) + "/1/1 " + std::to_string(t[1] + 1) + "//1 " +
               std::to_string(t[2] + 1) + "\n";
    return out;
}

inline std::string off(const Mesh& m, const std::string& head = "OFF", const std::string& extra = "") {
    std::string out = head + "\n# a comment\n" + std::to_string(m.vertices.size()) + " " +
                      std::to_string(m.triangles.size()) + " 0\n";
    for (const auto& v : m.vertices) out += text(v) + extra + "\n";
    for (const auto& t : m.triangles)
        out += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + " 255 0 0\n";
    return out;
}

enum class Ply { ascii, little, big };

// Vertices as double, with a colour between; faces as uint lists with a quality behind.
inline std::string ply(const Mesh& m, Ply kind) {
    const char* const names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    std::string out = "ply\nformat " + std::string(names[static_cast<int>(kind)]) +
                      " 1.0\ncomment by a test\nelement vertex " + std::to_string(m.vertices.size()) +
                      "\nproperty double x\nproperty double y\nproperty uchar red\nproperty double z\nelement face " +
                      std::to_string(m.triangles.size()) +
                      "\nproperty list uchar uint vertex_indices\nproperty float quality\nend_header\n";
    const bool swap = kind == Ply::big;
    char b[160];
    for (const auto& v : m.vertices) {
        if (kind == Ply::ascii) {
            std::snprintf(b, sizeof b, "%.17g %.17g 7 %.17g\n", v.x, v.y, v.z);
            out += b;
            continue;
        }
        put(out, v.x, swap);
        put(out, v.y, swap);
        put(out, std::uint8_t{7});
        put(out, v.z, swap);
    }
    for (const auto& t : m.triangles) {
        if (kind == Ply::ascii) {
            out += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + " 0.5\n";
            continue;
        }
        put(out, std::uint8_t{3});
        for (const auto v : t) put(out, v, swap);
        put(out, 0.5F, swap);
    }
    return out;
}

inline std::string model_mesh(const Mesh& m) {
    char b[200];
    std::string out = "<mesh><vertices>";
    for (const auto& v : m.vertices) {
        std::snprintf(b, sizeof b, "<vertex x=\"%.17g\" y=\"%.17g\" z=\"%.17g\"/>", v.x, v.y, v.z);
        out += b;
    }
    out += "</vertices><triangles>";
    for (const auto& t : m.triangles) {
        std::snprintf(b, sizeof b, "<triangle v1=\"%u\" v2=\"%u\" v3=\"%u\"/>", t[0], t[1], t[2]);
        out += b;
    }
    return out + "</triangles></mesh>";
}

// A 3MF archive around the text of its model, and of other files by their names; in archive.cpp.
std::string archive(const std::string& model, const std::map<std::string, std::string>& others = {});

inline std::string threemf(const Mesh& m) {
    return archive("<?xml version=\"1.0\"?><model unit=\"millimeter\"><resources><object id=\"1\" type=\"model\">" +
                   model_mesh(m) + "</object></resources><build><item objectid=\"1\"/></build></model>");
}

// An object of an AMF file with one volume; `more` stands in the volume, before its triangles.
inline std::string amf_object(const Mesh& m, const std::string& id, const std::string& attributes = "",
                              const std::string& more = "") {
    char b[200];
    std::string out = "<object id=\"" + id + "\"><mesh><vertices>";
    for (const auto& v : m.vertices) {
        std::snprintf(b, sizeof b, "<vertex><coordinates><x>%.17g</x><y>%.17g</y><z>%.17g</z></coordinates></vertex>\n",
                      v.x, v.y, v.z);
        out += b;
    }
    out += "</vertices><volume" + attributes + ">" + more;
    for (const auto& t : m.triangles) {
        std::snprintf(b, sizeof b, "<triangle><v1>%u</v1><v2>%u</v2><v3>%u</v3></triangle>\n", t[0], t[1], t[2]);
        out += b;
    }
    return out + "</volume></mesh></object>";
}

inline std::string amf(const std::string& content, const std::string& unit = " unit=\"millimeter\"") {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- made by a test -->\n<amf" + unit + ">" + content +
           "</amf>\n";
}

} // namespace shapes
