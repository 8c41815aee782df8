#include "geodesic/superlevel_set.hpp"

#include "geodesic/query.hpp"

#include <algorithm>

namespace filum::geodesic {

using surface::kNone;

SuperlevelSet::SuperlevelSet(const Surface& s, const ExactField& field, double level)
    : surface_(s), sets_(s.vertices.size()) {
    const auto& d = field.distance;
    for (const double v : d) far_.push_back(std::isfinite(v) && v >= level ? 1 : 0);
    std::vector<double> crossings;
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        const double a = d[s.tail(h)], b = d[s.head(h)];
        if (s.twin[h] < h || !std::isfinite(a) || !std::isfinite(b)) continue;
        crossings.clear();
        if (within_reach(a, b, field.unfolding->frame[h].length, level)) level_crossings(s, field, h, level, crossings);
        if (!crossings.empty())
            cut(h, crossings);
        else if (far_[s.tail(h)] != 0)
            sets_.unite(s.tail(h), s.head(h));
    }
    const Inside at = [&](std::uint32_t t, const Vec3& p) { return distance_at(s, field, t, p) - level; };
    join_across(at);
    highest_.assign(sets_.number(component_), level);
    for (std::size_t v = 0; v < d.size(); ++v)
        if (far_[v] != 0) highest_[component_[v]] = std::max(highest_[component_[v]], d[v]);
    for (const EdgePart& g : parts_) {
        const Vec3 &a = s.vertices[s.tail(g.edge)], &b = s.vertices[s.head(g.edge)];
        const Vec3 middle = a + (g.from + g.to) / 2 / field.unfolding->frame[g.edge].length * (b - a);
        double& highest = highest_[component_[g.node]];
        highest = std::max(highest, distance_at(s, field, g.edge / 3, middle));
    }
}

// The parts between crossings on which an edge is above the level.
void SuperlevelSet::cut(std::uint32_t h, std::span<const double> crossings) {
    const std::uint32_t tail = surface_.tail(h), head = surface_.head(h);
    const double length = distance(surface_.vertices[tail], surface_.vertices[head]);
    double from = 0;
    bool far = far_[tail] != 0;
    for (std::size_t i = 0; i <= crossings.size(); ++i, far = !far) {
        const double to = i < crossings.size() ? crossings[i] : length;
        if (far) {
            const std::uint32_t node = i == 0 ? tail : i == crossings.size() ? head : sets_.add();
            parts_.push_back({h, node, from, to});
        }
        from = to;
    }
}

std::span<const SuperlevelSet::EdgePart> SuperlevelSet::on(std::uint32_t half_edge) const {
    const std::uint32_t edge = std::min(half_edge, surface_.twin[half_edge]);
    const auto less = [](const EdgePart& g, std::uint32_t e) { return g.edge < e; };
    const auto first = std::lower_bound(parts_.begin(), parts_.end(), edge, less);
    auto last = first;
    while (last != parts_.end() && last->edge == edge) ++last;
    return {first, last};
}

// Handles the triangles whose border crosses the level.
void SuperlevelSet::join_across(const Inside& above) {
    std::vector<std::uint32_t> crossed;
    for (const EdgePart& g : parts_)
        for (const std::uint32_t h : {g.edge, surface_.twin[g.edge]})
            if (h != kNone) crossed.push_back(h / 3);
    std::sort(crossed.begin(), crossed.end());
    crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
    for (const std::uint32_t t : crossed) join_across(t, above);
}

// If a triangle's border crosses the level more than twice, parts above it may be connected through the middle.
void SuperlevelSet::join_across(std::uint32_t triangle, const Inside& above) {
    std::size_t crossings = 0;
    Vec3 sum;
    for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const std::uint32_t edge = std::min(h, surface_.twin[h]);
        const Vec3 &a = surface_.vertices[surface_.tail(edge)], &b = surface_.vertices[surface_.head(edge)];
        const double length = distance(a, b);
        for (const EdgePart& g : on(h))
            for (const double x : {g.from, g.to})
                if (x > 0 && x < length) {
                    ++crossings;
                    sum = sum + a + x / length * (b - a);
                }
    }
    if (crossings <= 2 || above(triangle, 1.0 / static_cast<double>(crossings) * sum) < 0) return;
    std::uint32_t first = kNone;
    for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h)
        for (const EdgePart& g : on(h)) {
            if (first != kNone) sets_.unite(first, g.node);
            first = g.node;
        }
}

std::uint32_t SuperlevelSet::component(const EdgePlace& place) const {
    const auto cut = on(place.h);
    for (const EdgePart& g : cut)
        if (place.x >= g.from && place.x <= g.to) return component_[g.node];
    return cut.empty() && far_[surface_.tail(place.h)] != 0 ? component_[surface_.tail(place.h)] : kNone;
}

} // namespace filum::geodesic
