#include "absorb/cracks.hpp"

#include "absorb/turn.hpp"
#include "geom/segment.hpp"

#include <algorithm>
#include <map>

namespace filum::absorb {

namespace {

constexpr double kShort = 0.4;   // bead widths: shorter segments take part with their neighbours
constexpr double kWidest = 0.16; // bead widths: of a slit
constexpr int kPlaces = 12;      // at most, along a segment

// Of the slit between the bead and the next one on the side that `normal` shows; 0 where there is none.
double slit(const Chain& chain, const Near& near, std::uint32_t segment, Vec2 p, Vec2 normal, double width) {
    const double own = chain.bead(segment).width, reach = 1.5 * width;
    const Vec2 q = p + reach * normal;
    double distance = reach, other = -1;
    near.visit({std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x), std::max(p.y, q.y)},
               [&](std::uint32_t s) {
                   if (s == segment || s == chain[segment].next || s == chain[segment].before) return;
                   const Bead b = chain.bead(s);
                   const auto hit = geom::ray_parameters(p, normal, b.a, b.b);
                   if (hit && hit->t < distance) distance = hit->t, other = b.width;
               });
    if (other < 0) return 0;
    const double gap = distance - (own + other) / 2;
    return gap < kWidest * width ? std::max(0.0, gap) : 0;
}

// How much wider the bead should be.
double growth(const Tile& tile, const Chain& chain, const Near& near, std::uint32_t segment, double width) {
    const Bead b = chain.bead(segment);
    const double length = geom::distance(b.a, b.b);
    if (length < kShort * width) return 0;
    const Vec2 normal = geom::left_of(unit(b.b - b.a));
    const int n = std::clamp(static_cast<int>(length / width), 1, kPlaces);
    double left = kWidest * width, right = left;
    int places = 0;
    for (int k = 0; k < n; ++k) {
        const Vec2 p = geom::lerp(b.a, b.b, (k + 0.5) / n);
        if (!tile.holds(p)) continue;
        ++places;
        left = std::min(left, slit(chain, near, segment, p, normal, width));
        right = std::min(right, slit(chain, near, segment, p, -1.0 * normal, width));
    }
    return places > 0 ? (left + right) / 2 : 0;
}

} // namespace

void close_cracks(Tile& tile, Chain& chain, const Near& near, std::span<const std::uint32_t> segments, double width) {
    struct Share {
        double length = 0, grown = 0;
    };
    std::map<std::uint32_t, Share> nodes; // in order, so that the sums are the same in every run
    for (const std::uint32_t original : segments)
        chain.pieces(original, [&](std::uint32_t i) {
            const Bead b = chain.bead(i);
            const double length = geom::distance(b.a, b.b), grown = length * growth(tile, chain, near, i, width);
            for (const std::uint32_t end : {i, chain[i].next}) nodes[end].length += length, nodes[end].grown += grown;
        });
    const auto changes = [&](std::uint32_t i) {
        const auto it = nodes.find(i);
        return it != nodes.end() && it->second.grown > 0;
    };
    const auto paint = [&](int times) {
        for (const std::uint32_t original : segments)
            chain.pieces(original, [&](std::uint32_t i) {
                if (changes(i) || changes(chain[i].next)) tile.add(chain.bead(i), times);
            });
    };
    paint(-1);
    for (const auto& [i, share] : nodes)
        if (share.grown > 0) chain.set(i, {chain.point(i), chain[i].knot.width + share.grown / share.length});
    paint(1);
}

} // namespace filum::absorb
