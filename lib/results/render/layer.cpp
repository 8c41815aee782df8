#include "render/layer.hpp"

namespace filum::render {

namespace {

void add(const toolpath::Span& s, std::uint32_t index, double& along, FlatLayer& out) {
    const bool bead = toolpath::extrudes(s.role);
    for (std::uint32_t i = 0; i + 1 < s.points.size(); ++i) {
        const geom::Vec2 a = s.points[i].xy(), b = s.points[i + 1].xy();
        const double w = bead ? (s.width_at(i) + s.width_at(i + 1)) / 2 : 0;
        if (a == b) continue;
        (bead ? out.beads : out.travels).push_back({a, b, w, along, index, i});
        if (!bead) continue;
        along += geom::distance(a, b);
        for (const geom::Vec2 p : {a, b}) {
            out.box.add({p.x - w / 2, p.y - w / 2});
            out.box.add({p.x + w / 2, p.y + w / 2});
        }
    }
}

} // namespace

FlatLayer flatten(const Scene& scene) {
    FlatLayer out;
    double along = 0, area = 0;
    bool open = false;
    geom::Vec3 last;
    for (std::uint32_t k = 0; k < scene.spans.size(); ++k) {
        const toolpath::Span& s = scene.spans[k];
        const bool bead = toolpath::extrudes(s.role);
        if (open && (!bead || !(s.points.front() == last))) {
            out.marks.push_back({Mark::Kind::end, last.xy()});
            open = false;
            along += 1e6; // mm; stretches across a gap never count as neighbours
        }
        if (s.role == toolpath::Role::lift) out.marks.push_back({Mark::Kind::lift, s.points.back().xy()});
        if (bead && !open) {
            out.marks.push_back({Mark::Kind::start, s.points.front().xy()});
            open = true;
        }
        add(s, k, along, out);
        last = s.points.back();
    }
    if (open) out.marks.push_back({Mark::Kind::end, last.xy()});
    double length = 0;
    for (const FlatBead& b : out.beads) {
        length += geom::distance(b.a, b.b);
        area += geom::distance(b.a, b.b) * b.width;
    }
    if (length > 0) out.width = area / length;
    for (const Outline& o : scene.outlines)
        for (const geom::Vec2 p : o.loops.points) out.box.add(p);
    return out;
}

Rgb mark_colour(Mark::Kind kind) {
    switch (kind) {
    case Mark::Kind::start:
        return oklch(0.62, 0.19, 150);
    case Mark::Kind::end:
        return oklch(0.25, 0.02, 260); // red is for voids
    case Mark::Kind::lift:
        return oklch(0.74, 0.18, 60);
    }
    return {};
}

} // namespace filum::render
