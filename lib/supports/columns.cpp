#include "supports/columns.hpp"

#include "parallel/parallel.hpp"
#include "polygon/clip.hpp"

#include <algorithm>
#include <cmath>

namespace filum::supports {

namespace {

using polygon::kBeadArc;

constexpr double kLeast = 0.25; // bead widths: an overhang nowhere twice as wide is none
constexpr double kReach = 0.5;  // bead widths that supports reach beyond an overhang: its outer bead has a place to lie
constexpr double kMerge = 2;    // bead widths: supports nearer than twice that are one
constexpr double kThin = 1;     // bead widths: a support nowhere twice as wide is none

Loops less(const Loops& a, const Loops& b) { return a.empty() || b.empty() ? a : polygon::subtract(a, b); }

Loops both(const Loops& a, const Loops& b) { return a.empty() || b.empty() ? Loops{} : polygon::intersect(a, b); }

Loops grown(const Loops& a, double by) { return polygon::offset(a, by, kBeadArc); }

// What of layer j supports must keep away from: the part in this layer, and what lies within the gap above and below.
Loops kept_free(const std::vector<Loops>& layers, std::size_t j, const Options& o) {
    Loops out = grown(layers[j], o.beside);
    const auto gap = static_cast<std::size_t>(o.gap);
    for (std::size_t k = 1; k <= gap; ++k) {
        if (j + k < layers.size()) out.add(layers[j + k]);
        if (j >= k) out.add(layers[j - k]);
    }
    return polygon::unite(out);
}

} // namespace

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

Columns columns(const std::vector<Loops>& layers, const std::vector<Loops>& over, const Options& o) {
    const std::size_t n = layers.size(), gap = static_cast<std::size_t>(o.gap);
    std::vector<Loops> free(n);
    parallel::for_chunks(n, 1, 0, [&](std::size_t j, std::size_t) { free[j] = kept_free(layers, j, o); });
    const double merge = kMerge * o.bead_width, thin = kThin * o.bead_width;
    Columns out{std::vector<Loops>(n), std::vector<Loops>(n)};
    Loops down; // what is to be carried from here, before the part is cut out
    for (std::size_t j = n; j-- > 0;) {
        const std::size_t from = j + 1 + gap;
        if (from < n && !over[from].empty()) {
            down.add(over[from]);
            down = polygon::unite(down);
            down = polygon::closed(down, merge, kBeadArc);
        }
        if (down.empty()) continue;
        down = less(down, layers[j]);
        out.all[j] = polygon::opened(less(down, free[j]), thin, kBeadArc);
        down = polygon::simplify(down, kBeadArc);
    }
    if (!o.on_part) { // only what goes down to the bed
        Loops stands = out.all.empty() ? Loops{} : out.all[0];
        for (std::size_t j = 1; j < n; ++j) {
            stands = both(out.all[j], stands);
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
