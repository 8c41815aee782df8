#include "metrics/planar/report.hpp"

#include "base/number.hpp"
#include "figures/meanings.hpp"
#include "figures/records.hpp"
#include "metrics/planar/directions.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace filum::metrics::planar {

namespace {

using toolpath::Role;

void tell(Figures& out, std::string_view key, decltype(figures::Figure::value) value, std::string_view of = {}) {
    figures::tell(out, figures::planar_meanings(), key, std::move(value), of);
}

constexpr double kLargeLayer = 1; // mm2; smaller layers are not candidates for the worst

std::uint64_t count(std::size_t n) { return n; }

std::size_t role(Role r) { return static_cast<std::size_t>(r); }

void continuity(const PathStatistics& c, Figures& out) {
    tell(out, "strokes", count(c.strokes()));
    tell(out, "stops", count(c.stops));
    tell(out, "breaks", count(c.breaks));
    tell(out, "breaks_hop", count(c.hops));
    tell(out, "breaks_travel", count(c.travels));
    tell(out, "breaks_climb", count(c.climbs));
    tell(out, "longest_gap_mm", c.longest_gap);
    tell(out, "joins_lift", count(c.joins[role(Role::lift)] + c.bare_climbs));
    tell(out, "joins_jog", count(c.joins[role(Role::jog)]));
    tell(out, "joins_connector", count(c.joins[role(Role::connector)]));
    if (c.jumps > 0) tell(out, "unmarked_jumps", count(c.jumps));
}

double fibre_volume(const Input& input) {
    double sum = 0;
    for (const auto& [number, tool] : input.tools) sum += tool.fibre ? tool.volume : 0;
    return sum;
}

// g; nan if the density of fibre is needed and unknown.
double mass(const Options& o, double plastic, double fibre) {
    const double known = o.fibre_density > 0 ? o.fibre_density : std::numeric_limits<double>::quiet_NaN();
    return plastic / 1000 * o.density + (fibre > 0 ? fibre / 1000 * known : 0);
}

// The figures of tool `of`, or of all: what = "tool.*." or "job.".
void tool_figures(const std::string& what, std::string_view of, const ToolShare& t, double mass, Figures& out) {
    tell(out, what + "strokes", count(t.strokes), of);
    tell(out, what + "cuts", count(t.cuts), of);
    if (t.fibre) tell(out, what + "too_short", count(t.too_short), of);
    tell(out, what + "laid_mm", t.laid, of);
    tell(out, what + "travel_mm", t.travel, of);
    tell(out, what + "volume_mm3", t.volume, of);
    tell(out, what + "mass_g", mass, of);
    tell(out, what + "print_time_s", t.print_seconds, of);
    tell(out, what + "travel_time_s", t.travel_seconds, of);
}

// A group of figures per tool and one of the job, if there are several tools or one uses fibre.
void tools(const Input& input, const Options& o, Figures& out) {
    const auto fibre = [](const auto& t) { return t.second.fibre; };
    if (input.tools.size() < 2 && std::none_of(input.tools.begin(), input.tools.end(), fibre)) return;
    ToolShare all;
    double plastic = 0;
    for (const auto& [number, t] : input.tools) {
        const std::size_t first = out.size();
        tool_figures("tool.*.", std::to_string(number), t, mass(o, t.fibre ? 0 : t.volume, t.fibre ? t.volume : 0),
                     out);
        for (std::size_t k = first; k < out.size(); ++k) out[k].group += t.fibre ? " (fibre)" : "";
        all.fibre = all.fibre || t.fibre;
        all.strokes += t.strokes;
        all.cuts += t.cuts;
        all.too_short += t.too_short;
        all.laid += t.laid;
        all.travel += t.travel;
        all.volume += t.volume;
        all.print_seconds += t.print_seconds;
        all.travel_seconds += t.travel_seconds;
        plastic += t.fibre ? 0 : t.volume;
    }
    tool_figures("job.", {}, all, mass(o, plastic, all.volume - plastic), out);
}

void lengths(const Input& input, const Options& o, Figures& out) {
    const PathStatistics& c = input.statistics;
    const double seconds = input.seconds, of_fibre = fibre_volume(input);
    double extruded = 0, volume = 0;
    for (const Role r : {Role::bead, Role::lift, Role::jog, Role::connector, Role::hairpin}) {
        extruded += c.length[role(r)];
        volume += c.volume[role(r)];
    }
    tell(out, "extruded_mm", extruded);
    tell(out, "beads_mm", c.length[role(Role::bead)]);
    tell(out, "lifts_mm", c.length[role(Role::lift)]);
    tell(out, "jogs_mm", c.length[role(Role::jog)]);
    tell(out, "connectors_mm", c.length[role(Role::connector)]);
    if (const double l = c.length[role(Role::hairpin)]; l > 0) tell(out, "hairpins_mm", l);
    tell(out, "travel_mm", c.length[role(Role::travel)]);
    tell(out, "moves", count(c.extruding_moves));
    if (seconds >= 0) tell(out, "print_time_s", seconds);
    const double filament =
        (volume - of_fibre) / (std::numbers::pi * o.filament_diameter * o.filament_diameter / 4) / 1000;
    tell(out, "volume_mm3", volume);
    tell(out, "removed_mm3", c.volume[role(Role::connector)]);
    if (o.filament_diameter > 0) tell(out, "filament_m", filament);
    tell(out, "mass_g", mass(o, volume - of_fibre, of_fibre));
}

Cover total(const std::vector<LayerFigures>& layers) {
    Cover all;
    for (const auto& l : layers) {
        all.area += l.cover.area;
        all.covered += l.cover.covered;
        all.united += l.cover.united;
        all.deposited += l.cover.deposited;
    }
    return all;
}

const LayerFigures* worst_layer(const std::vector<LayerFigures>& layers) {
    const LayerFigures* worst = nullptr;
    for (const auto& l : layers)
        if (l.cover.area > kLargeLayer && (worst == nullptr || coverage(l.cover) < coverage(worst->cover))) worst = &l;
    return worst;
}

void areas(const std::vector<LayerFigures>& layers, double claimed, Figures& out) {
    const Cover all = total(layers);
    if (all.area <= 0) return;
    tell(out, "area_mm2", all.area);
    tell(out, "coverage", coverage(all));
    tell(out, "outside", all.outside() / all.area);
    tell(out, "overfill", all.overfill() / all.area);
    tell(out, "material", all.deposited / all.area);
    tell(out, "unplaced_mm2", all.unplaced());
    if (claimed > 0) tell(out, "unplaced_claimed_mm2", claimed);
    if (const auto* w = worst_layer(layers)) {
        tell(out, "worst_layer", std::uint64_t{w->layer});
        tell(out, "worst_layer_coverage", coverage(w->cover));
    }
    const auto below = std::count_if(layers.begin(), layers.end(), [](const LayerFigures& l) {
        return l.cover.area > kLargeLayer && coverage(l.cover) < 0.9;
    });
    tell(out, "layers_below_090", count(static_cast<std::size_t>(below)));
}

void air_figures(const Air& a, Figures& out) {
    tell(out, "air_area_mm2", a.area);
    tell(out, "air_length_mm", a.length);
    tell(out, "air_layers", count(a.layers));
    if (a.longest <= 0) return;
    tell(out, "air_longest_mm", a.longest);
    tell(out, "air_longest_at",
         "layer " + std::to_string(a.layer) + " at " + fixed_text(a.at.x, 2) + "," + fixed_text(a.at.y, 2));
}

void crossing_figures(const std::vector<LayerFigures>& layers, Figures& out) {
    std::size_t crossed = 0, on = 0;
    const LayerFigures* first = nullptr;
    for (const auto& l : layers) {
        crossed += l.crossings;
        on += l.crossings > 0 ? 1 : 0;
        if (first == nullptr && l.crossings > 0) first = &l;
    }
    tell(out, "crossings", count(crossed));
    tell(out, "crossing_layers", count(on));
    if (first == nullptr) return;
    tell(out, "first_crossing",
         "layer " + std::to_string(first->layer) + " at " + fixed_text(first->crossing[0].x, 3) + "," +
             fixed_text(first->crossing[0].y, 3));
}

void region_figures(const std::vector<LayerFigures>& layers, Figures& out) {
    std::vector<double> share;
    std::size_t one = 0, none = 0, crossed = 0;
    const RegionFigures* worst = nullptr;
    for (const auto& l : layers) {
        for (const auto& r : l.regions) {
            if (!r.known) continue;
            one += r.curves == 1 ? 1 : 0;
            none += r.curves == 0 ? 1 : 0;
            crossed += r.crossings > 0 ? 1 : 0;
            share.push_back(coverage(r.cover));
            if (worst == nullptr || share.back() < coverage(worst->cover)) worst = &r;
        }
    }
    if (worst == nullptr) return;
    std::sort(share.begin(), share.end());
    double mean = 0;
    for (const double s : share) mean += s / static_cast<double>(share.size());
    const auto above = [&](double v) {
        return count(static_cast<std::size_t>(share.end() - std::lower_bound(share.begin(), share.end(), v)));
    };
    tell(out, "regions", count(share.size()));
    tell(out, "regions_one_curve", count(one));
    tell(out, "regions_no_curve", count(none));
    tell(out, "regions_crossed", count(crossed));
    tell(out, "region_coverage_mean", mean);
    tell(out, "region_coverage_p5", share[share.size() / 20]);
    tell(out, "regions_covered_098", above(0.98));
    tell(out, "regions_covered_099", above(0.99));
    tell(out, "region_coverage_worst", share.front());
    tell(out, "worst_region",
         "region " + std::to_string(worst->region) + " of layer " + std::to_string(worst->layer) + ", " +
             fixed_text(worst->cover.area, 3) + " mm2, at " + fixed_text(worst->at.x, 2) + "," +
             fixed_text(worst->at.y, 2));
}

void shape(const Beads& beads, const std::vector<polygon::Region>& regions, const Widths& w, const Options& o,
           int threads, Figures& out) {
    if (w.share.empty()) return;
    const Turns t = turns(beads, w.median, static_cast<std::size_t>(o.turn_samples), threads);
    tell(out, "sharp_turn_share", t.share());
    tell(out, "turn_samples", count(t.samples));
    tell(out, "turn_radius_least_mm", t.min_radius);
    const SeamDistances s = seams(beads, regions, w.median);
    if (s.pairs > 0) {
        tell(out, "seam_pairs", count(s.pairs));
        tell(out, "seam_mean_mm", s.mean);
        tell(out, "seam_median_mm", s.median);
        tell(out, "seam_least_mm", s.min);
        tell(out, "seam_median_widths", s.median / w.median);
        tell(out, "seam_least_widths", s.min / w.median);
        tell(out, "seams_near", count(s.near));
    }
    const Directions along = directions(beads);
    for (std::size_t k = 0; k < Directions::kBins; ++k)
        if (along.share[k] > 0) tell(out, "direction_share.*", along.share[k], std::to_string(15 * k));
    tell(out, "width_least_mm", w.min);
    tell(out, "width_median_mm", w.median);
    tell(out, "width_mean_mm", w.mean);
    tell(out, "width_greatest_mm", w.max);
    for (std::size_t k = 0; k < w.share.size(); ++k) {
        if (w.share[k] <= 0) continue;
        const double lo = w.first + static_cast<double>(k) * w.bin;
        const bool open = k + 1 == w.share.size() && lo + w.bin < w.max;
        const std::string from = fixed_text(lo, 4);
        tell(out, "width_share.*", w.share[k], open ? "from " + from : from + " to " + fixed_text(lo + w.bin, 4));
    }
}

std::string share(double part, double area) { return fixed_text(area > 0 ? part / area : 0, 5); }

} // namespace

