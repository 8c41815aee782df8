#include "route/dense.hpp"

#include <algorithm>
#include <cmath>

namespace filum::route {

namespace {

using toolpath::Span;

Vec3 normal(const Span& s, std::size_t i) { return s.normals.empty() ? Vec3{0, 0, 1} : s.normals[i]; }

Vec3 unit_across(const Vec3& v, const Vec3& n) {
    const Vec3 flat = v - dot(v, n) * n;
    return norm(flat) > 1e-9 * norm(v) && norm(v) > 0 ? 1 / norm(flat) * flat : Vec3{};
}

Vec3 any_across(const Vec3& n) { return unit_across(std::abs(n.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, n); }

// Per segment of all spans whether it is within `reach` mm of a blocked one.
std::vector<std::vector<bool>> reached(const Stroke& stroke, double reach) {
    std::vector<std::vector<bool>> near;
    for (const auto& b : stroke.blocked) near.emplace_back(b.size(), false);
    const auto sweep = [&](bool forward) {
        double since = reach + 1; // mm since the last blocked segment
        for (std::size_t n = stroke.spans.size(), k = 0; k < n; ++k) {
            const std::size_t s = forward ? k : n - 1 - k;
            const auto& points = stroke.spans[s].points;
            for (std::size_t m = near[s].size(), j = 0; j < m; ++j) {
                const std::size_t i = forward ? j : m - 1 - j;
                if (stroke.blocked[s][i]) since = 0;
                if (since <= reach) near[s][i] = true;
                if (!stroke.blocked[s][i]) since += distance(points[i], points[i + 1]);
            }
        }
    };
    sweep(true);
    sweep(false);
    return near;
}

// Transports the frames from point to point.
void carry(std::vector<DensePoint>& points) {
    Vec3 along{};
    for (std::size_t i = 1; i < points.size() && along == Vec3{}; ++i)
        along = unit_across(points[i].tip - points[0].tip, points[0].normal);
    for (DensePoint& p : points) {
        along = unit_across(along, p.normal);
        if (along == Vec3{}) along = any_across(p.normal);
        p.along = along;
    }
}

bool varies(const Span& s) { return s.width.size() > 1 || s.height.size() > 1; }

// Width and height of a point between two others: the area of the section and the height are interpolated.
std::pair<double, double> section(const Span& s, std::size_t i, double share) {
    const double h0 = s.height_at(i), h1 = s.height_at(i + 1), h = h0 + share * (h1 - h0);
    const double a0 = s.width_at(i) * h0, a1 = s.width_at(i + 1) * h1;
    return {h > 0 ? (a0 + share * (a1 - a0)) / h : s.width_at(i), h};
}

} // namespace

DenseStroke densified(const Stroke& stroke, double reach, double spacing) {
    const auto near = reached(stroke, reach);
    DenseStroke out;
    double arc = 0;
    for (std::uint32_t s = 0; s < stroke.spans.size(); ++s) {
        const Span& span = stroke.spans[s];
        const auto& before = stroke.before[s];
        const bool first = !near[s].empty() && near[s].front();
        out.points.push_back(
            {span.points[0], normal(span, 0), {}, arc, before.empty() ? 0 : before[0], first, s, 0, 0});
        for (std::uint32_t i = 0; i + 1 < span.points.size(); ++i) {
            const double length = distance(span.points[i], span.points[i + 1]);
            const auto parts = near[s][i] ? static_cast<std::uint32_t>(std::max(1.0, std::ceil(length / spacing))) : 1;
            const collision::Move move{{span.points[i], normal(span, i)}, {span.points[i + 1], normal(span, i + 1)}};
            for (std::uint32_t k = 1; k <= parts; ++k) {
                const double share = static_cast<double>(k) / parts;
                const auto at = k == parts ? move.to : collision::at(move, share);
                out.points.push_back({at.tip, at.axis, {}, arc + share * length, before[i], near[s][i], s, i, share});
            }
            arc += length;
        }
    }
    carry(out.points);
    return out;
}

Vec3 tilted(const DensePoint& p, const geom::Vec2& tilt) {
    const double angle = norm(tilt);
    if (angle == 0) return p.normal;
    const Vec3 aside = cross(p.normal, p.along), to = (1 / angle) * (tilt.x * p.along + tilt.y * aside);
    const Vec3 out = std::cos(angle) * p.normal + std::sin(angle) * to;
    return 1 / norm(out) * out;
}

TiltedStroke with_tilts(const DenseStroke& dense, const Stroke& stroke, const std::vector<geom::Vec2>& tilts) {
    TiltedStroke out;
    for (const Span& s : stroke.spans) {
        Span span = s;
        span.points.clear();
        span.normals.clear();
        if (varies(s)) {
            span.width.clear();
            span.height.clear();
        }
        out.spans.push_back(std::move(span));
        out.origin.emplace_back();
    }
    std::vector<bool> leans(out.spans.size(), false);
    for (std::size_t i = 0; i < dense.points.size(); ++i) {
        const DensePoint& p = dense.points[i];
        const Span& from = stroke.spans[p.span];
        Span& to = out.spans[p.span];
        leans[p.span] = leans[p.span] || norm2(tilts[i]) > 0;
        if (!to.points.empty()) out.origin[p.span].push_back(p.segment);
        const bool given = to.points.empty() || p.share == 1;
        const std::size_t at = p.segment + (to.points.empty() ? 0 : 1);
        to.points.push_back(p.tip);
        to.normals.push_back(tilted(p, tilts[i]));
        if (!varies(from)) continue;
        const auto [w, h] =
            given ? std::pair{from.width_at(at), from.height_at(at)} : section(from, p.segment, p.share);
        to.width.push_back(w);
        to.height.push_back(h);
    }
    for (std::size_t s = 0; s < out.spans.size(); ++s)
        if (!leans[s] && stroke.spans[s].normals.empty()) out.spans[s].normals.clear();
    return out;
}

} // namespace filum::route
