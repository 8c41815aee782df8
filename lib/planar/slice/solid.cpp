// Decides which faces of a layer are solid.
#include "polygon/simple.hpp"
#include "slice/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace filum::slice {

namespace {

using geom::Box2;
using geom::Vec2;
using polygon::Loops;

constexpr std::size_t kTogether = 16;    // most bodies that are united at once
constexpr std::size_t kBordersAsked = 4; // sampled borders per face: the longest ones
constexpr double kBeside = 5e-4;         // mm between a border and its sample

// The area of each body, from its own loops.
std::vector<Loops> by_body(const Loops& loops, const std::vector<std::uint32_t>& body,
                           const std::vector<char>& hollow) {
    std::vector<std::uint32_t> order(loops.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return body[a] < body[b]; });
    std::vector<Loops> out;
    for (std::size_t i = 0, j = 0; i < order.size(); i = j) {
        Loops& own = out.emplace_back();
        for (; j < order.size() && body[order[j]] == body[order[i]]; ++j) own.add(loops[order[j]]);
        if (polygon::is_simple(own)) continue;
        const bool less_cavities = hollow[body[order[i]]] != 0;
        own = polygon::unite_exactly(own, less_cavities ? polygon::Fill::positive : polygon::Fill::nonzero);
    }
    return out;
}

// Unites simple areas.  Areas whose boxes touch no other stay as they are.
Loops united(std::span<const Loops> areas) {
    std::vector<Box2> box;
    for (const Loops& a : areas) box.push_back(polygon::bounds(a));
    const auto clear = [&](std::size_t i) {
        for (std::size_t k = 0; k < areas.size(); ++k)
            if (k != i && geom::distance(box[i], box[k]) <= 0) return false;
        return true;
    };
    Loops alone, others;
    for (std::size_t i = 0; i < areas.size(); ++i) (clear(i) ? alone : others).add(areas[i]);
    if (!polygon::is_simple(others)) others = polygon::unite_exactly(others);
    alone.add(others);
    return alone;
}

bool few(const std::vector<std::uint32_t>& body) {
    std::vector<std::uint32_t> seen;
    for (const std::uint32_t b : body) {
        if (std::find(seen.begin(), seen.end(), b) == seen.end()) seen.push_back(b);
        if (seen.size() > kTogether) return false;
    }
    return true;
}

// Samples of a face's borders: their total length, and the sum of winding number times length.
struct Evidence {
    double length = 0, winding = 0;
};

} // namespace

Loops unite_bodies(const Loops& loops, const std::vector<std::uint32_t>& body, const std::vector<char>& hollow) {
    if (polygon::is_simple(loops)) return loops;
    if (few(body)) {
        const bool any = std::any_of(body.begin(), body.end(), [&](std::uint32_t b) { return hollow[b] != 0; });
        return polygon::unite_exactly(loops, any ? polygon::Fill::positive : polygon::Fill::nonzero);
    }
    std::vector<Loops> areas = by_body(loops, body, hollow);
    std::erase_if(areas, [](const Loops& a) { return a.empty(); });
    // near bodies come first: those in one place are united before they meet the others
    std::vector<std::pair<Vec2, std::size_t>> place;
    for (std::size_t i = 0; i < areas.size(); ++i) place.emplace_back(polygon::bounds(areas[i]).lo, i);
    std::sort(place.begin(), place.end(), [](const auto& a, const auto& b) {
        return std::tie(a.first.x, a.first.y, a.second) < std::tie(b.first.x, b.first.y, b.second);
    });
    std::vector<Loops> sorted;
    for (const auto& p : place) sorted.push_back(std::move(areas[p.second]));
    while (sorted.size() > 1) {
        std::vector<Loops> fewer;
        for (std::size_t i = 0; i < sorted.size(); i += kTogether)
            fewer.push_back(united({sorted.data() + i, std::min(kTogether, sorted.size() - i)}));
        sorted = std::move(fewer);
    }
    return sorted.empty() ? Loops{} : std::move(sorted[0]);
}

Loops solid_within(const std::vector<polygon::Wall>& walls, const mesh::Winding& surface, double z) {
    const auto plane = polygon::arrange(walls);
    if (!plane) return {};
    std::vector<std::uint32_t> order(plane->borders.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto size = [&](std::uint32_t b) { return geom::distance(plane->borders[b].a, plane->borders[b].b); };
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const bool m = plane->borders[a].marked, n = plane->borders[b].marked;
        return m != n ? m : size(a) > size(b);
    });
    std::vector<Evidence> found(plane->winding.size());
    std::vector<std::size_t> asked(plane->winding.size(), 0);
    for (const std::uint32_t i : order) {
        const polygon::Border& b = plane->borders[i];
        if (b.left == b.right) continue;
        const double l = size(i);
        const bool wanted =
            (b.left != 0 && asked[b.left] < kBordersAsked) || (b.right != 0 && asked[b.right] < kBordersAsked);
        if (!wanted) continue;
        const Vec2 p = 0.5 * (b.a + b.b) + kBeside / l * geom::left_of(b.b - b.a);
        const double left = surface.at({p.x, p.y, z});
        for (const auto& [face, winding] : {std::pair{b.left, left}, {b.right, left - b.weight}}) {
            ++asked[face];
            found[face].length += l;
            found[face].winding += l * winding;
        }
    }
    found[0] = {};
    return polygon::outline(*plane, [&](std::uint32_t face) { return found[face].winding > found[face].length / 2; });
}

} // namespace filum::slice
