#include "metrics/surface/report.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "metrics/surface/curvature.hpp"
#include "metrics/surface/load.hpp"
#include "metrics/surface/plies.hpp"
#include "metrics/surface/strands.hpp"
#include "metrics/surface/tight.hpp"
#include "parallel/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::metrics::surface {

namespace {

using metrics::figures::Figures;

constexpr double kWidest = 20;       // bead widths: how far apart strands may be
constexpr double kMostSamples = 2e7; //
constexpr double kBeyond = 1.05;     // of the limit of curvature: what points leave uncertain
constexpr double kDegrees = 180 / std::numbers::pi;

std::string place(const Vec3& p) { return fixed_text(p.x, 2) + "," + fixed_text(p.y, 2) + "," + fixed_text(p.z, 2); }

double share(double part, double all) { return all > 0 ? part / all : std::nan(""); }

// What all figures are made of.
struct Job {
    const Fibres& fibres;
    const filum::surface::Sheet& sheet;
    Options options; // resolved
    double spread;   // d by the median bead width
    Ground ground;
    std::vector<Sample> samples;
    int threads;

    Job(const Fibres& f, const filum::surface::Sheet& s, const Options& o, double width, int n)
        : fibres(f), sheet(s), options(o), spread(o.spacing / width), ground(s.surface, o.spacing),
          samples(metrics::surface::samples(f, ground, o.step, n)), threads(n) {}
};

void continuity(const Fibres& fibres, double area, Figures& out) {
    const std::string g = "continuity";
    std::vector<Weighted> lengths;
    for (const Chain& c : fibres.chains) lengths.push_back({c.length(), 1});
    const std::size_t cuts = lengths.empty() ? 0 : lengths.size() - 1;
    out.push_back({g, "chains", std::uint64_t{lengths.size()}});
    out.push_back({g, "cuts", std::uint64_t{cuts}});
    out.push_back({g, "cuts per 1000 mm2", share(1000.0 * static_cast<double>(cuts), area), 2});
    out.push_back({g, "shortest fibre", quantile(lengths, 0), 2, "mm"});
    out.push_back({g, "fibre p10", quantile(lengths, 0.1), 2, "mm"});
    out.push_back({g, "fibre p50", quantile(lengths, 0.5), 2, "mm"});
    out.push_back({g, "fibre", length(fibres), 1, "mm"});
    out.push_back({g, "travel", fibres.travel, 1, "mm"});
    if (fibres.jumps > 0) out.push_back({g, "unmarked jumps", std::uint64_t{fibres.jumps}});
}

std::vector<Bends> bend(const Job& job, const Feet& feet) {
    const auto& chains = job.fibres.chains;
    std::vector<Bends> out(chains.size());
    parallel::for_chunks(chains.size(), 1, job.threads, [&](std::size_t k, std::size_t) {
        out[k] = bends(chains[k], feet.normals[k], job.options.step);
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

void curvature(const Job& job, const std::vector<Bends>& bent, Figures& out) {
    const double limit = kBeyond * job.options.max_curvature;
    std::vector<Weighted> geodesic, normal, total;
    double all = 0, sharp = 0, sharp_total = 0, plain = 0, sharp_plain = 0, total_plain = 0, most_plain = 0;
    std::size_t turns = 0;
    for (const Bends& b : bent) {
        turns += b.turns;
        for (const Bend& p : b.places) {
            geodesic.push_back({std::abs(p.geodesic), p.length});
            normal.push_back({std::abs(p.normal), p.length});
            total.push_back({p.total(), p.length});
            const bool over = std::abs(p.geodesic) > limit;
            all += p.length, sharp += over ? p.length : 0;
            sharp_total += p.total() > limit ? p.length : 0;
            if (p.hairpin) continue;
            plain += p.length, sharp_plain += over ? p.length : 0;
            total_plain += p.total() > limit ? p.length : 0;
            most_plain = std::max(most_plain, p.total());
        }
    }
    const std::string g = "curvature";
    out.push_back({g, "paper: mean of the top 1 % of angles at d",
                   paper_angle(job.fibres, job.options.spacing) * kDegrees, 2, "deg"});
    out.push_back({g, "paper: mean of the top 1 % of angles at the step",
                   paper_angle(job.fibres, job.options.step) * kDegrees, 2, "deg"});
    out.push_back({g, "step", job.options.step, 4, "mm"});
    out.push_back({g, "geodesic p99", quantile(geodesic, 0.99), 4, "1/mm"});
    out.push_back({g, "geodesic max", quantile(geodesic, 1), 4, "1/mm"});
    out.push_back({g, "normal p99", quantile(normal, 0.99), 4, "1/mm"});
    out.push_back({g, "normal max", quantile(normal, 1), 4, "1/mm"});
    out.push_back({g, "least radius", 1 / quantile(total, 1), 3, "mm"});
    out.push_back({g, "least radius outside hairpins", 1 / most_plain, 3, "mm"});
    out.push_back({g, "limit", job.options.max_curvature, 4, "1/mm"});
    out.push_back({g, "share above the limit, geodesic", share(sharp, all), 5});
    out.push_back({g, "share above the limit, geodesic, outside hairpins", share(sharp_plain, plain), 5});
    out.push_back({g, "share above the limit, total", share(sharp_total, all), 5});
    out.push_back({g, "share above the limit, total, outside hairpins", share(total_plain, plain), 5});
    out.push_back({g, "length of declared hairpins", all - plain, 1, "mm"});
    out.push_back({g, "turns of more than 90 degrees", std::uint64_t{turns}});
}

void tight_turns(const Job& job, const Feet& feet, Figures& out) {
    const TightTurns t = tight(job.fibres, feet.normals, 1 / job.options.max_curvature);
    const std::string g = "tight turns";
    out.push_back({g, "radius", 1 / job.options.max_curvature, 3, "mm"});
    out.push_back({g, "turns within less", std::uint64_t{t.count}});
    out.push_back({g, "length", t.length, 2, "mm"});
    out.push_back({g, "length not declared", t.undeclared, 2, "mm"});
    out.push_back({g, "least radius by three points", t.least, 3, "mm"});
    if (t.count > 0) out.push_back({g, "tightest at", place(t.tightest)});
    if (t.undeclared > 0) out.push_back({g, "tightest not declared at", place(t.undeclared_at)});
}

void area(const Plies& plies, Figures& out) {
    const std::string g = "area";
    const Area& a = plies.area;
    const double fill = share(plies.laid, a.surface), coverage = share(a.covered, a.surface);
    const auto n = static_cast<double>(plies.count);
    out.push_back({g, "surface", a.surface / n, 2, "mm2"});
    if (plies.count > 1) out.push_back({g, "plies", std::uint64_t{plies.count}});
    out.push_back({g, "paper: share within d of points", plies.paper / n, 4});
    out.push_back({g, "coverage", coverage, 4});
    if (plies.count > 1) out.push_back({g, "coverage of the worst ply", plies.least, 4});
    out.push_back({g, "fill ratio", fill, 4});
    out.push_back({g, "overlap", fill - coverage, 4});
    out.push_back({g, "largest void beyond beads", a.void_radius, 3, "mm"});
    if (a.void_radius > 0) out.push_back({g, "largest void at", place(a.void_at)});
    if (a.unreached > 0) out.push_back({g, "parts of the surface without a path", a.unreached, 2, "mm2"});
    if (a.strip > 0) {
        out.push_back({g, "share within d of a rim", share(a.strip, a.surface), 4});
        out.push_back({g, "coverage within d of a rim", share(a.strip_covered, a.strip), 4});
        out.push_back({g, "coverage elsewhere", share(a.covered - a.strip_covered, a.surface - a.strip), 4});
    }
    if (plies.beside > 0) out.push_back({g, "path beside the surface", plies.beside, 2, "mm"});
    if (plies.aloft > 0) out.push_back({g, "path above the surface", plies.aloft, 2, "mm"});
    if (plies.lost > 0) out.push_back({g, "path across gaps of the surface", plies.lost, 2, "mm"});
}

void spacing(const Job& job, bool turns, Figures& out) {
    const std::string g = turns ? "spacing" : "spacing outside turns";
    std::vector<Weighted> signed_error, error;
    for (const Gap& gap : gaps(job.samples, job.spread, turns, job.threads)) {
        signed_error.push_back({gap.error, gap.length});
        error.push_back({std::abs(gap.error), gap.length});
    }
    double sides = 0, found = 0;
    for (const Sample& s : job.samples) sides += s.hairpin || (s.turning && !turns) ? 0 : 2 * s.length;
    for (const Weighted& w : error) found += w.weight;
    if (turns)
        out.push_back({g, "d", job.options.spacing, 4, "mm"});
    else
        out.push_back({g, "share of the path", share(sides / 2, length(job.fibres)), 4});
    out.push_back({g, "sides with a neighbour", share(found, sides), 4});
    for (const int p : {1, 50, 99})
        out.push_back({g, "gap / d - 1, p" + std::to_string(p), quantile(signed_error, p / 100.0), 4});
    for (const int p : {50, 99})
        out.push_back({g, "|gap / d - 1|, p" + std::to_string(p), quantile(error, p / 100.0), 4});
}

void load(const Job& job, Figures& out) {
    const auto cases = load_cases(job.sheet);
    if (cases.empty() || job.samples.empty()) return;
    const Surface& s = job.sheet.surface;
    std::vector<LoadFigures> each;
    for (const LoadCase& c : cases) each.push_back(adequacy(job.samples, s, c));
    const PaperLoad paper = paper_adequacy(job.samples, s, cases);
    const auto least = [&](double LoadFigures::*of) {
        double out = INFINITY;
        for (const auto& e : each) out = std::min(out, e.*of);
        return out;
    };
    const std::string g = "load";
    out.push_back({g, "load cases", std::uint64_t{cases.size()}});
    out.push_back({g, "paper: mean |t . d1| of the best case at each point", paper.mean, 4});
    out.push_back({g, "paper: upper bound", paper.best, 4});
    out.push_back({g, "paper: at random", paper.random, 4});
    out.push_back({g, "|t . d1|, least of cases", least(&LoadFigures::mean), 4});
    out.push_back({g, "along the surface, least of cases", least(&LoadFigures::tangential), 4});
    out.push_back({g, "along the surface, by |s1|, least of cases", least(&LoadFigures::weighted), 4});
    for (std::size_t k = 0; k < each.size(); ++k) {
        const std::string h = "load case " + cases[k].name;
        out.push_back({h, "|t . d1|", each[k].mean, 4});
        out.push_back({h, "|t . d1|, upper bound", each[k].best, 4});
        out.push_back({h, "along the surface", each[k].tangential, 4});
        out.push_back({h, "along the surface, by |s1|", each[k].weighted, 4});
        out.push_back({h, "along the surface, at random", each[k].random, 4});
        out.push_back({h, "share within 15 degrees", each[k].within, 4});
        if (each[k].known < 1) out.push_back({h, "share of the path with a known stress", each[k].known, 4});
    }
}

void off_surface(const Feet& feet, const std::vector<Sample>& samples, Figures& out) {
    std::vector<Weighted> off = feet.off;
    for (const Sample& s : samples) off.push_back({s.off, s.length});
    out.push_back({"off the surface", "p50", quantile(off, 0.5), 4, "mm"});
    out.push_back({"off the surface", "p99", quantile(off, 0.99), 4, "mm"});
    out.push_back({"off the surface", "max", quantile(off, 1), 4, "mm"});
}

// Options that nothing sensible, or nothing in sensible time, could be measured by.
void check(const Options& o, double width, double length) {
    const auto mm = [](double v) { return shortest_text(v) + " mm"; };
    if (o.spacing > kWidest * width || o.spacing * kWidest < width)
        throw Error(Exit::usage, "cannot take strands of beads " + mm(width) + " wide as " + mm(o.spacing) +
                                     " apart; give a --spacing nearer to that");
    if (o.step > o.spacing)
        throw Error(Exit::usage, "cannot sample every " + mm(o.step) + " where strands are " + mm(o.spacing) +
                                     " apart; give a smaller --step");
    if (length / o.step > kMostSamples)
        throw Error(Exit::usage, "cannot sample " + mm(length) + " of path every " + mm(o.step) +
                                     ": too many samples; give a greater --step");
}

} // namespace

Measured measure(const Fibres& fibres, const filum::surface::Sheet& sheet, const Options& given, bool distance,
                 int threads) {
    Measured out;
    const double width = median_width(fibres);
    Options options = given;
    if (options.spacing == 0) options.spacing = width;
    if (fibres.chains.empty() || !(width > 0)) {
        continuity(fibres, filum::surface::area(sheet.surface), out.figures);
        return out;
    }
    if (options.step == 0) options.step = options.spacing / 4;
    check(options, width, length(fibres));
    Job job(fibres, sheet, options, width, threads);
    const Feet touch = feet(fibres, job.ground, threads);
    const auto bent = bend(job, touch);
    mark_turns(bent, job.samples);
    auto plies = measure_plies(fibres, job.ground, job.samples, {options.spacing, distance}, threads);
    continuity(fibres, plies.area.surface, out.figures);
    out.figures.push_back({"continuity", "retraced", retraced(job.samples, threads), 1, "mm"});
    curvature(job, bent, out.figures);
    tight_turns(job, touch, out.figures);
    area(plies, out.figures);
    spacing(job, true, out.figures);
    spacing(job, false, out.figures);
    load(job, out.figures);
    off_surface(touch, job.samples, out.figures);
    out.distance = std::move(plies.distance);
    return out;
}

} // namespace filum::metrics::surface
