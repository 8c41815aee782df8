#include "fill/walls/single_lane.hpp"

#include "fill/rings/wall_lanes.hpp"
#include "toolpath/curve_place.hpp"
#include "toolpath/grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace filum::fill::walls {

namespace {

using toolpath::add_point;
using toolpath::add_stretch;
using toolpath::arc_lengths;
using toolpath::Curve;
using toolpath::CurvePlace;
using toolpath::nearest_place;
using toolpath::place_at;

constexpr double kShort = 3; // bead widths: shorter walls stay as they are

// A closed curve with its arc lengths.
struct MeasuredCurve {
    const Curve& curve;
    std::vector<double> sums;

    explicit MeasuredCurve(const Curve& c) : curve(c), sums(arc_lengths(c)) {}
    [[nodiscard]] double ahead(const CurvePlace& a, const CurvePlace& b) const {
        return b.along >= a.along ? b.along - a.along : b.along - a.along + sums.back();
    }
    [[nodiscard]] CurvePlace nearest(Vec2 p) const { return nearest_place(curve, sums, p); }
};

// The wall without `first` mm at its start and `last` mm at its end.
Wall part(const Wall& w, double first, double last) {
    Wall out{w.a, w.b, {}, std::max(0.0, w.length - first - last)};
    if (out.length == 0) return out;
    const auto sums = arc_lengths(w.line);
    add_stretch(w.line, place_at(w.line, sums, first), place_at(w.line, sums, w.length - last), out.line);
    return out;
}

Wall reversed(Wall w) {
    std::swap(w.a, w.b);
    w.line.reverse();
    return w;
}

// The place of a lane beside point `i` of the wall: left (side 1) or right (-1).
Vec2 beside(const Wall& w, std::size_t i, int side) {
    const auto& line = w.line.points;
    const Vec2 d = i == 0 ? line[1] - line[0] : line[i] - line[i - 1];
    return line[i] + side * w.line.width[i] / 4 / geom::norm(d) * geom::left_of(d);
}

// The curve with the lane on `side` of the wall moved to its middle, and the other lane removed, or moved as well if
// `both`. nullopt if the lanes are not in their places, or if the new curve crosses itself.
std::optional<Curve> to_middle(const MeasuredCurve& m, const Wall& w, bool tip, double width, int side, bool both) {
    const double back = tip ? std::min(w.length / 4, w.line.width.back() / 2) : 0; // lanes turn before the tip
    const Wall lanes = part(w, 0, back);
    if (lanes.line.points.size() < 2) return std::nullopt;
    const std::size_t last = lanes.line.points.size() - 1;
    const CurvePlace a0 = m.nearest(beside(lanes, 0, side)), a1 = m.nearest(beside(lanes, last, side));
    const CurvePlace b0 = m.nearest(beside(lanes, 0, -side)), b1 = m.nearest(beside(lanes, last, -side));
    for (const CurvePlace& p : {a0, a1, b0, b1})
        if (p.off > rings::kMostOff * width) return std::nullopt;
    if (std::abs(m.ahead(a0, a1) - lanes.length) > width || std::abs(m.ahead(b1, b0) - lanes.length) > width)
        return std::nullopt;
    if (tip && m.ahead(a1, b1) > 4 * (back + width)) return std::nullopt;
    Curve out;
    out.closed = both;
    add_stretch(m.curve, b0, a0, out);
    for (std::size_t i = 0; i < w.line.points.size(); ++i)
        add_point(out, w.line.points[i], w.line.width[i] / (both ? 2 : 1));
    if (!tip) add_stretch(m.curve, a1, b1, out);
    for (std::size_t i = w.line.points.size(); both && i-- > 0;) add_point(out, w.line.points[i], w.line.width[i] / 2);
    toolpath::put_on_grid(out);
    if (!toolpath::crossing_pairs({out}, width).empty()) return std::nullopt;
    return out;
}

// The longest stretch of the wall that is thinner than 2 * `least`: its start and end, mm along the wall.
std::pair<double, double> thin_stretch(const Wall& w, double least) {
    std::pair<double, double> best{0, 0};
    double along = 0, first = 0;
    for (std::size_t i = 0; i + 1 < w.line.points.size(); ++i) {
        along += geom::distance(w.line.points[i], w.line.points[i + 1]);
        if (std::max(w.line.width[i], w.line.width[i + 1]) >= 2 * least) first = along;
        if (along - first > best.second - best.first) best = {first, along};
    }
    return best;
}

// Wall k, reversed if needed so that it ends at a tip, and whether it does.
std::pair<Wall, bool> towards_tip(const WallGraph& walls, std::size_t k, double width) {
    const auto is_tip = [&](std::uint32_t v, double radius) {
        const auto at =
            std::count_if(walls.walls.begin(), walls.walls.end(), [&](const Wall& w) { return w.a == v || w.b == v; });
        return at == 1 && radius < 0.495 * width;
    };
    const Wall& w = walls.walls[k];
    if (is_tip(w.b, w.line.width.back() / 2)) return {w, true};
    if (is_tip(w.a, w.line.width.front() / 2)) return {reversed(w), true};
    return {w, false};
}

} // namespace

std::optional<std::size_t> pass_once(Curve& curve, const WallGraph& walls, double width) {
    std::vector<std::size_t> order(walls.walls.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](auto i, auto k) { return walls.walls[i].length > walls.walls[k].length; });
    const MeasuredCurve m(curve);
    for (const auto k : order) {
        auto [w, tip] = towards_tip(walls, k, width);
        w = part(w, width / 2, tip ? 0 : width / 2);
        toolpath::put_on_grid(w.line);
        if (w.length < kShort * width || w.line.points.size() < 2) continue;
        for (const int side : {1, -1})
            if (auto open = to_middle(m, w, tip, width, side, false)) {
                curve = std::move(*open);
                return k;
            }
    }
    return std::nullopt;
}

std::vector<std::vector<Vec2>> stack_lanes(Curve& curve, const WallGraph& walls, double width, double least) {
    std::vector<std::vector<Vec2>> out;
    for (std::size_t k = 0; k < walls.walls.size(); ++k) {
        const auto [whole, ends_at_tip] = towards_tip(walls, k, width);
        auto [first, last] = thin_stretch(whole, least);
        const bool tip = ends_at_tip && last > whole.length - 1e-9;
        if (!tip) last = std::min(last, whole.length - width / 2);
        Wall w = part(whole, std::max(first, width / 2), whole.length - last);
        toolpath::put_on_grid(w.line);
        if (w.length < kShort / 2 * width || w.line.points.size() < 2) continue;
        const MeasuredCurve m(curve);
        for (const int side : {1, -1})
            if (auto stacked = to_middle(m, w, tip, width, side, true)) {
                curve = std::move(*stacked);
                out.push_back(w.line.points);
                break;
            }
    }
    return out;
}

} // namespace filum::fill::walls
