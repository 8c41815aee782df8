#include "metrics/surface/report.hpp"

#include "base/density.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "figures/meanings.hpp"
#include "metrics/surface/curvature.hpp"
#include "metrics/surface/load.hpp"
#include "metrics/surface/neighbours.hpp"
#include "metrics/surface/place_text.hpp"
#include "metrics/surface/plies.hpp"
#include "metrics/surface/tight.hpp"
#include "parallel/parallel.hpp"
#include "surface/curve/turns.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::metrics::surface {

namespace {

using figures::Figures;

void tell(Figures& out, std::string_view key, decltype(figures::Figure::value) value, std::string_view of = {}) {
    figures::tell(out, figures::surface_meanings(), key, std::move(value), of);
}

constexpr double kWidest = 20;       // bead widths: the greatest ratio of the spacing to them, in either direction
constexpr double kMostSamples = 2e7; //
constexpr double kBeyond = 1.05;     // of the limit of curvature: tolerance for the uncertainty from points
constexpr double kDegrees = 180 / std::numbers::pi;

double share(double part, double all) { return all > 0 ? part / all : std::nan(""); }

// The inputs of all figures.
struct Inputs {
    const Fibres& fibres;
    const filum::surface::Sheet& sheet;
    Options options; // resolved
    double spread;   // d by the median bead width
    Ground ground;
    std::vector<Sample> samples;
    int threads;

