#include "link3d/waiting.hpp"

#include "link3d/bead.hpp"

#include <algorithm>
#include <utility>

namespace filum::link3d {

namespace {

double region_width(const toolpath::RegionPaths& r) {
    double sum = 0;
    for (const auto& c : r.curves) sum += mean_width(c);
    return r.curves.empty() ? 0 : sum / static_cast<double>(r.curves.size());
}

double widest_bead(const toolpath::RegionPaths& r) {
    double out = 0;
    for (const auto& c : r.curves) out = std::max(out, *std::ranges::max_element(c.width));
    return out;
}

} // namespace

WaitingRegion waiting(toolpath::RegionPaths region) {
    SegmentIndex index(region.curves);
    const double width = region_width(region), widest = widest_bead(region);
    bool closed = false, open = false;
    for (const auto& c : region.curves) (c.closed ? closed : open) = true;
    return {std::move(region), std::move(index), width, widest, closed, open};
}

Place at_corner(Place place, const toolpath::Curve& curve, Vec2 from) {
    const Vec2 a = curve.points[place.segment], b = curve.points[(place.segment + 1) % curve.points.size()];
    const double to_a = geom::distance(place.point, a), to_b = geom::distance(place.point, b);
    if (std::min(to_a, to_b) >= kCorner) return place;
    place.t = to_a <= to_b ? 0 : 1;
    place.point = to_a <= to_b ? a : b;
    place.distance = geom::distance(place.point, from);
    return place;
}

std::optional<Entry> nearest_entry(const WaitingRegion& r, Vec2 p, double limit, std::span<const char> done) {
    std::optional<Entry> best;
    if (r.closed) {
        std::vector<char> skip;
        if (r.open || !done.empty()) {
            skip.assign(done.begin(), done.end());
            skip.resize(r.paths.curves.size(), 0);
            if (r.open)
                for (std::size_t c = 0; c < skip.size(); ++c)
                    skip[c] = skip[c] != 0 || !r.paths.curves[c].closed ? 1 : 0;
        }
        if (const auto place = r.index.nearest(p, limit, skip)) {
            best = Entry{at_corner(*place, r.paths.curves[place->curve], p), false};
            limit = place->distance;
        }
    }
    if (!r.open) return best;
    for (std::uint32_t c = 0; c < r.paths.curves.size(); ++c) {
        const auto& curve = r.paths.curves[c];
        if (curve.closed || (!done.empty() && done[c] != 0)) continue;
        for (const bool against : {false, true}) {
            const Vec2 end = against ? curve.points.back() : curve.points.front();
            const double d = geom::distance(end, p);
            if (d > limit || (best && d == limit)) continue;
            const auto segment = against ? static_cast<std::uint32_t>(curve.points.size()) - 2 : 0;
            best = Entry{{c, segment, against ? 1.0 : 0.0, end, d}, against};
            limit = d;
        }
    }
    return best;
}

} // namespace filum::link3d
