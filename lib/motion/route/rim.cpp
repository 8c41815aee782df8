#include "route/rim.hpp"

#include "geom/vec.hpp"

#include <algorithm>
#include <array>

namespace filum::route {

namespace {

using geom::Vec2;
using geom::Vec3;
using toolpath::Span;

// The point above the nearest side of the box, `away` mm outside.
Vec3 beside(const geom::Box3& box, Vec2 p, double away, double z) {
    const std::array<double, 4> off{p.x - box.lo.x, box.hi.x - p.x, p.y - box.lo.y, box.hi.y - p.y};
    switch (std::min_element(off.begin(), off.end()) - off.begin()) {
    case 0:
        return {box.lo.x - away, p.y, z};
    case 1:
        return {box.hi.x + away, p.y, z};
    case 2:
        return {p.x, box.lo.y - away, z};
    default:
        return {p.x, box.hi.y + away, z};
    }
}

Span travel(const Span& beside, std::vector<Vec3> points) {
    Span out;
    out.role = toolpath::Role::travel;
    out.stroke = beside.stroke;
    out.layer = beside.layer;
    out.region = beside.region;
    out.tool = beside.tool;
    out.body = beside.body;
    out.normals.assign(points.size(), {0, 0, 1});
    out.points = std::move(points);
    return out;
}

} // namespace

void add_rim_ways(std::vector<Span>& spans, const machine::Heads& heads, double over) {
    const auto lays = [](const Span& s) { return toolpath::extrudes(s.role); };
    const auto first = std::find_if(spans.begin(), spans.end(), lays);
    if (first == spans.end()) return;
    const auto last = std::find_if(spans.rbegin(), spans.rend(), lays).base();
    geom::Box3 box;
    double widest = 0;
    for (auto s = first; s != last; ++s) {
        for (const Vec3& p : s->points) box.add(p);
        for (const double w : s->width) widest = std::max(widest, w);
    }
    const double height = box.hi.z - box.lo.z;
    const auto away = [&](std::uint32_t tool) { return heads.of(tool).cone_radius(height) + widest / 2 + over; };
    const Vec3 from = first->points.front(), to = std::prev(last)->points.back();
    const Vec3 in = beside(box, from.xy(), away(first->tool), box.hi.z + over);
    const Vec3 out = beside(box, to.xy(), away(std::prev(last)->tool), box.hi.z + over);
    const Span before = travel(*first, {in, {in.x, in.y, from.z}, from}), after = travel(*std::prev(last), {to, out});
    std::vector<Span> printed(first, last);
    printed.insert(printed.begin(), before);
    printed.push_back(after);
    spans = std::move(printed);
}

} // namespace filum::route
