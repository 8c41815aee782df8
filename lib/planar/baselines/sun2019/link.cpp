#include "baselines/sun2019/link.hpp"

#include "geom/principal_axis.hpp"

#include <cmath>

namespace filum::baselines::sun2019 {

using geom::length;
using geom::Vec2;
using geom::Vec3;
using link3d::Bead;
using link3d::Place;
using toolpath::Role;

namespace {

constexpr double kMargin = 2; // bead widths between a connector and the box

// The place `shift` mm behind `place` along the closed curve.
Place moved(const toolpath::Curve& curve, Place place, double shift) {
    const std::size_t n = curve.points.size();
    const double around = length(curve.points) + geom::distance(curve.points.back(), curve.points.front());
    shift -= std::floor(shift / around) * around;
    for (std::size_t k = 0; k <= n; ++k, place.segment = static_cast<std::uint32_t>((place.segment + 1) % n)) {
        const Vec2 end = curve.points[(place.segment + 1) % n];
        const double left = geom::distance(place.point, end);
        if (shift <= left) {
            const Vec2 a = curve.points[place.segment];
            const double l = geom::distance(a, end);
            if (left > 0) place.point = geom::lerp(place.point, end, shift / left);
            place.t = l > 0 ? geom::distance(a, place.point) / l : 0;
            return place;
        }
        shift -= left;
        place.point = end;
    }
    return place;
}

} // namespace

Bead from_axis(const toolpath::Curve& curve, double shift) {
    const std::vector<toolpath::Curve> one{curve};
    const auto out = geom::leaves(geom::principal_axis(curve.points), curve.points);
    const auto start = link3d::SegmentIndex(one).nearest(out ? *out : curve.points.front());
    return link3d::cut(curve, moved(curve, *start, shift), false, 0);
}

void Linker::finish(const link3d::Linker::Emit& emit, Notes& /*none*/) {
    for (const auto& r : regions_)
        for (const auto& c : r.curves)
            for (const Vec2 p : c.points) box_.add(p);
    for (const auto& r : regions_) {
        bool first = true;
        for (const auto& c : r.curves) {
            const Bead bead = c.closed ? from_axis(c, options_.start_shift * r.layer) : link3d::run(c, false);
            reach(r, first, bead.points.front(), emit);
            std::vector<Vec3> points;
            for (const Vec2 p : bead.points) points.push_back({p.x, p.y, r.z});
            go(r, Role::bead, std::move(points), bead.width, emit);
            first = false;
        }
    }
}

// Leads the nozzle to the start of a curve of r, the region's first or a later one.
void Linker::reach(const toolpath::RegionPaths& r, bool first, Vec2 start, const link3d::Linker::Emit& emit) {
    const Vec3 to{start.x, start.y, r.z};
    if (!at_) {
        at_ = to;
        ++counts_.strokes;
        return;
    }
    const double width = link3d::mean_width(r.curves.front());
    if (!first) {
        ++counts_.breaks;
        ++counts_.strokes;
        ++stroke_;
        counts_.travel_length += geom::distance(*at_, to);
        go(r, Role::travel, {*at_, to}, {}, emit);
    } else if (r.join == Join::vertical) {
        ++counts_.lifts;
        counts_.lift_length += geom::distance(at_->xy(), start);
        std::vector<Vec3> way{*at_, {at_->x, at_->y, r.z}};
        if (way.back() != to) way.push_back(to);
        go(r, Role::lift, std::move(way), {width}, emit);
    } else {
        auto way = link3d::around(
            box_, kMargin * width, *at_, to, [](Vec3, Vec3) { return true; },
            [](std::span<const Vec3>) { return true; });
        ++counts_.connectors;
        counts_.connector_length += length(*way);
        go(r, Role::connector, std::move(*way), {width}, emit);
    }
}

void Linker::go(const toolpath::RegionPaths& r, Role role, std::vector<Vec3> points, std::vector<double> width,
                const link3d::Linker::Emit& emit) {
    at_ = points.back();
    const bool extruding = toolpath::extrudes(role);
    emit(toolpath::Span{role, stroke_, r.layer, r.region, std::move(points), std::move(width),
                        extruding ? std::vector<double>{r.height} : std::vector<double>{}});
}

} // namespace filum::baselines::sun2019
