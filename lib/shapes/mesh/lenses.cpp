#include "mesh/lenses.hpp"

#include "geom/disjoint_sets.hpp"
#include "geom/segment.hpp"
#include "mesh/formats.hpp"

#include <algorithm>
#include <span>

namespace filum::mesh {

namespace {

std::vector<std::uint32_t> sides_at(const SeamRims& rims, std::uint32_t vertex) {
    std::vector<std::uint32_t> out;
    rims.each_side(vertex, [&](std::uint32_t i) { out.push_back(i); });
    return out;
}

// Sorts the four rim sides of a vertex by fan, two by two. `triangles` are those of the vertex. Returns false if they
// are not two fans with two rim sides each.
bool sort_by_fan(const Mesh& mesh, const SeamRims& rims, std::uint32_t vertex, std::span<const std::uint32_t> triangles,
                 std::vector<std::uint32_t>& sides) {
    geom::DisjointSets fans(triangles.size());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> spokes; // other end, number of the triangle
    for (std::uint32_t k = 0; k < triangles.size(); ++k)
        for (const std::uint32_t v : mesh.triangles[triangles[k]])
            if (v != vertex) spokes.emplace_back(v, k);
    std::sort(spokes.begin(), spokes.end());
    for (std::size_t k = 1; k < spokes.size(); ++k)
        if (spokes[k].first == spokes[k - 1].first) fans.unite(spokes[k].second, spokes[k - 1].second);
    const auto fan = [&](std::uint32_t side) {
        const auto at = std::find(triangles.begin(), triangles.end(), rims.triangle(side));
        return fans.root(static_cast<std::uint32_t>(at - triangles.begin()));
    };
    std::sort(sides.begin(), sides.end(),
              [&](std::uint32_t i, std::uint32_t j) { return fan(i) != fan(j) ? fan(i) < fan(j) : i < j; });
    return fans.sets() == 2 && fan(sides[0]) == fan(sides[1]) && fan(sides[2]) == fan(sides[3]);
}

// A chain of rim sides from a pinched vertex to the next vertex where rims meet or end.
struct Chain {
    std::vector<std::uint32_t> sides, vertices; // one vertex more than sides
    std::vector<double> along;                  // mm from the first vertex, per vertex
    [[nodiscard]] std::uint32_t end() const { return vertices.back(); }
};

Chain chain(const SeamRims& rims, std::uint32_t from, std::uint32_t side) {
    Chain out{{}, {from}, {0}};
    while (out.sides.size() < rims.size()) {
        out.sides.push_back(side);
        out.along.push_back(out.along.back() + rims.length(side));
        out.vertices.push_back(rims.other_end(side, out.end()));
        const auto next = sides_at(rims, out.end());
        if (next.size() != 2 || out.end() == from) break;
        side = next[0] == side ? next[1] : next[0];
    }
    return out;
}

// Adds the inner vertices of chain `a` as places on the sides of `b`. Returns false if one of them is too far away.
bool add_places(const SeamRims& rims, const Chain& a, const Chain& b, std::vector<OnSide>& out) {
    for (std::size_t k = 1; k + 1 < a.vertices.size(); ++k) {
        const Vec3& p = rims.at(a.vertices[k]);
        const double share = a.along[k] / a.along.back(), at = share * b.along.back();
        const auto above = std::upper_bound(b.along.begin() + 1, b.along.end() - 1, at);
        const auto j = static_cast<std::size_t>(above - b.along.begin()) - 1;
        bool near = false; // to that side or one beside it, as the chains are not equally long everywhere
        for (std::size_t i = j > 0 ? j - 1 : 0; i < std::min(j + 2, b.sides.size()); ++i) {
            const Vec3 &c = rims.at(b.vertices[i]), &d = rims.at(b.vertices[i + 1]);
            const double t = geom::nearest_parameter(c, d, p), length = distance(c, d);
            const double rise = 4 * t * (1 - t) * kSeamOfSide * length;
            near = near || distance(c + t * (d - c), p) <= std::max(rise, std::min(rims.most(), kSeamOfSide * length));
        }
        const double length = b.along[j + 1] - b.along[j], part = (at - b.along[j]) / length;
        if (!near || !(part > 0 && part < 1) || rims.apex(b.sides[j]) == a.vertices[k]) return false;
        const bool forward = rims.tail(b.sides[j]) == b.vertices[j];
        out.push_back({rims.half_edge(b.sides[j]), forward ? part : 1 - part, a.vertices[k]});
    }
    return true;
}

// The two rim sides of a pinched vertex, one of each fan, that run nearest to each other; the other two are the second
// pair.
std::array<std::array<std::uint32_t, 2>, 2> pairs(const SeamRims& rims, std::uint32_t vertex,
                                                  std::array<std::uint32_t, 2> a, std::array<std::uint32_t, 2> b) {
    const auto along = [&](std::uint32_t i, std::uint32_t j) {
        const Vec3& p = rims.at(vertex);
        return dot(geom::unit(rims.at(rims.other_end(i, vertex)) - p, {}),
                   geom::unit(rims.at(rims.other_end(j, vertex)) - p, {}));
    };
    const bool straight =
        std::max(along(a[0], b[0]), along(a[1], b[1])) >= std::max(along(a[0], b[1]), along(a[1], b[0]));
    return {{{a[0], straight ? b[0] : b[1]}, {a[1], straight ? b[1] : b[0]}}};
}

} // namespace

PinchedVertices::PinchedVertices(const Mesh& mesh, const SeamRims& rims) {
    for (const std::uint32_t v : rims.vertices())
        if (sides_at(rims, v).size() == 4) vertices_.push_back(v);
    if (vertices_.empty()) return;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> at; // vertex, triangle
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (const std::uint32_t v : mesh.triangles[t])
            if (std::binary_search(vertices_.begin(), vertices_.end(), v)) at.emplace_back(v, t);
    std::sort(at.begin(), at.end());
    std::vector<std::uint32_t> kept, triangles;
    for (std::size_t i = 0, j = 0; i < at.size(); i = j) {
        triangles.clear();
        for (; j < at.size() && at[j].first == at[i].first; ++j) triangles.push_back(at[j].second);
        auto sides = sides_at(rims, at[i].first);
        if (!sort_by_fan(mesh, rims, at[i].first, triangles, sides)) continue;
        kept.push_back(at[i].first);
        first_fan_.push_back({sides[0], sides[1]});
    }
    vertices_ = std::move(kept);
}

bool PinchedVertices::apart(std::uint32_t vertex, std::uint32_t i, std::uint32_t j) const {
    const auto at = std::lower_bound(vertices_.begin(), vertices_.end(), vertex);
    if (at == vertices_.end() || *at != vertex) return false;
    const auto& fan = first_fan_[static_cast<std::size_t>(at - vertices_.begin())];
    const auto in_first = [&](std::uint32_t side) { return side == fan[0] || side == fan[1]; };
    return in_first(i) != in_first(j);
}

std::vector<OnSide> across_lenses(const Mesh& mesh, const SeamRims& rims) {
    const PinchedVertices pinched(mesh, rims);
    std::vector<OnSide> out;
    for (const std::uint32_t v : pinched.all()) {
        std::array<std::vector<std::uint32_t>, 2> fans;
        const auto sides = sides_at(rims, v);
        for (const std::uint32_t side : sides) fans[pinched.apart(v, sides[0], side) ? 1 : 0].push_back(side);
        for (const auto& [i, j] : pairs(rims, v, {fans[0][0], fans[0][1]}, {fans[1][0], fans[1][1]})) {
            if (!rims.may_meet(i, j)) continue;
            const Chain a = chain(rims, v, i), b = chain(rims, v, j);
            if (a.end() != b.end() || a.end() < v) continue; // the lens is found from its other end
            std::vector<OnSide> places;
            if (add_places(rims, a, b, places) && add_places(rims, b, a, places))
                out.insert(out.end(), places.begin(), places.end());
            if (a.end() == v) break; // a ring that touches another one here: both pairs see the same gap
        }
    }
    return out;
}

} // namespace filum::mesh
