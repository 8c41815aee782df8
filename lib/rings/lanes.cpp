#include "rings/lanes.hpp"

#include "polygon/clip.hpp"
#include "rings/fewer_points.hpp"
#include "rings/level.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace filum::rings {

namespace {

constexpr double kTips = 10; // voids of a small region that together leave kMostOpen of it
// Of the tolerance, by which beads are wider than their lanes: half of what opens on average between parallel bends
// whose chords are not in step (parabolas at random places gape by 4/15 of it).
constexpr double kSeam = 2.0 / 15;

} // namespace

double least_void(double width, double area) { return std::min(kLeastVoid * width * width, kMostOpen / kTips * area); }

FirstLanes first_lanes(const Loops& region, const LaneOptions& o) {
    const double area = polygon::signed_area(region), width = o.width - kSeam * o.tolerance, wider = o.width / width;
    const double flows = kLeastVoid * width * width, least = least_void(width, area);
    const double fine = o.tolerance / 4;
    const Beading b = beading(medial_axis(sites_of(region, o.tolerance / 2), fine, kWallSlope), width, least);
    FirstLanes out;
    lay_rings(b, o.most, flows, fine, [&](const toolpath::Curve& ring, int lane) {
        out.lanes.add(with_fewer_points(ring, fine / 3, least, false), lane);
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
    double out = 0;
    for (std::size_t k = 0, n = c.points.size(); k < n; ++k)
        out += (c.width_at(k) + c.width_at((k + 1) % n)) / 2 * geom::distance(c.points[k], c.points[(k + 1) % n]);
    return out;
}

double laid_area(const Rings& rings) {
    double out = 0;
    for (const toolpath::Curve& ring : curves_of(rings)) out += laid_area(ring);
    return out;
}

} // namespace filum::rings
