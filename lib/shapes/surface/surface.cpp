#include "surface/surface.hpp"

#include "base/error.hpp"
#include "mesh/holes.hpp"
#include "surface/defects.hpp"

#include <algorithm>
#include <map>

namespace filum::surface {

namespace {

void number_components(Surface& s) {
    s.component.assign(s.triangles.size(), kNone);
    std::vector<std::uint32_t> pending;
    for (std::uint32_t first = 0; first < s.triangles.size(); ++first) {
        if (s.component[first] != kNone) continue;
        s.component[first] = s.components;
        pending.assign(1, first);
        while (!pending.empty()) {
            const std::uint32_t t = pending.back();
            pending.pop_back();
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t other = s.twin[3 * t + k];
                if (other == kNone || s.component[other / 3] != kNone) continue;
                s.component[other / 3] = s.components;
                pending.push_back(other / 3);
            }
        }
        ++s.components;
    }
}

void find_outgoing(Surface& s) {
    s.outgoing.assign(s.vertices.size(), kNone);
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        std::uint32_t& out = s.outgoing[s.tail(h)];
        if (out == kNone || s.twin[h] == kNone) out = h;
    }
}

// The area enclosed by the rim, as the length of its vector area.
double spanned_area(const Surface& s, const Rim& rim) {
    Vec3 sum;
    const Vec3 origin = s.vertices[s.tail(rim.sides.front())];
    for (const std::uint32_t h : rim.sides)
        sum = sum + cross(s.vertices[s.tail(h)] - origin, s.vertices[s.head(h)] - origin);
    return norm(sum) / 2;
}

void find_rims(Surface& s) {
    std::vector<char> seen(s.twin.size(), 0);
    for (std::uint32_t first = 0; first < s.twin.size(); ++first) {
        if (s.twin[first] != kNone || seen[first] != 0) continue;
        Rim rim;
        rim.component = s.component[first / 3];
        for (std::uint32_t h = first; seen[h] == 0; h = s.outgoing[s.head(h)]) {
            seen[h] = 1;
            rim.sides.push_back(h);
        }
        s.rims.push_back(std::move(rim));
    }
    std::vector<double> widest(s.components, -1);
    std::vector<std::size_t> outer(s.components, s.rims.size());
    for (std::size_t i = 0; i < s.rims.size(); ++i) {
        const double a = spanned_area(s, s.rims[i]);
        if (a > widest[s.rims[i].component]) {
            widest[s.rims[i].component] = a;
            outer[s.rims[i].component] = i;
        }
    }
    for (const std::size_t i : outer)
        if (i < s.rims.size()) s.rims[i].outer = true;
}

void check(const Surface& s) {
    const auto bad = [](const char* why) { throw Error(Exit::bad_input, why); };
    if (s.triangles.empty()) bad("it has no triangles");
    if (s.triangles.size() >= (std::size_t{1} << 30)) bad("it has too many triangles");
    if (s.twin.size() != 3 * s.triangles.size()) bad("the number of half-edges is not three times that of triangles");
    for (const auto& [a, b, c] : s.triangles) {
        if (std::max({a, b, c}) >= s.vertices.size()) bad("a corner is not a vertex");
        if (a == b || b == c || c == a) bad("a triangle has two equal corners");
    }
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        const std::uint32_t t = s.twin[h];
        if (t == kNone) continue;
        if (t >= s.twin.size() || s.twin[t] != h || s.tail(t) != s.head(h) || s.head(t) != s.tail(h))
            bad("joined half-edges do not belong to the same edge");
    }
}

// Checks that every half-edge is in the fan of its tail, so that each vertex has exactly one fan.
void check_fans(const Surface& s) {
    std::size_t seen = 0;
    for (std::uint32_t v = 0; v < s.vertices.size(); ++v) {
        if (s.outgoing[v] == kNone) throw Error(Exit::bad_input, "a vertex has no triangle");
        each_outgoing(s, v, [&](std::uint32_t) { ++seen; });
    }
    if (seen != s.twin.size()) throw Error(Exit::bad_input, "a vertex has more than one fan of triangles");
}

} // namespace

Surface assemble(std::vector<Vec3> vertices, std::vector<Triangle> triangles, std::vector<std::uint32_t> twin) {
    Surface s;
    s.vertices = std::move(vertices);
    s.triangles = std::move(triangles);
    s.twin = std::move(twin);
    check(s);
    find_outgoing(s);
    check_fans(s);
    number_components(s);
    find_rims(s);
    return s;
}

Surface connect(mesh::Mesh mesh, Notes& notes, std::vector<std::uint32_t>* faces, std::vector<std::uint32_t>* of_file) {
    remove_copies(mesh, notes);
    remove_flat(mesh, notes);
    if (mesh.triangles.empty())
        throw Error(Exit::bad_input, "cannot use the surface: none of its triangles has an area");
    mesh::face_one_way(mesh, false, notes);
    std::vector<std::uint32_t> twin = join_sides(mesh, notes);
    split_fans(mesh, twin, notes);
    if (faces != nullptr) *faces = std::move(mesh.faces);
    if (of_file != nullptr) *of_file = std::move(mesh.of_file);
    return assemble(std::move(mesh.vertices), std::move(mesh.triangles), std::move(twin));
}

Surface grown(const Surface& s, std::vector<Vec3> vertices, const std::vector<Triangle>& more) {
    std::vector<Triangle> triangles = s.triangles;
    triangles.insert(triangles.end(), more.begin(), more.end());
    std::vector<std::uint32_t> twin = s.twin;
    twin.resize(3 * triangles.size(), kNone);
    const auto ends = [&](std::uint32_t h) {
        return std::pair(triangles[h / 3][h % 3], triangles[h / 3][(h + 1) % 3]);
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> open;
    for (std::uint32_t h = 0; h < twin.size(); ++h)
        if (twin[h] == kNone) open.emplace(ends(h), h);
    for (const auto& [way, h] : open)
        if (const auto other = open.find({way.second, way.first}); other != open.end()) twin[h] = other->second;
    return assemble(std::move(vertices), std::move(triangles), std::move(twin));
}

Facts facts(const Surface& s) {
    return {{"", "vertices", static_cast<double>(s.vertices.size()), ""},
            {"", "triangles", static_cast<double>(s.triangles.size()), ""},
            {"", "components", static_cast<double>(s.components), ""},
            {"", "rims", static_cast<double>(s.rims.size()), ""},
            {"", "area", area(s), "mm2"}};
}

double area(const Surface& s) {
    double sum = 0;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) sum += area(s, t);
    return sum;
}

double area(const Surface& s, std::uint32_t triangle) {
    const auto& [a, b, c] = s.triangles[triangle];
    return norm(cross(s.vertices[b] - s.vertices[a], s.vertices[c] - s.vertices[a])) / 2;
}

double rim_length(const Surface& s, const Rim& rim) {
    double sum = 0;
    for (const std::uint32_t h : rim.sides) sum += side_length(s, h);
    return sum;
}

double mean_edge(const Surface& s) {
    double sum = 0;
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) sum += side_length(s, h);
    return sum / static_cast<double>(s.twin.size());
}

double longest_edge(const Surface& s) {
    double out = 0;
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) out = std::max(out, side_length(s, h));
    return out;
}

Vec3 normal(const Surface& s, std::uint32_t triangle) {
    const auto& [a, b, c] = s.triangles[triangle];
    const Vec3 n = cross(s.vertices[b] - s.vertices[a], s.vertices[c] - s.vertices[a]);
    return 1 / norm(n) * n;
}

} // namespace filum::surface