Figures report(const Input& input, const Beads& beads, const std::vector<polygon::Region>& regions,
               const std::vector<LayerFigures>& layers, const Options& options, int threads) {
    Figures out;
    const Widths w = widths(beads);
    if (input.whole_program) continuity(input.statistics, out);
    areas(layers, input.claimed_unplaced, out);
    crossing_figures(layers, out);
    region_figures(layers, out);
    if (input.air) air_figures(*input.air, out);
    if (input.pores) pore_figures(*input.pores, out);
    shape(beads, regions, w, options, threads, out);
    if (input.whole_program) {
        tools(input, options, out);
        lengths(input, options, out);
    }
    if (beads.misplaced > 0) tell(out, "moves_above_top", std::uint64_t{beads.misplaced});
    figures::add_records(input.notes, input.facts, out);
    return out;
}

std::string region_table(const std::vector<LayerFigures>& layers) {
    std::string out = "layer\tregion\tcurves\tmoves\tlength_mm\tarea_mm2\tcoverage\toutside\toverfill\tunplaced_"
                      "mm2\tcrossings\tx_mm\ty_mm\n";
    for (const auto& l : layers) {
        for (const auto& r : l.regions) {
            const double a = r.cover.area;
            out += std::to_string(r.layer) + "\t" + std::to_string(r.region) + "\t" + std::to_string(r.curves) + "\t" +
                   std::to_string(r.segments) + "\t" + fixed_text(r.length, 3) + "\t" + fixed_text(a, 4) + "\t" +
                   fixed_text(coverage(r.cover), 5) + "\t" + share(r.cover.outside(), a) + "\t" +
                   share(r.cover.overfill(), a) + "\t" + fixed_text(r.cover.unplaced(), 4) + "\t" +
                   std::to_string(r.crossings) + "\t" + fixed_text(r.at.x, 3) + "\t" + fixed_text(r.at.y, 3) + "\n";
        }
    }
    return out;
}

std::string layer_table(const std::vector<LayerFigures>& layers, const std::optional<Pores>& pores) {
    std::string out = "layer\tz_mm\tarea_mm2\tcoverage\toutside\toverfill\tmaterial\tcrossings\tregions" +
                      (pores ? "\t" + pore_columns() : "") + "\n";
    for (const auto& l : layers) {
        const double a = l.cover.area;
        out += std::to_string(l.layer) + "\t" + fixed_text(l.z, 4) + "\t" + fixed_text(a, 4) + "\t" +
               fixed_text(coverage(l.cover), 5) + "\t" + share(l.cover.outside(), a) + "\t" +
               share(l.cover.overfill(), a) + "\t" + share(l.cover.deposited, a) + "\t" + std::to_string(l.crossings) +
               "\t" + std::to_string(l.regions.size()) + (pores ? "\t" + pore_cells(*pores, l.layer) : "") + "\n";
    }
    return out;
}

} // namespace filum::metrics::planar
