#include "report/content.hpp"

#include "machine/feed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace filum::report {

namespace {

constexpr double kMicro = 1000;     // per mm
constexpr double kFieldTop = 65535; // largest number of a field's column

std::int32_t micro(double mm) {
    constexpr double most = std::numeric_limits<std::int32_t>::max();
    return static_cast<std::int32_t>(std::clamp(std::nearbyint(mm * kMicro), -most, most));
}

template <class Number>
std::int32_t whole(Number n) {
    return static_cast<std::int32_t>(n);
}

void begin_span(Content& to, const toolpath::Span& s) {
    to.spans.start.push_back(whole(to.points.x.size()));
    to.spans.role.push_back(whole(s.role));
    to.spans.feature.push_back(whole(s.feature));
    to.spans.stroke.push_back(whole(s.stroke));
    to.spans.layer.push_back(whole(s.layer));
    to.spans.tool.push_back(whole(s.tool));
    to.spans.retraction.push_back(whole(s.retraction));
}

void add_normal(Points& to, const geom::Vec3& n) {
    to.nx.resize(to.x.size() - 1, 0); // earlier points belong to spans with an upright tool
    to.ny.resize(to.x.size() - 1, 0);
    to.nz.resize(to.x.size() - 1, whole(kMicro));
    to.nx.push_back(micro(n.x));
    to.ny.push_back(micro(n.y));
    to.nz.push_back(micro(n.z));
}

void add_loop(Outlines& to, std::span<const geom::Vec2> loop, std::uint32_t layer, double z, std::uint32_t stroke) {
    to.start.push_back(whole(to.x.size()));
    to.layer.push_back(whole(layer));
    to.z.push_back(micro(z));
    to.stroke.push_back(whole(stroke));
    for (const geom::Vec2& p : loop) {
        to.x.push_back(micro(p.x));
        to.y.push_back(micro(p.y));
    }
}

Field field(const surface::Field& from) {
    Field out;
    out.name = from.name;
    const std::size_t n = from.values.size() / from.components;
    std::vector<double> values(n);
    out.low = std::numeric_limits<double>::infinity();
    out.high = -out.low;
    for (std::size_t v = 0; v < n; ++v) {
        values[v] = from.components == 3 ? norm(from.vector(v)) : from.values[v];
        if (!std::isfinite(values[v])) continue;
        out.low = std::min(out.low, values[v]);
        out.high = std::max(out.high, values[v]);
    }
    const double scale = out.high > out.low ? kFieldTop / (out.high - out.low) : 0;
    for (const double v : values)
        out.value.push_back(std::isfinite(v) ? whole(std::nearbyint((v - out.low) * scale)) : -1);
    if (!(out.low <= out.high)) out.low = out.high = 0;
    return out;
}

} // namespace

void add(Content& to, const toolpath::Span& s, const machine::Profile* profile) {
    begin_span(to, s);
    Points& p = to.points;
    const bool lays = toolpath::extrudes(s.role);
    for (std::size_t i = 0; i < s.points.size(); ++i) {
        p.x.push_back(micro(s.points[i].x));
        p.y.push_back(micro(s.points[i].y));
        p.z.push_back(micro(s.points[i].z));
        p.width.push_back(lays ? std::max(1, micro(s.width_at(i))) : 0);
        p.height.push_back(lays ? std::max(1, micro(s.height_at(i))) : 0);
        const bool moves = lays && profile != nullptr && i + 1 < s.points.size();
        p.speed.push_back(moves ? micro(machine::bead_feed(*profile, machine::extruding_move(s, i))) : 0);
        if (!s.normals.empty()) add_normal(p, s.normals[i]);
    }
}

void add(Content& to, const toolpath::RegionPaths& paths, const machine::Profile* profile) {
    for (const toolpath::Curve& c : paths.curves) {
        toolpath::Span s;
        s.stroke = paths.stroke;
        s.layer = paths.layer;
        s.region = paths.region;
        for (const geom::Vec2& q : c.points) s.points.push_back({q.x, q.y, paths.z});
        s.width = c.width;
        if (c.closed) {
            s.points.push_back(s.points.front());
            if (s.width.size() > 1) s.width.push_back(s.width.front());
        }
        s.height = {paths.height};
        add(to, s, profile);
    }
}

void add(Content& to, const polygon::Region& r) {
    for (std::size_t k = 0; k < r.loops.size(); ++k) add_loop(to.outlines, r.loops[k], r.layer, r.z, r.stroke);
}

void add(Content& to, const polygon::Layer& l) {
    for (std::size_t k = 0; k < l.contours.size(); ++k) add_loop(to.outlines, l.contours[k], l.index, l.z, 0);
}

void add(Content& to, const surface::Sheet& sheet) {
    Surface s;
    for (const geom::Vec3& v : sheet.surface.vertices) {
        s.x.push_back(micro(v.x));
        s.y.push_back(micro(v.y));
        s.z.push_back(micro(v.z));
    }
    for (const auto& t : sheet.surface.triangles)
        for (const std::uint32_t corner : t) s.corner.push_back(whole(corner));
    for (const surface::Field& f : sheet.fields) s.fields.push_back(field(f));
    to.surfaces.push_back(std::move(s));
}

void add(Content& to, const Notes& notes) {
    std::map<std::int64_t, double> heights;
    for (std::size_t s = 0; s < to.spans.start.size(); ++s)
        heights.try_emplace(to.spans.layer[s], to.points.z[static_cast<std::size_t>(to.spans.start[s])] / kMicro);
    for (std::size_t k = 0; k < to.outlines.start.size(); ++k)
        heights.try_emplace(to.outlines.layer[k], to.outlines.z[k] / kMicro);
    for (const Note& n : notes) {
        if (!std::isfinite(n.x) || !std::isfinite(n.y)) continue;
        const auto found = heights.find(n.layer);
        const double z = std::isfinite(n.z) ? n.z : found != heights.end() ? found->second : 0;
        to.spots.push_back({std::string(name(grade(n))), n.stage + ": " + sentence(n), n.x, n.y, z, n.layer});
    }
}

} // namespace filum::report
