#include "metrics/planar/report.hpp"

#include "base/number.hpp"
#include "metrics/figures/said.hpp"
#include "metrics/planar/directions.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace filum::metrics::planar {

namespace {

using toolpath::Role;

constexpr double kLargeLayer = 1; // mm2; smaller layers cannot be the worst

std::uint64_t count(std::size_t n) { return n; }

std::size_t role(Role r) { return static_cast<std::size_t>(r); }

void continuity(const Course& c, Figures& out) {
    const std::string g = "continuity";
    out.push_back({g, "strokes", count(c.strokes())});
    out.push_back({g, "stops", count(c.stops)});
    out.push_back({g, "breaks", count(c.breaks)});
    out.push_back({g, "breaks by hop of 0.5 mm or less", count(c.hops)});
    out.push_back({g, "breaks by travel in the layer", count(c.travels)});
    out.push_back({g, "breaks by travel to another layer", count(c.climbs)});
    out.push_back({g, "longest gap", c.longest_gap, 3, "mm"});
    out.push_back({g, "joins by lift", count(c.joins[role(Role::lift)] + c.bare_climbs)});
    out.push_back({g, "joins by jog over material", count(c.joins[role(Role::jog)])});
    out.push_back({g, "joins by connector", count(c.joins[role(Role::connector)])});
    if (c.jumps > 0) out.push_back({g, "unmarked jumps", count(c.jumps)});
}

double fibre_volume(const Input& input) {
    double sum = 0;
    for (const auto& [number, tool] : input.tools) sum += tool.fibre ? tool.volume : 0;
    return sum;
}

// g; not a number if the density of fibre counts and is not known.
double mass(const Options& o, double plastic, double fibre) {
    const double known = o.fibre_density > 0 ? o.fibre_density : std::numeric_limits<double>::quiet_NaN();
    return plastic / 1000 * o.density + (fibre > 0 ? fibre / 1000 * known : 0);
}

void tool_figures(const std::string& g, const ToolShare& t, double mass, Figures& out) {
    out.push_back({g, "strokes", count(t.strokes)});
    out.push_back({g, "cuts", count(t.cuts)});
    if (t.fibre) out.push_back({g, "fibre strokes too short to be laid", count(t.too_short)});
    out.push_back({g, "laid", t.laid, 1, "mm"});
    out.push_back({g, "travel", t.travel, 1, "mm"});
    out.push_back({g, "volume", t.volume, 2, "mm3"});
    out.push_back({g, "mass", mass, 3, "g"});
    out.push_back({g, "print time", t.print_seconds, 1, "s"});
    out.push_back({g, "travel time", t.travel_seconds, 1, "s"});
}

// A group per tool and one of the job, where there are several or one lays fibre.
void tools(const Input& input, const Options& o, Figures& out) {
    const auto fibre = [](const auto& t) { return t.second.fibre; };
    if (input.tools.size() < 2 && std::none_of(input.tools.begin(), input.tools.end(), fibre)) return;
    ToolShare all;
    double plastic = 0;
    for (const auto& [number, t] : input.tools) {
        tool_figures("tool " + std::to_string(number) + (t.fibre ? " (fibre)" : ""), t,
                     mass(o, t.fibre ? 0 : t.volume, t.fibre ? t.volume : 0), out);
        all.fibre = all.fibre || t.fibre;
        all.strokes += t.strokes, all.cuts += t.cuts, all.too_short += t.too_short;
        all.laid += t.laid, all.travel += t.travel, all.volume += t.volume;
        all.print_seconds += t.print_seconds, all.travel_seconds += t.travel_seconds;
        plastic += t.fibre ? 0 : t.volume;
    }
    tool_figures("job", all, mass(o, plastic, all.volume - plastic), out);
}

void lengths(const Input& input, const Options& o, Figures& out) {
    const Course& c = input.course;
    const double seconds = input.seconds, of_fibre = fibre_volume(input);
    double extruded = 0, volume = 0;
    for (const Role r : {Role::bead, Role::lift, Role::jog, Role::connector, Role::hairpin})
        extruded += c.length[role(r)], volume += c.volume[role(r)];
    const std::string g = "length";
    out.push_back({g, "extruded", extruded, 1, "mm"});
    out.push_back({g, "of it beads", c.length[role(Role::bead)], 1, "mm"});
    out.push_back({g, "of it lifts", c.length[role(Role::lift)], 1, "mm"});
    out.push_back({g, "of it jogs", c.length[role(Role::jog)], 1, "mm"});
    out.push_back({g, "of it connectors", c.length[role(Role::connector)], 1, "mm"});
    if (const double l = c.length[role(Role::hairpin)]; l > 0) out.push_back({g, "of it hairpins", l, 1, "mm"});
    out.push_back({g, "travel", c.length[role(Role::travel)], 1, "mm"});
    out.push_back({g, "moves", count(c.extruding_moves)});
    const std::string m = "time and material";
    if (seconds >= 0) out.push_back({m, "print time", seconds, 1, "s"});
    const double filament =
        (volume - of_fibre) / (std::numbers::pi * o.filament_diameter * o.filament_diameter / 4) / 1000;
    out.push_back({m, "volume", volume, 2, "mm3"});
    out.push_back({m, "of it to be removed", c.volume[role(Role::connector)], 2, "mm3"});
    if (o.filament_diameter > 0) out.push_back({m, "filament", filament, 3, "m"});
    out.push_back({m, "mass", mass(o, volume - of_fibre, of_fibre), 2, "g"});
}

Cover total(const std::vector<LayerFigures>& layers) {
    Cover all;
    for (const auto& l : layers) {
        all.area += l.cover.area, all.covered += l.cover.covered;
        all.united += l.cover.united, all.deposited += l.cover.deposited;
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
    const std::string g = "coverage";
    const Cover all = total(layers);
    if (all.area <= 0) return;
    std::size_t crossed = 0;
    for (const auto& l : layers) crossed += l.crossings;
    out.push_back({g, "area", all.area, 2, "mm2"});
    out.push_back({g, "coverage", coverage(all), 5});
    out.push_back({g, "outside", all.outside() / all.area, 5});
    out.push_back({g, "overfill", all.overfill() / all.area, 5});
    out.push_back({g, "material", all.deposited / all.area, 5});
    out.push_back({g, "unplaced", all.unplaced(), 3, "mm2"});
    if (claimed > 0) out.push_back({g, "unplaced as the fill says", claimed, 3, "mm2"});
    if (const auto* w = worst_layer(layers)) {
        out.push_back({g, "worst layer", std::uint64_t{w->layer}});
        out.push_back({g, "coverage of the worst layer", coverage(w->cover), 5});
    }
    const auto below = std::count_if(layers.begin(), layers.end(), [](const LayerFigures& l) {
        return l.cover.area > kLargeLayer && coverage(l.cover) < 0.9;
    });
    out.push_back({g, "layers below 0.90", count(static_cast<std::size_t>(below))});
}

void air_figures(const Air& a, Figures& out) {
    const std::string g = "in the air";
    out.push_back({g, "area in the air", a.area, 2, "mm2"});
    out.push_back({g, "length in the air", a.length, 1, "mm"});
    out.push_back({g, "layers with any", count(a.layers)});
    if (a.longest <= 0) return;
    out.push_back({g, "longest stretch", a.longest, 2, "mm"});
    out.push_back({g, "where it begins",
                   "layer " + std::to_string(a.layer) + " at " + fixed_text(a.at.x, 2) + "," + fixed_text(a.at.y, 2)});
}

void crossing_figures(const std::vector<LayerFigures>& layers, Figures& out) {
    std::size_t crossed = 0, on = 0;
    const LayerFigures* first = nullptr;
    for (const auto& l : layers) {
        crossed += l.crossings, on += l.crossings > 0 ? 1 : 0;
        if (first == nullptr && l.crossings > 0) first = &l;
    }
    const std::string g = "crossings";
    out.push_back({g, "crossings", count(crossed)});
    out.push_back({g, "layers with crossings", count(on)});
    if (first == nullptr) return;
    out.push_back({g, "first",
                   "layer " + std::to_string(first->layer) + " at " + fixed_text(first->crossing[0].x, 3) + "," +
                       fixed_text(first->crossing[0].y, 3)});
}

void region_figures(const std::vector<LayerFigures>& layers, Figures& out) {
    std::vector<double> share;
    std::size_t one = 0, none = 0, crossed = 0;
    const RegionFigures* worst = nullptr;
    for (const auto& l : layers) {
        for (const auto& r : l.regions) {
            if (!r.known) continue;
            one += r.curves == 1 ? 1 : 0, none += r.curves == 0 ? 1 : 0, crossed += r.crossings > 0 ? 1 : 0;
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
    const std::string g = "regions";
    out.push_back({g, "regions", count(share.size())});
    out.push_back({g, "with exactly one curve", count(one)});
    out.push_back({g, "with no curve", count(none)});
    out.push_back({g, "with crossings", count(crossed)});
    out.push_back({g, "mean coverage", mean, 5});
    out.push_back({g, "coverage p5", share[share.size() / 20], 5});
    out.push_back({g, "covered 0.98 and more", above(0.98)});
    out.push_back({g, "covered 0.99 and more", above(0.99)});
    out.push_back({g, "coverage of the worst region", share.front(), 5});
    out.push_back({g, "worst region",
                   "region " + std::to_string(worst->region) + " of layer " + std::to_string(worst->layer) + ", " +
                       fixed_text(worst->cover.area, 3) + " mm2, at " + fixed_text(worst->at.x, 2) + "," +
                       fixed_text(worst->at.y, 2)});
}

void shape(const Beads& beads, const std::vector<polygon::Region>& regions, const Widths& w, const Options& o,
           int threads, Figures& out) {
    if (w.share.empty()) return;
    const Turns t = turns(beads, w.median, static_cast<std::size_t>(o.turn_samples), threads);
    const std::string g = "turns";
    out.push_back({g, "sharp-turn share", t.share(), 5});
    out.push_back({g, "samples", count(t.samples)});
    out.push_back({g, "smallest radius", t.min_radius, 3, "mm"});
    const Seams s = seams(beads, regions, w.median);
    if (s.pairs > 0) {
        const std::string q = "seams of neighbouring layers";
        out.push_back({q, "pairs", count(s.pairs)});
        out.push_back({q, "mean distance", s.mean, 3, "mm"});
        out.push_back({q, "median distance", s.median, 3, "mm"});
        out.push_back({q, "smallest distance", s.min, 3, "mm"});
        out.push_back({q, "median distance in bead widths", s.median / w.median, 2});
        out.push_back({q, "smallest distance in bead widths", s.min / w.median, 2});
        out.push_back({q, "nearer than three beads", count(s.near)});
    }
    const Directions along = directions(beads);
    for (std::size_t k = 0; k < Directions::kBins; ++k)
        if (along.share[k] > 0)
            out.push_back({"bead direction", "share at " + std::to_string(15 * k) + " degrees", along.share[k], 5});
    const std::string h = "bead width";
    out.push_back({h, "smallest", w.min, 3, "mm"});
    out.push_back({h, "median", w.median, 3, "mm"});
    out.push_back({h, "mean", w.mean, 3, "mm"});
    out.push_back({h, "largest", w.max, 3, "mm"});
    for (std::size_t k = 0; k < w.share.size(); ++k) {
        if (w.share[k] <= 0) continue;
        const double lo = w.first + static_cast<double>(k) * w.bin;
        const bool open = k + 1 == w.share.size() && lo + w.bin < w.max;
        out.push_back(
            {h,
             "share " + (open ? "from " + fixed_text(lo, 4) : fixed_text(lo, 4) + " to " + fixed_text(lo + w.bin, 4)),
             w.share[k], 5});
    }
}

std::string share(double part, double area) { return fixed_text(area > 0 ? part / area : 0, 5); }

} // namespace

Figures report(const Input& input, const Beads& beads, const std::vector<polygon::Region>& regions,
               const std::vector<LayerFigures>& layers, const Options& options, int threads) {
    Figures out;
    const Widths w = widths(beads);
    if (input.whole_program) continuity(input.course, out);
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
    if (beads.misplaced > 0) out.push_back({"doubts", "moves above the top layer", std::uint64_t{beads.misplaced}});
    metrics::figures::said_before(input.notes, input.facts, out);
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
