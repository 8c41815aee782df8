#include "link3d/interlace.hpp"

#include "link3d/linker.hpp"
#include "link3d/strip_route.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace filum::link3d {

namespace {

constexpr double kStartStep = 3.6;     // bead widths along the curve, more than kApart: curves bend
constexpr double kGolden = 0.38196601; // 1 - 1 / golden ratio
constexpr double kSpread = 9.6; // bead widths that golden starts spread over: kGolden times it is above kStartStep
constexpr double kRandom = 12;  // bead widths that random starts spread over
constexpr double kAround = 3;   // bead widths: how far beside the straight way a lane may go
constexpr double kBest = 64;    // rank of a lane that ends at its goal

// The next number of a generator with the same numbers everywhere (Steele, Lea, Flood: splitmix64), in [0, 1).
double next(std::uint64_t& state) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return static_cast<double>((z ^ (z >> 31U)) >> 11U) / 9007199254740992.0;
}

// The stretches of the curves' lines of which segments meet the box.
std::vector<std::vector<Vec2>> lines_in(std::span<const toolpath::Curve> curves, const Box2& box) {
    std::vector<std::vector<Vec2>> out;
    for (const auto& c : curves) {
        bool open = false;
        for (std::size_t i = 0; i + 1 < c.points.size() + (c.closed ? 1 : 0); ++i) {
            const Vec2 a = c.points[i], b = c.points[(i + 1) % c.points.size()];
            const bool meets = std::min(a.x, b.x) <= box.hi.x && std::max(a.x, b.x) >= box.lo.x &&
                               std::min(a.y, b.y) <= box.hi.y && std::max(a.y, b.y) >= box.lo.y;
            if (meets && !open) out.push_back({a});
            if (meets) out.back().push_back(b);
            open = meets;
        }
    }
    return out;
}

} // namespace

double start_offset(Interlace scheme, std::uint32_t layer, double before, std::uint64_t& state) {
    if (scheme == Interlace::alternate) return layer % 2 == 0 ? 0 : kStartStep;
    if (scheme == Interlace::golden) return kSpread * std::fmod(layer * kGolden, 1.0);
    if (scheme == Interlace::none) return 0;
    // as if drawn until it is far enough from the one before
    const double lo = std::max(0.0, before - kStartStep), hi = std::min(kRandom, before + kStartStep);
    const double at = next(state) * (lo + kRandom - hi);
    return at < lo ? at : at - lo + hi;
}

// Beads on both sides of the place, so that a start there does not show.
bool Linker::hidden(const Waiting& r, const Place& place) {
    const auto& points = r.paths.curves[place.curve].points;
    const Vec2 d = points[(place.segment + 1) % points.size()] - points[place.segment];
    const double l = geom::norm(d);
    if (l < kSamePoint) return false;
    const Vec2 side = (r.width / l) * Vec2{-d.y, d.x};
    return r.index.nearest(place.point + side, 0.6 * r.width) && r.index.nearest(place.point - side, 0.6 * r.width);
}

// Whether the front region's last bead, as a ramp makes it, ends far enough from where the layer began.
bool Linker::apart(const Bead& bead) const {
    return geom::distance(bead.points.back(), start_) >= kApart * window_.front().width;
}

// A lane from the end of the front region's last bead to where the scheme wants the next layer to begin, or as near to
// it as there is a way; at any rate kApart from where this layer began.
std::optional<std::vector<Vec2>> Linker::shift(std::uint32_t c, const Bead& bead) {
    const auto& above = window_[1];
    const double width = (window_[0].width + above.width) / 2;
    const auto home = nearest_entry(above, home_, std::numeric_limits<double>::infinity(), {});
    if (home->place.distance > width) home_ = home->place.point;
    offset_ = start_offset(options_.interlace, above.paths.layer, offset_, random_);
    const Vec2 goal = along(above.paths.curves[home->place.curve], home->place, offset_ * width);
    const Vec2 from = bead.points.back();
    const auto curves = as_printed(c, bead, {});
    const SegmentIndex index(curves);
    const auto rank = [&](Vec2 p, bool inside) {
        const auto e = nearest_entry(above, p, reaches(above).front() * width, {});
        if (!e || geom::distance(e->place.point, start_) < kApart * width) return 0;
        if (inside && !hidden(above, e->place)) return 0;
        return static_cast<int>(std::max(1.0, kBest - std::floor(geom::distance(e->place.point, goal) / width)));
    };
    for (const double around : {kAround, 3 * kAround}) {
        const Vec2 margin{around * width, around * width};
        Box2 box;
        box.add(from);
        box.add(goal);
        const auto lines = lines_in(curves, {box.lo - margin, box.hi + margin});
        for (const bool inside : {true, false}) {
            if (inside && options_.seam != Seam::inside) continue;
            if (auto way = strip_route(lines, curves, index, from, window_[0].width, kStrips, static_cast<int>(kBest),
                                       [&](Vec2 p, int) { return rank(p, inside); }))
                return way;
        }
    }
    return std::nullopt;
}

} // namespace filum::link3d
