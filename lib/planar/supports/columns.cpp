#include "supports/columns.hpp"

#include "parallel/parallel.hpp"
#include "polygon/clip.hpp"

#include <algorithm>
#include <cmath>

namespace filum::supports {

namespace {

using polygon::kBeadArc;

constexpr double kLeast = 0.25; // bead widths: an overhang nowhere twice as wide does not count
constexpr double kReach = 0.5;  // bead widths that supports extend beyond an overhang, to carry its outer bead
constexpr double kMerge = 2;    // bead widths: supports nearer than twice this are merged
constexpr double kThin = 1;     // bead widths: a support nowhere twice as wide is left out
constexpr double kHang = 0.5;   // bead widths: largest sideways step of a column from layer to layer
constexpr double kSlender = 10; // height by width of a tapered column, at most: a nozzle may push it

Loops less(const Loops& a, const Loops& b) { return a.empty() || b.empty() ? a : polygon::subtract(a, b); }

Loops both(const Loops& a, const Loops& b) { return a.empty() || b.empty() ? Loops{} : polygon::intersect(a, b); }

Loops grown(const Loops& a, double by) { return polygon::offset(a, by, kBeadArc); }

// The area of layer j without supports: around the part in this layer, and where the part is within the gap above or
// below. Its loops may overlap.
Loops kept_free(const std::vector<Loops>& layers, std::size_t j, const Options& o) {
    Loops out = grown(layers[j], o.beside);
    const auto gap = static_cast<std::size_t>(o.gap);
    for (std::size_t k = 1; k <= gap; ++k) {
        if (j + k < layers.size()) out.add(layers[j + k]);
        if (j >= k) out.add(layers[j - k]);
    }
    return out;
}

// One column in the current layer, before the gaps to the part are cut out. Its top lies at `top` mm.
struct ColumnSection {
    Loops area;
    double top = 0;
};

// Adds `over` at height `top` to `pieces`. Pieces nearer than twice `merge` become one, with the highest `top` of them.
void join(std::vector<ColumnSection>& pieces, const Loops& over, double top, double merge) {
    pieces.push_back({over, top});
    Loops all;
    for (const ColumnSection& p : pieces) all.add(p.area);
    std::vector<ColumnSection> out;
    for (Loops& area : polygon::split(polygon::closed(polygon::unite(all), merge, kBeadArc)).part) {
        double highest = 0;
        for (const ColumnSection& p : pieces)
            if (p.top > highest && !both(area, p.area).empty()) highest = p.top;
        out.push_back({std::move(area), highest});
    }
    pieces = std::move(out);
}

// The cross-section one layer below `a`: its outline moves inwards by `by` mm. Where it would become narrower than
// `width` it stays as it is.
Loops tapered(const Loops& a, double by, double width) {
    if (by <= 0) return a;
    // The wide part of the inner outline is the inner outline, opened by half of the width. Shrinking by two distances
    // after each other is shrinking by their sum, and so is growing.
    const Loops core = polygon::offset(a, -by - width / 2, kBeadArc);
    if (core.empty()) return a;
    const Loops inner = polygon::offset(a, -by, kBeadArc), narrow = less(a, grown(core, width + by));
    return narrow.empty() ? inner : polygon::unite(inner, narrow);
}

} // namespace

double taper(double height, const Options& o) { return std::min(height * std::tan(o.taper), kHang * o.bead_width); }

std::vector<Loops> overhangs(const std::vector<Loops>& layers, const std::vector<double>& height, const Options& o) {
    std::vector<Loops> out(layers.size());
    const double least = kLeast * o.bead_width;
    parallel::for_chunks(layers.size(), 1, 0, [&](std::size_t i, std::size_t) {
        if (i == 0 || layers[i].empty() || layers[i].points == layers[i - 1].points) return;
        const double carried = std::max(height[i] * std::tan(o.angle), 1e-3);
        Loops over = less(layers[i], grown(layers[i - 1], carried));
        over = grown(grown(over, -least), least + carried + kReach * o.bead_width);
        out[i] = both(over, grown(layers[i], kReach * o.bead_width));
    });
    return out;
}

Columns columns(const std::vector<Loops>& layers, const std::vector<double>& height, const std::vector<Loops>& over,
                const Options& o) {
    const std::size_t n = layers.size(), gap = static_cast<std::size_t>(o.gap);
    std::vector<double> top(n, 0);
    for (std::size_t j = 0; j < n; ++j) top[j] = (j > 0 ? top[j - 1] : 0) + height[j];
    const double merge = kMerge * o.bead_width, thin = kThin * o.bead_width;
    Columns out{std::vector<Loops>(n), std::vector<Loops>(n)};
    std::vector<ColumnSection> down;
    for (std::size_t j = n; j-- > 0;) {
        const double by = j + 1 < n ? taper(height[j + 1], o) : 0;
        parallel::for_chunks(down.size(), 1, 0, [&](std::size_t k, std::size_t) {
            down[k].area = tapered(down[k].area, by, std::max(2 * merge, down[k].top / kSlender));
        });
        if (const std::size_t from = j + 1 + gap; from < n && !over[from].empty())
            join(down, over[from], top[j], merge);
        for (ColumnSection& p : down) {
            p.area = polygon::simplify(less(p.area, layers[j]), kBeadArc);
            out.all[j].add(p.area);
        }
        std::erase_if(down, [](const ColumnSection& p) { return p.area.empty(); });
    }
    parallel::for_chunks(n, 1, 0, [&](std::size_t j, std::size_t) {
        if (!out.all[j].empty())
            out.all[j] = polygon::opened(less(out.all[j], kept_free(layers, j, o)), thin, kBeadArc);
    });
    if (!o.on_part) { // keep only columns that stand on the bed
        Loops stands = out.all.empty() ? Loops{} : out.all[0];
        for (std::size_t j = 1; j < n; ++j) {
            stands = both(out.all[j], stands.empty() ? stands : grown(stands, taper(height[j], o)));
            out.all[j] = stands = polygon::opened(stands, thin, kBeadArc);
        }
    }
    const auto near = static_cast<std::size_t>(o.interface);
    parallel::for_chunks(n, 1, 0, [&](std::size_t j, std::size_t) {
        if (out.all[j].empty()) return;
        Loops above;
        for (std::size_t k = 1; k <= near && j + gap + k < n; ++k) above.add(over[j + gap + k]);
        if (!above.empty()) out.interface[j] = both(out.all[j], polygon::unite(above));
    });
    return out;
}

} // namespace filum::supports
