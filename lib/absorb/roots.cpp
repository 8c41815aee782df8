#include "absorb/nose.hpp"

#include "absorb/turn.hpp"
#include "geom/segment.hpp"

#include <algorithm>

namespace filum::absorb {

namespace {

constexpr double kRootReach = 1.2;         // bead widths from the void
constexpr std::size_t kMost = 5, kFew = 3; // roots
constexpr int kNearest = 3;                // segments without a corner that are tried
constexpr double kAtVertex = 0.15;         // bead widths: points nearer to a node are that node

struct Found {
    double distance;
    std::uint32_t segment;
    double along;
};

std::vector<Found> segments_near(const Chain& chain, const Near& near, Vec2 c, double reach) {
    std::vector<Found> found;
    near.visit({c.x - reach, c.y - reach}, {c.x + reach, c.y + reach}, [&](std::uint32_t s) {
        const Bead b = chain.bead(s);
        const double t = geom::nearest_parameter(b.a, b.b, c), d = geom::distance(geom::lerp(b.a, b.b, t), c);
        if (d <= reach) found.push_back({d, s, t});
    });
    std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.segment < b.segment;
    });
    const auto same = [](const Found& a, const Found& b) { return a.segment == b.segment; };
    found.erase(std::unique(found.begin(), found.end(), same), found.end());
    return found;
}

Root at_vertex(const Chain& chain, std::uint32_t i) {
    const std::uint32_t a = chain[i].before, b = chain[i].next;
    return {a, b, i, chain.point(i), std::max(chain.bead(a).width, chain.bead(i).width)};
}

// Whether c lies on the outer side of a sharp corner at node i.
bool outside_of(const Chain& chain, std::uint32_t i, Vec2 c) {
    constexpr double kSharp = 0.5; // rad
    const double t = turn(chain, i);
    if (std::abs(t) < kSharp) return false;
    const Vec2 p = chain.point(i), u = p - chain.point(chain[i].before), v = chain.point(chain[i].next) - p;
    const double sign = t > 0 ? 1 : -1;
    return sign * geom::cross(u, c - p) < 0 || sign * geom::cross(v, c - p) < 0;
}

Root at_segment(const Chain& chain, const Found& f, double width) {
    const Bead b = chain.bead(f.segment);
    const double l = geom::distance(b.a, b.b);
    if (f.along * l < kAtVertex * width) return at_vertex(chain, f.segment);
    if ((1 - f.along) * l < kAtVertex * width) return at_vertex(chain, chain[f.segment].next);
    return {f.segment, chain[f.segment].next, std::nullopt, geom::lerp(b.a, b.b, f.along), b.width};
}

} // namespace

std::vector<Root> roots(const Tile& tile, const Chain& chain, const Near& near, const Void& v, const Search& search) {
    const Vec2 c = tile.centre(v.deepest);
    const double reach = kRootReach * search.width;
    const std::size_t most = search.small || search.thorough ? kMost : kFew;
    std::vector<Root> out;
    const auto add = [&](const Root& r) {
        for (const Root& o : out)
            if (o.vertex == r.vertex && o.from == r.from) return;
        if (out.size() < most) out.push_back(r);
    };
    const auto found = segments_near(chain, near, c, reach);
    for (const Found& f : found)
        for (const std::uint32_t i : {f.segment, chain[f.segment].next})
            if (geom::distance(chain.point(i), c) <= reach && outside_of(chain, i, c)) add(at_vertex(chain, i));
    for (std::size_t k = 0; k < found.size() && k < kNearest; ++k) add(at_segment(chain, found[k], search.width));
    return out;
}

} // namespace filum::absorb
