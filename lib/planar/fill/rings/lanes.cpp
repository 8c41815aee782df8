#include "fill/rings/lanes.hpp"

#include "fill/rings/fewer_points.hpp"
#include "fill/rings/level.hpp"
#include "fill/rings/wall_lanes.hpp"
#include "polygon/clip.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace filum::fill::rings {

namespace {

constexpr double kTips = 10; // tips of a small region that may together leave kMostOpen of it
// Tolerances by which beads are wider than their lanes: half of the mean gap between parallel bends whose chords are
// not in step (parabolas at random places gape by 4/15).
constexpr double kSeam = 2.0 / 15;

// Area of a bead, mm2; width(i) is that at point i.
template <class Width>
double area_of(std::span<const Vec2> points, bool closed, const Width& width) {
    double out = 0;
    for (std::size_t i = 0, n = points.size(); i + (closed ? 0 : 1) < n; ++i) {
        const std::size_t next = i + 1 == n ? 0 : i + 1;
        out += (width(i) + width(next)) / 2 * geom::distance(points[i], points[next]);
    }
    return out;
}

} // namespace

double least_void(double width, double area) { return std::min(kLeastVoid * width * width, kMostOpen / kTips * area); }

FirstLanes first_lanes(const Loops& region, const LaneOptions& o) {
    const double area = polygon::signed_area(region), width = o.width - kSeam * o.tolerance, wider = o.width / width;
    const double flows = kLeastVoid * width * width, least = least_void(width, area);
    const double fine = o.tolerance / 4;
    const Beading b = beading(medial_axis(region, o.tolerance / 2, fine, kWallSlope), width, least);
    FirstLanes out;
    out.lanes = trace_rings(b, o.most, flows, fine, [&](const toolpath::Curve& ring) {
        return with_fewer_points(ring, fine / 3, least, false);
    });
    for (double& w : out.lanes.width) w *= wider;
    if (o.most > 0) out.rest = polygon::split(beyond(b, o.most, fine)).part;
    std::erase_if(out.rest, [&](const Loops& part) { return polygon::signed_area(part) <= flows; });
    return out;
}

Rings lanes(const Loops& region, const LaneOptions& o) { return first_lanes(region, o).lanes; }

std::vector<toolpath::Curve> curves_of(const Rings& rings) {
    std::vector<toolpath::Curve> out;
    for (std::size_t i = 0; i < rings.size(); ++i)
        out.push_back({true,
                       {rings.points.begin() + rings.start[i], rings.points.begin() + rings.start[i + 1]},
                       {rings.width.begin() + rings.start[i], rings.width.begin() + rings.start[i + 1]}});
    return out;
}

double laid_area(const toolpath::Curve& c) {
    return area_of(c.points, c.closed, [&](std::size_t i) { return c.width_at(i); });
}

double laid_area(const Rings& rings) {
    double out = 0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const std::size_t first = rings.start[i], n = rings.start[i + 1] - first;
        out += area_of(std::span(rings.points).subspan(first, n), true,
                       [&](std::size_t k) { return rings.width[first + k]; });
    }
    return out;
}

} // namespace filum::fill::rings