    Inputs(const Fibres& f, const filum::surface::Sheet& s, const Options& o, double width, int n)
        : fibres(f), sheet(s), options(o), spread(o.spacing / width), ground(s.surface, o.spacing),
          samples(metrics::surface::samples(f, ground, o.step, n)), threads(n) {}
};

void continuity(const Fibres& fibres, double area, Figures& out) {
    std::vector<Weighted> lengths;
    for (const Fibre& c : fibres.all) lengths.push_back({c.length(), 1});
    const std::size_t cuts = lengths.empty() ? 0 : lengths.size() - 1;
    tell(out, "chains", std::uint64_t{lengths.size()});
    tell(out, "cuts", std::uint64_t{cuts});
    tell(out, "cuts_per_1000_mm2", share(1000.0 * static_cast<double>(cuts), area));
    tell(out, "fibre_least_mm", quantile(lengths, 0));
    tell(out, "fibre_p10_mm", quantile(lengths, 0.1));
    tell(out, "fibre_p50_mm", quantile(lengths, 0.5));
    tell(out, "fibre_mm", length(fibres));
    tell(out, "travel_mm", fibres.travel);
    if (fibres.jumps > 0) tell(out, "unmarked_jumps", std::uint64_t{fibres.jumps});
}

std::vector<Bends> bend(const Inputs& inputs, const Feet& feet) {
    const auto& chains = inputs.fibres.all;
    std::vector<Bends> out(chains.size());
    parallel::for_chunks(chains.size(), 1, inputs.threads, [&](std::size_t k, std::size_t) {
        out[k] = bends(chains[k], feet.normals[k], inputs.options.step);
    });
    return out;
}

void mark_turns(const std::vector<Bends>& bent, std::vector<Sample>& samples) {
    for (Sample& s : samples) {
        const auto& around = bent[s.chain].around;
        const auto it = std::lower_bound(around.begin(), around.end(), s.along,
                                         [](const Bends::Range& r, double along) { return r.to < along; });
        s.turning = it != around.end() && it->from <= s.along;
    }
}

void curvature(const Inputs& inputs, const std::vector<Bends>& bent, Figures& out) {
    const double limit = kBeyond * inputs.options.max_curvature;
    std::vector<Weighted> geodesic, normal, total;
    double all = 0, sharp = 0, sharp_total = 0;
    std::size_t turns = 0;
    for (const Bends& b : bent) {
        turns += b.turns;
        for (const Bend& p : b.places) {
            geodesic.push_back({std::abs(p.geodesic), p.length});
            normal.push_back({std::abs(p.normal), p.length});
            total.push_back({p.total(), p.length});
            all += p.length;
            sharp += std::abs(p.geodesic) > limit ? p.length : 0;
            sharp_total += p.total() > limit ? p.length : 0;
        }
    }
    tell(out, "paper_angle_deg", paper_angle(inputs.fibres, inputs.options.spacing) * kDegrees);
    tell(out, "paper_angle_step_deg", paper_angle(inputs.fibres, inputs.options.step) * kDegrees);
    tell(out, "step_mm", inputs.options.step);
    tell(out, "geodesic_p99_per_mm", quantile(geodesic, 0.99));
    tell(out, "geodesic_greatest_per_mm", quantile(geodesic, 1));
    tell(out, "normal_p99_per_mm", quantile(normal, 0.99));
    tell(out, "normal_greatest_per_mm", quantile(normal, 1));
    tell(out, "radius_least_mm", 1 / quantile(total, 1));
    tell(out, "curvature_limit_per_mm", inputs.options.max_curvature);
    tell(out, "sharp_geodesic", share(sharp, all));
    tell(out, "sharp_total", share(sharp_total, all));
    tell(out, "turns_over_90", std::uint64_t{turns});
}

void tight_turns(const Inputs& inputs, const Feet& feet, Figures& out) {
    using filum::surface::curve::kKinkRadius;
    const Options& o = inputs.options;
    const double all = length(inputs.fibres);
    const TightLength t = tight(inputs.fibres, feet.normals, o.min_radius, o.spacing);
    tell(out, "tight_limit_mm", o.min_radius);
    tell(out, "tight_turns", std::uint64_t{t.count});
    tell(out, "tight_mm", t.length);
    tell(out, "tight_share", share(t.length, all));
    if (t.count > 0) tell(out, "tight_at", place_text(t.tightest));
    const TightLength kinks = tight(inputs.fibres, feet.normals, kKinkRadius * o.spacing, o.spacing);
    tell(out, "kink_limit_mm", kKinkRadius * o.spacing);
    tell(out, "kinks", std::uint64_t{kinks.count});
    tell(out, "kinks_mm", kinks.length);
    tell(out, "kinks_share", share(kinks.length, all));
    tell(out, "tight_radius_least_mm", kinks.least);
    if (kinks.count > 0) tell(out, "kink_at", place_text(kinks.tightest));
}

void area(const Plies& plies, double fibre, Figures& out) {
    const Area& a = plies.area;
    const double fill = share(plies.laid, a.surface), coverage = share(a.covered, a.surface);
    const auto n = static_cast<double>(plies.count);
    tell(out, "surface_mm2", a.surface / n);
    if (plies.count > 1) tell(out, "plies", std::uint64_t{plies.count});
    tell(out, "paper_coverage", plies.paper / n);
    tell(out, "coverage", coverage);
    if (plies.count > 1) tell(out, "worst_ply_coverage", plies.least);
    tell(out, "fill_ratio", fill);
    tell(out, "overlap", fill - coverage);
    tell(out, "void_mm", a.void_radius);
    if (a.void_radius > 0) tell(out, "void_at", place_text(a.void_at));
    if (a.unreached > 0) tell(out, "unreached_mm2", a.unreached);
    if (a.strip > 0) {
        tell(out, "rim_share", share(a.strip, a.surface));
        tell(out, "rim_coverage", share(a.strip_covered, a.strip));
        tell(out, "inner_coverage", share(a.covered - a.strip_covered, a.surface - a.strip));
    }
    if (plies.beside > 0) {
        tell(out, "beside_mm", plies.beside);
        tell(out, "beside_share", share(plies.beside, fibre));
    }
    if (plies.aloft > 0) tell(out, "above_mm", plies.aloft);
    if (plies.lost > 0) tell(out, "across_gaps_mm", plies.lost);
}

void spacing(const Inputs& inputs, bool turns, Figures& out) {
    const std::string of = turns ? "" : "plain_";
    std::vector<Weighted> signed_error, error;
    for (const Gap& gap : gaps(inputs.samples, inputs.spread, turns, inputs.threads)) {
        signed_error.push_back({gap.error, gap.length});
        error.push_back({std::abs(gap.error), gap.length});
    }
    double sides = 0, found = 0;
    for (const Sample& s : inputs.samples) sides += s.hairpin || (s.turning && !turns) ? 0 : 2 * s.length;
    for (const Weighted& w : error) found += w.weight;
    if (turns)
        tell(out, "d_mm", inputs.options.spacing);
    else
        tell(out, "plain_path_share", share(sides / 2, length(inputs.fibres)));
    tell(out, of + "sides_neighboured", share(found, sides));
    for (const int p : {1, 50, 99})
        tell(out, of + "gap_error_p*", quantile(signed_error, p / 100.0), std::to_string(p));
    for (const int p : {50, 99}) tell(out, of + "gap_off_p*", quantile(error, p / 100.0), std::to_string(p));
}

void load(const Inputs& inputs, Figures& out) {
    const auto cases = load_cases(inputs.sheet);
    const Surface& s = inputs.sheet.surface;
    std::vector<Sample> on; // samples past a rim carry no load
    std::copy_if(inputs.samples.begin(), inputs.samples.end(), std::back_inserter(on),
                 [](const Sample& p) { return !p.beside; });
    if (cases.empty() || on.empty()) return;
    std::vector<LoadFigures> each;
    each.reserve(cases.size());
    for (const LoadCase& c : cases) each.push_back(adequacy(on, s, c));
    const PaperLoad paper = paper_adequacy(on, s, cases);
    const auto least = [&](double LoadFigures::*of) {
        double out = INFINITY;
        for (const auto& e : each) out = std::min(out, e.*of);
        return out;
    };
    tell(out, "load_cases", std::uint64_t{cases.size()});
    tell(out, "paper_load", paper.mean);
    tell(out, "paper_load_best", paper.best);
    tell(out, "paper_load_random", paper.random);
    tell(out, "load_mean", least(&LoadFigures::mean));
    tell(out, "load_along", least(&LoadFigures::tangential));
    tell(out, "load_along_weighted", least(&LoadFigures::weighted));
    for (std::size_t k = 0; k < each.size(); ++k) {
        const std::string& of = cases[k].name;
        tell(out, "load.*.mean", each[k].mean, of);
        tell(out, "load.*.best", each[k].best, of);
        tell(out, "load.*.along", each[k].tangential, of);
        tell(out, "load.*.along_weighted", each[k].weighted, of);
        tell(out, "load.*.along_random", each[k].random, of);
        tell(out, "load.*.within_15_deg", each[k].within, of);
        if (each[k].known < 1) tell(out, "load.*.known", each[k].known, of);
    }
}

void off_surface(const Feet& feet, const std::vector<Sample>& samples, Figures& out) {
    std::vector<Weighted> off = feet.off;
    for (const Sample& s : samples) off.push_back({s.off, s.length});
    tell(out, "off_p50_mm", quantile(off, 0.5));
    tell(out, "off_p99_mm", quantile(off, 0.99));
    tell(out, "off_greatest_mm", quantile(off, 1));
}

// Rejects options with which no sensible result, or none in sensible time, is possible.
void check(const Options& o, double width, double length) {
    const auto mm = [](double v) { return shortest_text(v) + " mm"; };
    if (o.spacing > kWidest * width || o.spacing * kWidest < width)
        throw Error(Exit::usage, "cannot use a spacing of " + mm(o.spacing) + " for beads " + mm(width) +
                                     " wide; give a --spacing nearer to that");
    if (o.step > o.spacing)
        throw Error(Exit::usage, "cannot sample every " + mm(o.step) + " where strands are " + mm(o.spacing) +
                                     " apart; give a smaller --step");
    if (length / o.step > kMostSamples)
        throw Error(Exit::usage, "cannot sample " + mm(length) + " of path every " + mm(o.step) +
                                     ": too many samples; give a greater --step");
}

} // namespace

