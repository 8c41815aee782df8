#include "fill/scaffold/splice.hpp"

#include "fill/join/cycle.hpp"
#include "fill/join/double_spiral.hpp"
#include "geom/segment_grid.hpp"
#include "rings/lanes.hpp"
#include "toolpath/curve_place.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace filum::fill::scaffold {

namespace {

using geom::Segment;
using toolpath::add_point;
using toolpath::add_stretch;
using toolpath::arc_lengths;
using toolpath::Curve;
using toolpath::CurvePlace;
using toolpath::nearest_place;
using toolpath::place_at;

constexpr double kPlaceStep = 1.0 / 4; // bead widths between the places that are tried
constexpr double kStraight = 0.9;      // a window must be as straight: chord / length
constexpr double kTouch = 1e-4;        // of a link's length, at either end, where it may touch

void add_segments(const Curve& c, std::vector<Segment>& to) {
    for (std::size_t i = 0; i + (c.closed ? 0 : 1) < c.points.size(); ++i)
        to.push_back({c.points[i], c.points[(i + 1) % c.points.size()]});
}

// A window of the curve and one of the ring: where the curve leaves for the ring and comes back to.
struct Detour {
    CurvePlace out, back;    // on the curve
    CurvePlace enter, leave; // on the ring
    bool against = false;    // the ring is run against its order
};

// The window around the place `along` of the curve, if the links can be laid there.
std::optional<Detour> detour(const Curve& curve, const std::vector<double>& sums, const Curve& ring,
                             const std::vector<double>& ring_sums, double along, double w) {
    if (along < w || along > sums.back() - w) return std::nullopt;
    Detour v{place_at(curve, sums, along - w / 2), place_at(curve, sums, along + w / 2), {}, {}};
    if (geom::distance(v.out.point, v.back.point) < kStraight * w) return std::nullopt;
    v.enter = nearest_place(ring, ring_sums, v.out.point);
    v.leave = nearest_place(ring, ring_sums, v.back.point);
    // the short way from enter to leave is given up
    const double all = ring_sums.back();
    double ahead = v.leave.along - v.enter.along;
    if (ahead < 0) ahead += all;
    v.against = ahead <= all / 2;
    const double given = std::min(ahead, all - ahead), chord = geom::distance(v.enter.point, v.leave.point);
    if (given < w / 2 || given > 2 * w || chord < kStraight * given) return std::nullopt;
    return v;
}

bool is_free(geom::Vec2 a, geom::Vec2 b, const geom::SegmentGrid& grid, const std::vector<Segment>& all) {
    return !grid.crosses(geom::lerp(a, b, kTouch), geom::lerp(b, a, kTouch), all, [](std::uint32_t) { return true; });
}

Curve spliced(const Curve& curve, const std::vector<double>& sums, const Curve& ring, const Detour& v) {
    Curve out, round;
    add_stretch(curve, place_at(curve, sums, 0), v.out, out);
    add_stretch(ring, v.against ? v.leave : v.enter, v.against ? v.enter : v.leave, round);
    if (v.against) round.reverse();
    for (std::size_t i = 0; i < round.points.size(); ++i) add_point(out, round.points[i], round.width[i]);
    add_stretch(curve, v.back, place_at(curve, sums, sums.back()), out);
    return out;
}

// The curve with the ring in it, by the shortest links that cross nothing.
std::optional<Curve> splice(const Curve& curve, const Curve& ring, const std::vector<Segment>& all, double w) {
    const auto sums = arc_lengths(curve), ring_sums = arc_lengths(ring);
    std::vector<Segment> edges;
    add_segments(ring, edges);
    const geom::SegmentGrid near(edges, w);
    std::vector<std::pair<double, double>> places; // distance, along
    const double reach = join::kNeighbourReach * w;
    for (double along = w; along < sums.back() - w; along += kPlaceStep * w) {
        const geom::Vec2 p = place_at(curve, sums, along).point;
        double d = reach;
        near.near(p - geom::Vec2{reach, reach}, p + geom::Vec2{reach, reach},
                  [&](std::uint32_t i) { d = std::min(d, geom::point_segment_distance(edges[i].a, edges[i].b, p)); });
        if (d < reach) places.emplace_back(std::round(d * 1e3), along);
    }
    std::sort(places.begin(), places.end());
    const geom::SegmentGrid grid(all, w);
    for (const auto& place : places) {
        const auto v = detour(curve, sums, ring, ring_sums, place.second, w);
        if (v && is_free(v->out.point, v->enter.point, grid, all) &&
            is_free(v->leave.point, v->back.point, grid, all) &&
            !geom::cross_properly(v->out.point, v->enter.point, v->leave.point, v->back.point))
            return spliced(curve, sums, ring, *v);
    }
    return std::nullopt;
}

// The curve led on from its end to the ring and once around it, if the end is next to the ring.
std::optional<Curve> led_on(const Curve& curve, const Curve& ring, const std::vector<Segment>& all, double w) {
    const auto sums = arc_lengths(ring);
    const geom::Vec2 end = curve.points.back();
    const CurvePlace at = nearest_place(ring, sums, end);
    if (geom::distance(at.point, end) > join::kNeighbourReach * w) return std::nullopt;
    if (!is_free(end, at.point, geom::SegmentGrid(all, w), all)) return std::nullopt;
    Curve out{false, curve.points, {}};
    for (std::size_t i = 0; i < curve.points.size(); ++i) out.width.push_back(curve.width_at(i));
    const double gap = sums.back() - w / 4; // two round ends fill it
    add_stretch(ring, at, place_at(ring, sums, std::fmod(at.along + gap, sums.back())), out);
    return out;
}

} // namespace

void splice_rings(const polygon::Loops& region, double w, int rings, std::vector<Curve>& curves, Notes& notes) {
    const auto groups = join::join_rings(rings::lanes(region, {.width = w, .most = rings}), w, region);
    const std::size_t open = curves.size();
    for (const Curve& ring : groups) {
        std::vector<Segment> all;
        for (const Curve& c : curves) add_segments(c, all);
        for (const Curve& c : groups) add_segments(c, all);
        bool joined = false;
        for (std::size_t c = 0; c < open && !joined; ++c)
            if (auto longer = splice(curves[c], ring, all, w)) {
                curves[c] = std::move(*longer);
                joined = true;
            }
        for (std::size_t c = 0; c < open && !joined; ++c)
            if (auto longer = led_on(curves[c], ring, all, w)) {
                curves[c] = std::move(*longer);
                joined = true;
            }
        if (joined) continue;
        curves.push_back(ring);
        notes.push_back({"", "ring not joined", 1, "curves", 1, -1, ring.points[0].x, ring.points[0].y});
    }
}

} // namespace filum::fill::scaffold
