#include "surfpath/lanes/lanes.hpp"

#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surfpath::lanes {

Lanes::Lanes(const Surface& surface, std::vector<Line> lines, double spacing)
    : surface_(surface), lines_(std::move(lines)), spacing_(spacing) {
    for (std::uint32_t l = 0; l < lines_.size(); ++l) {
        arcs_.push_back(surface::curve::arc_lengths(lines_[l]));
        const double all = arcs_[l].back();
        const auto n = static_cast<std::size_t>(std::max(3.0, std::ceil(all / (rules::kGrain * spacing))));
        for (std::size_t i = 0; i < n; ++i) {
            const double arc = all * static_cast<double>(i) / static_cast<double>(n);
            const Place p = surface::curve::at(lines_[l], arcs_[l], arc);
            nodes_.push_back({l, arc, p.point, surface::normal(surface, p.triangle), surface.component[p.triangle]});
        }
    }
    std::vector<Vec3> points;
    for (const Node& n : nodes_) points.push_back(n.point);
    grid_ = geom::PointGrid<Vec3>(points, spacing);
}

Place Lanes::at(std::uint32_t lane, double arc) const { return surface::curve::at(lines_[lane], arcs_[lane], arc); }

Vec3 Lanes::tangent(std::uint32_t lane, double arc) const {
    const double half = std::min(0.3 * spacing_, length(lane) / 8);
    const Vec3 d = at(lane, arc + half).point - at(lane, arc - half).point;
    const double l = norm(d);
    return l > 0 ? 1 / l * d : Vec3{1, 0, 0};
}

Line Lanes::part(std::uint32_t lane, double from, double to) const {
    return surface::curve::part(lines_[lane], arcs_[lane], from, to);
}

double Lanes::curvature(std::uint32_t lane, double arc) const {
    const double half = std::min(0.5 * spacing_, length(lane) / 8);
    const Place p = at(lane, arc);
    const Vec3 n = surface::normal(surface_, p.triangle);
    const Vec3 a = p.point - at(lane, arc - half).point, b = at(lane, arc + half).point - p.point;
    return std::abs(std::atan2(dot(cross(a, b), n), dot(a, b))) / half;
}

LanePlace Lanes::refined(const Node& node, const Vec3& p) const {
    LanePlace out{node.lane, node.arc, distance(node.point, p)};
    const double step = rules::kGrain * spacing_, all = length(node.lane);
    double lo = node.arc - step, hi = node.arc + step;
    for (int i = 0; i < 12; ++i) { // ternary search; the lane is almost straight between the nodes
        const double a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
        if (distance(at(node.lane, a).point, p) < distance(at(node.lane, b).point, p))
            hi = b;
        else
            lo = a;
    }
    const double arc = (lo + hi) / 2, d = distance(at(node.lane, arc).point, p);
    if (d < out.distance) {
        out.arc = arc < 0 ? arc + all : arc >= all ? arc - all : arc;
        out.distance = d;
    }
    return out;
}

std::optional<LanePlace> Lanes::nearest(const Place& from, double reach, const Use& use) const {
    const Vec3 n = surface::normal(surface_, from.triangle);
    const std::uint32_t component = surface_.component[from.triangle];
    double least = reach;
    std::uint32_t best = surface::kNone;
    grid_.near(from.point, std::max(1, static_cast<int>(std::ceil(reach / spacing_))), [&](std::uint32_t i) {
        const Node& node = nodes_[i];
        const double d = distance(node.point, from.point);
        if (d > least || (d == least && i >= best)) return;
        if (node.component != component || dot(node.normal, n) < 0.3 || !use(node.lane, node.arc)) return;
        least = d;
        best = i;
    });
    if (best == surface::kNone) return std::nullopt;
    return refined(nodes_[best], from.point);
}

double Lanes::ahead(std::uint32_t lane, double from, double to, double sense) const {
    const double all = length(lane), d = std::fmod(sense * (to - from), all);
    return d < 0 ? d + all : d;
}

std::optional<LanePlace> Lanes::across(std::uint32_t lane, double arc, double side, double farthest) const {
    const Place from = at(lane, arc);
    const Vec3 n = surface::normal(surface_, from.triangle);
    const Vec3 out = side * cross(tangent(lane, arc), n);
    const auto use = [&](std::uint32_t l, double w) {
        if (l != lane) return true;
        return std::min(ahead(l, arc, w, 1), ahead(l, w, arc, 1)) > rules::kBeside * spacing_;
    };
    for (double far = 1; far < farthest + 0.1; far += 0.5) {
        const double length = std::min(far, farthest) * spacing_;
        const Place q = surface::curve::step(surface_, from, length * out);
        const auto found = nearest(q, 0.45 * spacing_, use);
        if (!found) continue;
        const Place there = at(found->lane, found->arc);
        const Vec3 off = there.point - from.point;
        const double d = norm(off);
        if (d > (farthest + 0.2) * spacing_ || dot(off, out) < 0.8 * d) continue;
        if (!surface::curve::leads(surface_, surface::curve::join(surface_, from, there))) continue;
        return LanePlace{found->lane, found->arc, d};
    }
    return std::nullopt;
}

} // namespace filum::surfpath::lanes
