#include "fill/ringed_zigzag.hpp"

#include "fill/attempt.hpp"
#include "fill/inset.hpp"
#include "fill/maze.hpp"
#include "fill/rows.hpp"
#include "fill/spiral.hpp"
#include "fill/thin.hpp"
#include "polygon/clip.hpp"

#include <limits>
#include <utility>

namespace filum::fill {

namespace {

struct RingedZigzagSetting {
    double tolerance; // bead widths
    double row;       // wanted height, bead widths
    int lanes;        // that share a wall's odd thickness; 0: no ring is moved
};

constexpr RingedZigzagSetting kRingedZigzagSettings[] = {
    {1.0 / 128, 2, 2}, {1.0 / 1024, 2, 2}, {1.0 / 1024, 2.12, 2}, {1.0 / 1024, 1.9, 2}, {1.0 / 1024, 2, 0}};

// Adds the rings of the first `levels` levels, `deeper` levels down; those without room for a link are left out.
void add_levels(const Rings& from, int levels, int deeper, double least, Rings& to) {
    for (std::size_t i = 0; i < from.loops.size(); ++i) {
        if (from.level[i] >= levels || (deeper > 0 && polygon::perimeter(from.loops[i]) < least)) continue;
        to.loops.add(from.loops[i]);
        to.level.push_back(from.level[i] + deeper);
    }
}

struct Layout {
    Loops outermost, core; // level 0; the area inside the outer rings' beads
    Rings rings;           // level 0 .. rings - 1
};

Layout outer_rings(const Loops& region, const RingedZigzagOptions& o, double tolerance) {
    const double w = o.bead_width, spacing = w * (1 - kRingOverlap);
    Layout out;
    out.outermost = first_rings(region, w, tolerance).rings;
    add_levels(nested_rings(out.outermost, spacing, kShortestRing * w, tolerance), o.rings, 0, 0, out.rings);
    out.core = inset(out.outermost, (o.rings - 1) * spacing + w / 2);
    return out;
}

// The corridors' outermost rings and what is inside those, as levels below the outer rings.
Rings with_core(const Layout& layout, const RingedZigzagOptions& o, const RingedZigzagSetting& t) {
    const double w = o.bead_width, spacing = w * (1 - kRingOverlap);
    Loops corridors;
    for (const auto& part : polygon::split(rotated(layout.core, -o.angle)).part) {
        const Loops corridor = maze(part, w, t.row * w);
        for (std::size_t i = 0; i < corridor.size(); ++i) corridors.add(corridor[i]);
    }
    const Loops first = inset(rotated(corridors, o.angle), w / 2 - (w - spacing));
    Rings out = layout.rings;
    add_levels(nested_rings(first, spacing, kShortestRing * w, t.tolerance * w), std::numeric_limits<int>::max(),
               o.rings, kShortestRing * w, out);
    return out;
}

// Most of some places on the loop lie in the area.
bool mostly_inside(const Loops& area, std::span<const Vec2> loop) {
    constexpr std::size_t places = 15;
    std::size_t inside = 0;
    for (std::size_t k = 0; k < places; ++k) inside += polygon::contains(area, loop[k * loop.size() / places]) ? 1 : 0;
    return 2 * inside > places;
}

// Each outer ring by itself, then the core's rings joined.
std::vector<toolpath::Curve> unlinked(const Loops& region, const Loops& core, const BeadRings& beads, double width) {
    std::vector<toolpath::Curve> out;
    BeadRings inner;
    for (std::size_t i = 0; i < beads.loops.size(); ++i) {
        const auto loop = beads.loops[i];
        const std::vector<double> widths(beads.width.begin() + beads.loops.start[i],
                                         beads.width.begin() + beads.loops.start[i + 1]);
        if (!mostly_inside(core, loop)) {
            out.push_back({true, {loop.begin(), loop.end()}, widths});
            continue;
        }
        inner.loops.add(loop);
        inner.width.insert(inner.width.end(), widths.begin(), widths.end());
    }
    for (toolpath::Curve& curve : closed_curves(join_rings(inner, width, region))) out.push_back(std::move(curve));
    return out;
}

Attempt ringed_zigzag_by(const Loops& region, const RingedZigzagOptions& o, const RingedZigzagSetting& t) {
    const double w = o.bead_width, tolerance = t.tolerance * w;
    const Layout layout = outer_rings(region, o, tolerance);
    const BeadRings beads = even_spacing(with_core(layout, o, t), region, w, t.lanes, tolerance);
    Attempt out{{}, 0, layout.outermost};
    if (o.linked)
        out.curves = closed_curves(join_rings(beads, w, region));
    else
        out.curves = unlinked(region, layout.core, beads, w);
    out.crossings = count_crossings(out.curves, w);
    return out;
}

} // namespace

std::vector<toolpath::Curve> ringed_zigzag(const Loops& region, const RingedZigzagOptions& o, Notes& notes) {
    const double w = o.bead_width;
    Attempt best = best_attempt(std::span<const RingedZigzagSetting>(kRingedZigzagSettings), o.linked,
                                [&](const RingedZigzagSetting& s) { return ringed_zigzag_by(region, o, s); });
    if (o.linked) note_unjoined(best.curves, notes);
    note_unplaced(region, inset(best.outermost, -(0.5 + 1.0 / 32) * w), w, notes);
    return std::move(best.curves);
}

} // namespace filum::fill
