#include "metrics/planar/cover.hpp"

#include "metrics/planar/cover_tiles.hpp"
#include "metrics/planar/row_sections.hpp"

#include <algorithm>
#include <cmath>

namespace filum::metrics::planar {

namespace {

using geom::Vec2;

using Edge = OutlineEdge;

std::vector<Edge> edges(std::span<const polygon::Loops* const> outline) {
    std::vector<Edge> out;
    for (std::uint32_t s = 0; s < outline.size(); ++s) {
        for (std::size_t i = 0; outline[s] != nullptr && i < outline[s]->size(); ++i) {
            const auto loop = (*outline[s])[i];
            for (std::size_t k = 0, j = loop.size() - 1; k < loop.size(); j = k++) {
                out.push_back(loop[j].y < loop[k].y ? Edge{loop[j], loop[k], s} : Edge{loop[k], loop[j], s});
            }
        }
    }
    std::sort(out.begin(), out.end(), [](const Edge& p, const Edge& q) { return p.lo.y < q.lo.y; });
    return out;
}

// The section of the outlines with the row at y. Crossings of one slot form pairs.
void part_row(std::span<const Edge> all, const std::vector<std::uint32_t>& active, double y,
              std::vector<Interval>& out) {
    out.clear();
    for (const auto i : active) {
        const Edge& e = all[i];
        const double x = e.lo.x + (e.hi.x - e.lo.x) * ((y - e.lo.y) / (e.hi.y - e.lo.y));
        out.push_back({x, x, e.slot});
    }
    std::sort(out.begin(), out.end(),
              [](const Interval& p, const Interval& q) { return p.slot != q.slot ? p.slot < q.slot : p.lo < q.lo; });
    for (std::size_t i = 0; i + 1 < out.size(); i += 2) out[i / 2] = {out[i].lo, out[i + 1].lo, out[i].slot};
    out.resize(out.size() / 2);
}

Rows rows(std::span<const SweptBead> lanes, std::span<const Edge> edges, double spacing) {
    double lo = INFINITY, hi = -INFINITY, part_lo = INFINITY, part_hi = -INFINITY;
    for (const Edge& e : edges) {
        part_lo = std::min(part_lo, e.lo.y);
        part_hi = std::max(part_hi, e.hi.y);
    }
    for (const SweptBead& l : lanes) {
        lo = std::min(lo, l.lo);
        hi = std::max(hi, l.hi);
    }
    lo = std::min(lo, part_lo);
    hi = std::max(hi, part_hi);
    if (!(hi > lo)) return {};
    Rows out;
    out.spacing = std::max(spacing, (hi - lo) / kMostRows);
    const double origin = part_lo < part_hi ? part_lo : lo;
    const double height = part_lo < part_hi ? part_hi - part_lo : hi - lo;
    const double even = height / std::ceil(height / out.spacing);
    if ((hi - lo) / even <= 2 * kMostRows) out.spacing = even;
    const double below = std::ceil((origin - lo) / out.spacing);
    out.first = origin + (0.5 - below) * out.spacing;
    out.count = static_cast<std::size_t>(std::ceil((hi - out.first) / out.spacing)) + 1;
    return out;
}

} // namespace

void tally(const std::vector<Interval>& part, const std::vector<Interval>& beads, double dy, std::span<Cover> sum) {
    for (const Interval& p : part) sum[p.slot].area += dy * (p.hi - p.lo);
    for (const Interval& b : beads) sum[b.slot].united += dy * (b.hi - b.lo);
    for (std::size_t p = 0, b = 0; p < part.size() && b < beads.size();) {
        if (part[p].slot != beads[b].slot) {
            ++(part[p].slot < beads[b].slot ? p : b);
            continue;
        }
        const double both = std::min(part[p].hi, beads[b].hi) - std::max(part[p].lo, beads[b].lo);
        if (both > 0) sum[part[p].slot].covered += dy * both;
        ++(part[p].hi < beads[b].hi ? p : b);
    }
}

LayerCover cover(std::span<const Bead> beads, std::span<const polygon::Loops* const> outline, double spacing) {
    LayerCover out;
    out.slot.resize(outline.size());
    for (const Bead& b : beads) out.slot[b.slot].deposited += geom::distance(b.a, b.b) * b.width * b.thick;
    for (const Cover& s : out.slot) out.whole.deposited += s.deposited;
    const auto lane = swept_beads(beads);
    const auto edge = edges(outline);
    const Rows row = rows(lane, edge, spacing);
    if (outline.size() == 1 && tiles_pay(lane, row)) {
        const Cover by_tiles = cover_by_tiles(lane, edge, row);
        Cover& whole = out.slot.front();
        out.whole = whole = {by_tiles.area, by_tiles.covered, by_tiles.united, whole.deposited};
        return out;
    }
    RowSweep sweep(lane);
    std::vector<std::uint32_t> live_edges;
    std::vector<Interval> part, laid;
    std::size_t next_edge = 0;
    for (std::size_t j = 0; j < row.count; ++j) {
        const double y = row.at(j);
        for (; next_edge < edge.size() && edge[next_edge].lo.y < y; ++next_edge)
            live_edges.push_back(static_cast<std::uint32_t>(next_edge));
        std::erase_if(live_edges, [&](std::uint32_t i) { return edge[i].hi.y < y; });
        sweep.move_to(y, laid);
        part_row(edge, live_edges, y, part);
        tally(part, laid, row.spacing, out.slot);
        if (outline.size() == 1) continue; // the whole is that slot
        for (Interval& i : part) i.slot = 0;
        for (Interval& i : laid) i.slot = 0;
        unite(part);
        unite(laid);
        tally(part, laid, row.spacing, {&out.whole, 1});
    }
    if (outline.size() == 1) out.whole = out.slot.front();
    return out;
}

} // namespace filum::metrics::planar
