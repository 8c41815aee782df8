#include "metrics/planar/layers.hpp"

#include "base/density.hpp"
#include "base/number.hpp"
#include "metrics/planar/row_sections.hpp"
#include "parallel/parallel.hpp"

#include <algorithm>

namespace filum::metrics::planar {

namespace {

constexpr double kMostSections = 1e9; // places where a row cuts a bead or an outline: half a minute of work

// The inputs of one layer.
struct LayerInput {
    std::uint32_t layer = 0;
    const LayerBeads* beads = nullptr; // null: none
    std::vector<const polygon::Region*> regions;
};

std::vector<LayerInput> layer_inputs(const Beads& beads, const std::vector<polygon::Region>& regions) {
    std::map<std::uint32_t, LayerInput> by_layer;
    for (const auto& r : regions) by_layer[r.layer].regions.push_back(&r);
    for (const auto& [layer, b] : beads.layer) by_layer[layer].beads = &b;
    std::vector<LayerInput> out;
    for (auto& [layer, work] : by_layer) {
        work.layer = layer;
        out.push_back(std::move(work));
    }
    return out;
}

// One entry per region of the layer, with or without an outline.
std::vector<RegionFigures> region_rows(const LayerInput& w) {
    std::map<std::uint32_t, RegionFigures> rows;
    for (const auto* r : w.regions) {
        RegionFigures f;
        f.region = r->id;
        f.layer = w.layer;
        f.known = true;
        f.at = r->loops.points.front();
        rows[r->id] = f;
    }
    for (std::size_t k = 0; w.beads != nullptr && k < w.beads->runs.size(); ++k) {
        const BeadRun& p = w.beads->runs[k];
        RegionFigures f;
        f.region = p.region;
        f.layer = w.layer;
        f.at = w.beads->points[p.first];
        RegionFigures& row = rows.try_emplace(p.region, f).first->second;
        if (p.role != toolpath::Role::connector && !p.continues) ++row.curves;
    }
    std::vector<RegionFigures> out;
    for (const auto& [id, row] : rows) out.push_back(row);
    return out;
}

std::vector<Bead> spread(const LayerBeads& from, std::vector<RegionFigures>& rows) {
    std::vector<Bead> out;
    out.reserve(from.points.size());
    for (std::size_t k = 0; k < from.runs.size(); ++k) {
        const BeadRun& p = from.runs[k];
        const auto row = std::lower_bound(rows.begin(), rows.end(), p.region,
                                          [](const RegionFigures& r, std::uint32_t id) { return r.region < id; });
        const auto slot = static_cast<std::uint32_t>(row - rows.begin());
        for (std::size_t i = p.first; i + 1 < from.end(k); ++i) {
            out.push_back({from.points[i], from.points[i + 1], from.width[i], slot,
                           p.order + static_cast<std::uint32_t>(i - p.first)});
            out.back().thick = static_cast<float>(from.thickness(i));
            if (!from.z.empty()) {
                out.back().from_z = from.z[i];
                out.back().to_z = from.z[i + 1];
            }
            row->length += geom::distance(from.points[i], from.points[i + 1]);
            ++row->segments;
        }
    }
    return out;
}

double row_spacing(std::span<const Bead> beads, double pixel) {
    if (pixel > 0) return pixel;
    double length = 0, area = 0;
    for (const Bead& b : beads) {
        const double l = geom::distance(b.a, b.b);
        length += l;
        area += l * b.width;
    }
    return (length > 0 ? area / length : 0.4) / 16;
}

LayerFigures measure(const LayerInput& w, double pixel) {
    LayerFigures out;
    out.layer = w.layer;
    if (!w.regions.empty()) out.z = w.regions.front()->z;
    out.regions = region_rows(w);
    std::vector<Bead> beads;
    if (w.beads != nullptr) beads = spread(*w.beads, out.regions);
    std::vector<const polygon::Loops*> outline(out.regions.size(), nullptr);
    for (const auto* r : w.regions) {
        const auto row = std::lower_bound(out.regions.begin(), out.regions.end(), r->id,
                                          [](const RegionFigures& f, std::uint32_t id) { return f.region < id; });
        outline[static_cast<std::size_t>(row - out.regions.begin())] = &r->loops;
    }
    const LayerCover areas = cover(beads, outline, row_spacing(beads, pixel));
    const Crossings crossed = crossings(beads, outline.size(), w.beads != nullptr ? w.beads->height : 0);
    out.cover = areas.whole;
    out.crossings = crossed.whole;
    out.crossing = crossed.place;
    for (std::size_t k = 0; k < out.regions.size(); ++k) {
        out.regions[k].cover = areas.slot[k];
        out.regions[k].crossings = crossed.slot[k];
    }
    return out;
}

struct Heights {
    double box = 0, sum = 0; // mm along y: of the box of all, and of its parts one by one
};

Heights heights(const LayerInput& w) {
    geom::Box2 box;
    double sum = 0;
    const auto add = [&](Vec2 a, Vec2 b, double width) {
        for (const Vec2 p : {a, b}) {
            box.add({p.x, p.y - width / 2});
            box.add({p.x, p.y + width / 2});
        }
        sum += std::abs(b.y - a.y) + width;
    };
    for (std::size_t k = 0; w.beads != nullptr && k < w.beads->runs.size(); ++k)
        for (std::size_t i = w.beads->runs[k].first; i + 1 < w.beads->end(k); ++i)
            add(w.beads->points[i], w.beads->points[i + 1], w.beads->width[i]);
    for (const auto* r : w.regions)
        for (std::size_t i = 0; i < r->loops.size(); ++i) {
            const auto loop = r->loops[i];
            for (std::size_t k = 0, j = loop.size() - 1; k < loop.size(); j = k++) add(loop[j], loop[k], 0);
        }
    return {std::max(0.0, box.hi.y - box.lo.y), sum};
}

} // namespace

void check_pixel(const Beads& beads, const std::vector<polygon::Region>& regions, double pixel) {
    if (pixel == 0) return;
    Heights all;
    for (const auto& w : layer_inputs(beads, regions)) {
        const Heights h = heights(w);
        all.box = std::max(all.box, h.box);
        all.sum += h.sum;
    }
    const double least = std::max(all.box / kMostRows, all.sum / kMostSections);
    if (pixel >= least) return;
    throw Error(Exit::usage, "cannot use '" + shortest_text(pixel) + "' for --pixel: rows so close would cut " +
                                 fixed_text(all.sum, 0) + " mm of beads and outlines too often; give at least " +
                                 rounded_up(least) + " mm");
}

std::vector<LayerFigures> measure_layers(const Beads& beads, const std::vector<polygon::Region>& regions, double pixel,
                                         int threads) {
    const auto work = layer_inputs(beads, regions);
    std::vector<LayerFigures> out(work.size());
    parallel::for_chunks(work.size(), 1, threads,
                         [&](std::size_t i, std::size_t) { out[i] = measure(work[i], pixel); });
    return out;
}

} // namespace filum::metrics::planar
