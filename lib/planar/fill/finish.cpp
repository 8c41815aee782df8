#include "fill/finish.hpp"

#include "fill/rings/fewer_points.hpp"
#include "fill/rings/lanes.hpp"
#include "toolpath/grid.hpp"

#include <algorithm>
#include <cmath>

namespace filum::fill {

namespace {

// Bead widths of line for each right angle, from which corners are rare. A machine that brakes for a sharp corner loses
// about the time in which it extrudes one bead width of line, so sharp corners then cost a hundredth of its time.
constexpr double kRareCorners = 100;

// True if a bead runs from a to b and back over itself to c. Rounding such a point makes the bead cross itself.
bool spike(geom::Vec2 a, geom::Vec2 b, geom::Vec2 c) {
    const double flat = 2 * toolpath::kLeastMove;
    return dot(b - a, c - b) <= 0 &&
           (geom::point_segment_distance(b, c, a) < flat || geom::point_segment_distance(a, b, c) < flat);
}

// Puts the line on the grid; drops points that coincide and the tips of spikes.
void tidy(toolpath::Curve& line) {
    for (geom::Vec2& p : line.points) p = toolpath::on_grid(p);
    toolpath::Curve out;
    const auto size = [&] { return out.points.size(); };
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const geom::Vec2 p = line.points[i];
        while (size() > 1 && spike(out.points[size() - 2], out.points.back(), p)) out.drop_last();
        if (size() > 0 && out.points.back() == p) continue;
        out.add(p, line.width[i]);
    }
    std::size_t first = 0; // the same where the line closes
    for (bool again = true; again && size() - first > 3;) {
        again = out.points.back() == out.points[first] ||
                spike(out.points[size() - 2], out.points.back(), out.points[first]);
        if (again) {
            out.drop_last();
        } else if (spike(out.points.back(), out.points[first], out.points[first + 1])) {
            again = true;
            ++first;
        }
    }
    if (size() - first < 3) return; // too few points for a curve: keep all
    line.points.assign(out.points.begin() + static_cast<std::ptrdiff_t>(first), out.points.end());
    line.width.assign(out.width.begin() + static_cast<std::ptrdiff_t>(first), out.width.end());
}

} // namespace

std::vector<toolpath::Curve> finished(const rings::Rings& rings, const polygon::Loops& region, const Finish& how) {
    const double w = how.bead_width, area = polygon::signed_area(region), least = rings::least_void(w, area);
    Corners corners{how.open > 0 ? how.open : least, how.tolerance, how.corners};
    if (how.open <= 0) {
        corners.open_in_all = rings::kMostOpen * area;
        corners.rare = kRareCorners * w;
    }
    const join::OutlineEdges outline(region, 1.5 * w);
    const auto room = [&](geom::Vec2 p, double most) {
        double best2 = most * most;
        outline.grid.near({p.x - most, p.y - most}, {p.x + most, p.y + most}, [&](std::uint32_t i) {
            best2 = std::min(best2, geom::norm2(geom::nearest_point(outline.edge[i].a, outline.edge[i].b, p) - p));
        });
        return std::sqrt(best2);
    };
    std::vector<toolpath::Curve> out;
    for (toolpath::Curve& curve : join::join_rings(rings, std::max(w, how.widest), outline, how.wind, how.hung)) {
        curve = rounded(curve, w, corners, room);
        if (how.thin_out) curve = rings::with_fewer_points(curve, how.tolerance, least, true);
        tidy(curve);
        out.push_back(std::move(curve));
    }
    return out;
}

double leave_tiny(std::vector<toolpath::Curve>& curves, double bead_width) {
    const double least = bead_width * bead_width;
    double left = 0;
    for (std::size_t i = curves.size(); i-- > 1;) {
        const double area = rings::laid_area(curves[i]);
        if (area >= least) continue;
        left += area;
        curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return left;
}

} // namespace filum::fill
