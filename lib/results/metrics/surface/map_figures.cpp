#include "metrics/surface/map_figures.hpp"

#include "base/number.hpp"
#include "figures/meanings.hpp"
#include "metrics/surface/place_text.hpp"

#include <algorithm>
#include <cmath>

namespace filum::metrics::surface {

namespace {

using figures::Figures;

constexpr double kHundredth = 0.01;
constexpr double kAlong = 15; // degrees: greater deviations are turns
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double mean(const std::vector<Weighted>& all) {
    double sum = 0, total = 0;
    for (const Weighted& w : all) {
        sum += w.value * w.weight;
        total += w.weight;
    }
    return total > 0 ? sum / total : kUnknown;
}

// Statistics of the values above 0 within the ply.
struct PositiveSpread {
    double median = 0, high = 0, most = 0;
    Vec3 at{};
};
PositiveSpread positive_spread(const Map& map, const PlyMap& ply, const std::vector<double>& values) {
    PositiveSpread out;
    std::vector<Weighted> all;
    for (std::size_t v = 0; v < values.size(); ++v) {
        if (!(values[v] > 0 && ply.inside[v] > 0)) continue;
        all.push_back({values[v], map.area[v] * ply.inside[v]});
        if (values[v] > out.most && ply.inside[v] > 0.5) { // near the edge of the ply others may cover it
            out.most = values[v];
            out.at = map.ground.surface.vertices[v];
        }
    }
    if (all.empty()) return out;
    out.median = quantile(all, 0.5);
    out.high = quantile(all, 1 - kHundredth);
    return out;
}

} // namespace

Spread spread_of(const Map& map, std::span<const double> values, std::span<const double> weight) {
    auto all = weighed(values, map.area, weight);
    Spread out{mean(all), kUnknown, kUnknown, kUnknown, kUnknown, kUnknown, {}, {}};
    if (all.empty()) return out;
    std::size_t least = values.size(), most = values.size();
    for (std::size_t v = 0; v < values.size(); ++v) {
        if (!std::isfinite(values[v]) || (!weight.empty() && !(weight[v] > 0))) continue;
        if (least == values.size() || values[v] < values[least]) least = v;
        if (most == values.size() || values[v] > values[most]) most = v;
    }
    out.least = values[least];
    out.most = values[most];
    out.least_at = map.ground.surface.vertices[least];
    out.most_at = map.ground.surface.vertices[most];
    out.low = quantile(all, kHundredth);
    out.median = quantile(all, 0.5);
    out.high = quantile(all, 1 - kHundredth);
    return out;
}

PlySpread ply_spread(const Map& map, std::size_t k) {
    const PlyMap& ply = map.plies[k];
    PlySpread out;
    out.bare = 1 - share_beyond(ply, map.area, 0);
    out.twice = share_beyond(ply, map.area, 1);
    out.thrice = share_beyond(ply, map.area, 2);
    const PositiveSpread gap = positive_spread(map, ply, ply.clearance);
    out.gap_median = gap.median;
    out.gap_high = gap.high;
    out.gap_most = gap.most;
    out.gap_at = gap.at;
    auto clear = weighed(ply.clearance, map.area, ply.inside);
    out.gap = clear.empty() ? 0 : std::max(0.0, quantile(clear, 1 - kHundredth));
    std::vector<double> more;
    for (const double p : ply.passes) more.push_back(p - 1);
    const PositiveSpread over = positive_spread(map, ply, more);
    out.over_median = over.median;
    out.over_high = over.high;
    out.over_most = over.most;
    out.over_at = over.at;
    auto off = ply.off;
    double near = 0, total = 0;
    for (const Weighted& w : off) {
        near += w.value <= kAlong ? w.weight : 0;
        total += w.weight;
    }
    out.off_mean = mean(off);
    out.off_median = quantile(off, 0.5);
    out.off_high = quantile(off, 1 - kHundredth);
    out.within = total > 0 ? near / total : kUnknown;
    return out;
}

double within_a_ply(const Map& map) {
    double thickest = 0, sum = 0, total = 0;
    for (const PlyMap& p : map.plies) thickest = std::max(thickest, p.height);
    for (std::size_t v = 0; v < map.area.size(); ++v) {
        total += map.area[v];
        sum += std::abs(map.even[v] - map.nominal[v]) <= thickest ? map.area[v] : 0;
    }
    return total > 0 ? sum / total : kUnknown;
}

Figures map_figures(const Map& map) {
    Figures out;
    const auto tell = [&](std::string_view key, decltype(figures::Figure::value) value, std::string_view of = {}) {
        figures::tell(out, figures::surface_meanings(), key, std::move(value), of);
    };
    tell("thickness_nominal_mm", spread_of(map, map.nominal).mean);
    tell("thickness_within_a_ply", within_a_ply(map));
    for (const auto& [of, values] : {std::pair("points", &map.thickness), std::pair("even", &map.even)}) {
        const Spread s = spread_of(map, *values);
        tell("thickness.*.mean_mm", s.mean, of);
        tell("thickness.*.p01_mm", s.low, of);
        tell("thickness.*.p50_mm", s.median, of);
        tell("thickness.*.p99_mm", s.high, of);
        tell("thickness.*.least_mm", s.least, of);
        tell("thickness.*.least_at", place_text(s.least_at), of);
        tell("thickness.*.greatest_mm", s.most, of);
        tell("thickness.*.greatest_at", place_text(s.most_at), of);
    }
    for (std::size_t k = 0; k < map.plies.size(); ++k) {
        const PlySpread s = ply_spread(map, k);
        const std::string of = std::to_string(k + 1);
        tell("ply.*.bare", s.bare, of);
        tell("ply.*.gap_p50_mm", s.gap_median, of);
        tell("ply.*.gap_p99_mm", s.gap_high, of);
        tell("ply.*.gap_greatest_mm", s.gap_most, of);
        if (s.gap_most > 0) tell("ply.*.gap_at", place_text(s.gap_at), of);
        tell("ply.*.twice", s.twice, of);
        tell("ply.*.thrice", s.thrice, of);
        tell("ply.*.over_p50", s.over_median, of);
        tell("ply.*.over_p99", s.over_high, of);
        tell("ply.*.over_greatest", s.over_most, of);
        if (s.over_most > 0) tell("ply.*.over_at", place_text(s.over_at), of);
        if (map.plies[k].off.empty()) continue;
        tell("ply.*.off_mean_deg", s.off_mean, of);
        tell("ply.*.off_p50_deg", s.off_median, of);
        tell("ply.*.off_p99_deg", s.off_high, of);
        tell("ply.*.within_15_deg", s.within, of);
    }
    return out;
}

} // namespace filum::metrics::surface
