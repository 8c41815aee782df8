// Paths by rule, for the tests of criteria.
#pragma once

#include "../../../shapes/geodesic/surfaces.hpp"
#include "metrics/surface/report.hpp"

namespace paths {

using filum::geom::Vec2;
using filum::geom::Vec3;
using filum::surface::Surface;
using filum::toolpath::Role;
using filum::toolpath::Span;

inline Span span(std::vector<Vec3> points, double width = 1, Role role = Role::bead) {
    return {.role = role, .points = std::move(points), .width = {width}, .height = {0.2}};
}

inline filum::metrics::surface::Fibres fibres(const std::vector<Span>& spans) {
    filum::metrics::surface::Fibres out;
    for (const Span& s : spans) add(out, s);
    return out;
}

inline std::vector<Vec3> lifted(const std::vector<Vec2>& flat, const std::function<Vec3(Vec2)>& lift) {
    std::vector<Vec3> out;
    for (const Vec2& p : flat) out.push_back(lift(p));
    return out;
}

// An arc from `from` to `to` (rad) with points as the ways between them, mm, which `next` gives.
inline std::vector<Vec2> arc(Vec2 centre, double radius, double from, double to, const std::function<double()>& next) {
    std::vector<Vec2> out;
    const double sense = to > from ? 1 : -1;
    for (double a = from; sense * (to - a) > 1e-9; a += sense * next() / radius)
        out.push_back({centre.x + radius * std::cos(a), centre.y + radius * std::sin(a)});
    out.push_back({centre.x + radius * std::cos(to), centre.y + radius * std::sin(to)});
    return out;
}

// Rows along x from x0 to x1 at y = y0, y0 + d, ..., n of them, joined by half circles of points `step` mm apart.
inline std::vector<Vec2> zigzag(double x0, double x1, double y0, double d, int n, double step = 0.02) {
    std::vector<Vec2> out;
    for (int i = 0; i < n; ++i) {
        const double y = y0 + i * d;
        out.push_back({i % 2 == 0 ? x0 : x1, y});
        out.push_back({i % 2 == 0 ? x1 : x0, y});
        if (i + 1 == n) break;
        const double half = std::numbers::pi / 2;
        const auto turn = i % 2 == 0 ? arc({x1, y + d / 2}, d / 2, -half, half, [&] { return step; })
                                     : arc({x0, y + d / 2}, d / 2, -half, -3 * half, [&] { return step; });
        out.insert(out.end(), turn.begin() + 1, turn.end() - 1);
    }
    return out;
}

inline std::vector<Span> parallel(double x0, double x1, double y0, double d, int n, double width = 1) {
    std::vector<Span> out;
    for (int i = 0; i < n; ++i) out.push_back(span({{x0, y0 + i * d, 0}, {x1, y0 + i * d, 0}}, width));
    return out;
}

inline double number(const filum::figures::Figures& figures, const std::string& name, const std::string& group = "") {
    for (const auto& f : figures)
        if (f.name == name && (group.empty() || f.group == group)) {
            if (const auto* n = std::get_if<std::uint64_t>(&f.value)) return static_cast<double>(*n);
            return std::get<double>(f.value);
        }
    return NAN;
}

inline filum::figures::Figures measure(const Surface& s, const std::vector<Span>& spans,
                                       const filum::metrics::surface::Options& options = {}, int threads = 1) {
    filum::surface::Sheet sheet;
    sheet.surface = s;
    return filum::metrics::surface::measure(fibres(spans), sheet, options, false, threads).figures;
}

} // namespace paths