Measurement measure(const Fibres& fibres, const filum::surface::Sheet& sheet, const Options& given, bool distance,
                    int threads) {
    Measurement out;
    const double width = median_width(fibres);
    Options options = given;
    if (options.spacing == 0) options.spacing = width;
    if (fibres.all.empty() || !(width > 0)) {
        continuity(fibres, filum::surface::area(sheet.surface), out.figures);
        return out;
    }
    if (options.step == 0) options.step = options.spacing / 4;
    if (options.min_radius == 0) options.min_radius = 1 / options.max_curvature;
    check(options, width, length(fibres));
    check_density(filum::surface::area(sheet.surface), options.spacing,
                  given.spacing > 0 ? Exit::usage : Exit::bad_input,
                  given.spacing > 0 ? "--spacing" : "the width of the beads");
    Inputs inputs(fibres, sheet, options, width, threads);
    const Feet touch = feet(fibres, inputs.ground, threads);
    const auto bent = bend(inputs, touch);
    mark_turns(bent, inputs.samples);
    auto plies = measure_plies(fibres, inputs.ground, inputs.samples, {options.spacing, distance}, threads);
    continuity(fibres, plies.area.surface, out.figures);
    tell(out.figures, "retraced_mm", retraced(inputs.samples, threads));
    curvature(inputs, bent, out.figures);
    tight_turns(inputs, touch, out.figures);
    area(plies, length(fibres), out.figures);
    spacing(inputs, true, out.figures);
    spacing(inputs, false, out.figures);
    load(inputs, out.figures);
    off_surface(touch, inputs.samples, out.figures);
    out.distance = std::move(plies.distance);
    return out;
}

} // namespace filum::metrics::surface
