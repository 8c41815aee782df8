#include "mesh/holes.hpp"

#include "mesh/formats.hpp"
#include "mesh/place.hpp"
#include "mesh/sides.hpp"

#include <algorithm>
#include <cmath>

namespace filum::mesh {

namespace {

constexpr double kLargestLid = 0.6; // largest lid, as a fraction of the shell's area

// The surplus sides of unbalanced edges, as (from, to) vertices, in ascending order.
std::vector<std::pair<std::uint32_t, std::uint32_t>> rims(const Mesh& mesh) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
    const auto sides = half_edges(mesh);
    each_edge(sides, [&](std::size_t i, std::size_t j) {
        std::ptrdiff_t balance = 0;
        for (std::size_t k = i; k < j; ++k) balance += sides[k].falls ? -1 : 1;
        const auto low = static_cast<std::uint32_t>(sides[i].key >> 32),
                   high = static_cast<std::uint32_t>(sides[i].key);
        for (; balance > 0; --balance) out.emplace_back(low, high);
        for (; balance < 0; ++balance) out.emplace_back(high, low);
    });
    std::sort(out.begin(), out.end());
    return out;
}

// Chains the surplus sides to closed rims.  At every vertex as many sides end as begin.
std::vector<std::vector<std::uint32_t>> closed_rims(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& sides) {
    std::vector<std::vector<std::uint32_t>> out;
    std::vector<char> used(sides.size(), 0);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (used[i] != 0) continue;
        std::vector<std::uint32_t> rim;
        for (std::size_t j = i; j < sides.size() && used[j] == 0;) {
            used[j] = 1;
            rim.push_back(sides[j].first);
            const std::uint32_t to = sides[j].second;
            j = static_cast<std::size_t>(std::lower_bound(sides.begin(), sides.end(), std::pair{to, 0U}) -
                                         sides.begin());
            while (j < sides.size() && sides[j].first == to && used[j] != 0) ++j;
            if (j < sides.size() && sides[j].first != to) break;
        }
        out.push_back(std::move(rim));
    }
    return out;
}

} // namespace

std::vector<HalfEdge> half_edges(const Mesh& mesh) {
    std::vector<HalfEdge> out;
    out.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint64_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
            out.push_back({std::min(a, b) << 32 | std::max(a, b), 3 * t + k, a > b});
        }
    std::sort(out.begin(), out.end(),
              [](const HalfEdge& a, const HalfEdge& b) { return a.key != b.key ? a.key < b.key : a.side < b.side; });
    return out;
}

double area(const Mesh& mesh, const Triangle& t) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    return norm(cross(b - a, c - a)) / 2;
}

std::uint64_t imbalance(const Triangle& t) {
    std::uint64_t sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint64_t a = t[k], b = t[(k + 1) % 3];
        std::uint64_t h = (std::min(a, b) << 32 | std::max(a, b)) * 0x9e3779b97f4a7c15ULL;
        h = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9ULL;
        h ^= h >> 32;
        sum += a < b ? h : 0 - h;
    }
    return sum;
}

bool is_closed(const Mesh& mesh) {
    std::uint64_t sum = 0;
    for (const Triangle& t : mesh.triangles) sum += imbalance(t);
    return sum == 0;
}

Lids lids(Mesh& mesh) {
    Lids out;
    if (is_closed(mesh)) return out;
    const Shells shells = shells_of(mesh);
    std::vector<double> size(shells.count, 0);
    for (const Triangle& t : mesh.triangles) size[shells.of_vertex[t[0]]] += area(mesh, t);
    for (const auto& rim : closed_rims(rims(mesh))) {
        double round = 0;
        Vec3 middle;
        // weighted with the lengths of both sides at a vertex, so that densely sampled parts do not dominate
        for (std::size_t i = 0; i < rim.size(); ++i) {
            const Vec3 &p = mesh.vertices[rim[i]], &q = mesh.vertices[rim[(i + 1) % rim.size()]];
            const double l = distance(p, q);
            round += l;
            middle = middle + l / 2 * (p + q);
        }
        if (!(round > 0)) continue;
        const auto centre = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(1 / round * middle);
        const std::size_t before = out.triangles.size();
        double lid = 0;
        for (std::size_t i = 0; i < rim.size(); ++i) {
            out.triangles.push_back({rim[(i + 1) % rim.size()], rim[i], centre});
            lid += area(mesh, out.triangles.back());
        }
        if (lid <= kLargestLid * size[shells.of_vertex[rim[0]]]) {
            out.holes.push_back({lid, mesh.vertices[centre]});
            continue;
        }
        out.triangles.resize(before);
        mesh.vertices.pop_back();
    }
    return out;
}

} // namespace filum::mesh
