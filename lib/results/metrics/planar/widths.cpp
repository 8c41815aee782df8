#include "metrics/planar/widths.hpp"

#include <algorithm>
#include <cmath>

namespace filum::metrics::planar {

namespace {

// 1, 2 or 5 times a power of ten, not above v.
double nice(double v) {
    const double power = std::pow(10, std::floor(std::log10(v)));
    for (const double f : {5.0, 2.0})
        if (f * power <= v * (1 + 1e-9)) return f * power;
    return power;
}

} // namespace

Widths widths(const Beads& beads) {
    std::vector<std::pair<float, float>> all; // width, length
    for (const auto& [index, layer] : beads.layer)
        for (std::size_t k = 0; k < layer.runs.size(); ++k)
            for (std::size_t i = layer.runs[k].first; i + 1 < layer.end(k); ++i)
                if (layer.runs[k].role != toolpath::Role::connector)
                    all.emplace_back(layer.width[i],
                                     static_cast<float>(geom::distance(layer.points[i], layer.points[i + 1])));
    Widths out;
    if (all.empty()) return out;
    std::sort(all.begin(), all.end());
    double total = 0, area = 0;
    for (const auto& [w, l] : all) {
        total += l;
        area += static_cast<double>(w) * l;
    }
    out.min = all.front().first;
    out.max = all.back().first;
    out.mean = area / total;
    double sum = 0;
    for (const auto& [w, l] : all) {
        out.median = w;
        if ((sum += l) >= total / 2) break;
    }
    constexpr double kMostBins = 64;
    out.bin = nice(out.median / 8);
    const auto bin_of = [&](double w) { return std::floor(w / out.bin + 1e-4); }; // the float 0.4 becomes exactly 0.4
    out.first = bin_of(out.min) * out.bin;
    out.share.assign(static_cast<std::size_t>(std::min(kMostBins, bin_of(out.max) - bin_of(out.min) + 1)), 0);
    for (const auto& [w, l] : all) {
        const double at = std::min(bin_of(w) - bin_of(out.min), static_cast<double>(out.share.size() - 1));
        out.share[static_cast<std::size_t>(at)] += l / total;
    }
    return out;
}

SeamDistances seams(const Beads& beads, const std::vector<polygon::Region>& regions, double bead_width) {
    struct Start {
        std::uint32_t order;
        Vec2 at;
    };
    std::map<std::uint32_t, std::map<std::uint32_t, Start>> start; // by layer, region
    for (const auto& [index, layer] : beads.layer) {
        for (const BeadRun& p : layer.runs) {
            if (!toolpath::fills(p.role)) continue;
            const auto [it, fresh] = start[index].try_emplace(p.region, Start{p.order, layer.points[p.first]});
            if (!fresh && p.order < it->second.order) it->second = {p.order, layer.points[p.first]};
        }
    }
    std::vector<double> apart;
    if (!regions.empty()) {
        std::map<std::uint32_t, Vec2> by_region;
        for (const auto& r : regions)
            if (const auto l = start.find(r.layer); l != start.end())
                if (const auto s = l->second.find(r.id); s != l->second.end()) by_region[r.id] = s->second.at;
        for (const auto& r : regions)
            for (const auto& o : r.below)
                if (by_region.count(r.id) + by_region.count(o.below) == 2)
                    apart.push_back(geom::distance(by_region[r.id], by_region[o.below]));
    } else {
        for (const auto& [index, here] : start) {
            const auto below = index == 0 ? start.end() : start.find(index - 1);
            if (below == start.end()) continue;
            for (const auto& [id, s] : here) {
                double nearest = INFINITY;
                for (const auto& [other, b] : below->second) nearest = std::min(nearest, geom::distance(s.at, b.at));
                apart.push_back(nearest);
            }
        }
    }
    SeamDistances out;
    if (apart.empty()) return out;
    std::sort(apart.begin(), apart.end());
    out.pairs = apart.size();
    out.min = apart.front();
    out.median = apart[apart.size() / 2];
    for (const double d : apart) {
        out.mean += d / static_cast<double>(apart.size());
        out.near += d < 3 * bead_width ? 1 : 0;
    }
    return out;
}

} // namespace filum::metrics::planar
