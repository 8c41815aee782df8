#include "choose/score.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "metrics/surface/area.hpp"
#include "metrics/surface/curvature.hpp"
#include "metrics/surface/load.hpp"
#include "metrics/surface/tight.hpp"
#include "surface/curve/turns.hpp"

#include <algorithm>
#include <numbers>
#include <string>

namespace filum::choose {

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

double& named(Weights& w, std::string_view name) {
    if (name == "coverage") return w.coverage;
    if (name == "load") return w.load;
    if (name == "angle") return w.angle;
    if (name == "cuts") return w.cuts;
    if (name == "overlap") return w.overlap;
    throw Error(Exit::usage,
                "unknown weight '" + std::string(name) + "'; --weights takes coverage, load, angle, cuts and overlap");
}

} // namespace

Weights weights(std::string_view words) {
    Weights out;
    for (const auto& [name, weight] : parse_weights(words, "--weights")) named(out, name) = weight;
    if (!(out.coverage + out.load + out.angle + out.cuts + out.overlap > 0))
        throw Error(Exit::usage, "at least one of --weights must be above 0");
    return out;
}

Criteria measure(const metrics::surface::Fibres& fibres, const surface::Sheet& sheet, double spacing,
                 double least_radius, double stable) {
    if (fibres.all.empty()) throw Error(Exit::failure, "the path is empty");
    const metrics::surface::Ground ground(sheet.surface, spacing);
    auto samples = metrics::surface::samples(fibres, ground, spacing / 4, 1);
    std::erase_if(samples, [](const metrics::surface::Sample& s) { return s.beside; });
    const auto shadow = metrics::surface::shadow(fibres, ground, {0, 0, spacing / 2}, 1);
    const auto area =
        metrics::surface::measure_area(ground, metrics::surface::path_field(ground, shadow), 0, 1, stable);
    const auto loads = metrics::surface::load_cases(sheet);
    Criteria out;
    out.area = area.surface;
    out.coverage = area.covered / area.surface;
    out.load = metrics::surface::pull_adequacy(samples, sheet.surface, loads);
    out.paper_load =
        loads.empty() ? std::nan("") : metrics::surface::paper_adequacy(samples, sheet.surface, loads).mean;
    out.angle = metrics::surface::paper_angle(fibres, spacing / 4) * kDegrees;
    out.cuts = static_cast<double>(fibres.all.size() - 1);
    out.length = metrics::surface::length(fibres);
    out.overlap = std::max(0.0, 1 - area.covered / (out.length * spacing - shadow.beside_area));
    const auto normals = metrics::surface::feet(fibres, ground, 1).normals;
    const double kink = surface::curve::kKinkRadius * spacing;
    out.tight = metrics::surface::tight(fibres, normals, least_radius, spacing).length;
    out.kinks = metrics::surface::tight(fibres, normals, kink, spacing).length;
    return out;
}

double score(const Criteria& c, const Weights& w, double cut_length) {
    double sum = 0, all = 0;
    const auto add = [&](double weight, double term) {
        if (std::isnan(term)) return;
        sum += weight * std::clamp(term, 0.0, 1.0);
        all += weight;
    };
    add(w.coverage, c.coverage);
    add(w.load, c.load);
    add(w.angle, 1 - c.angle / 90);
    add(w.cuts, 1 - c.cuts * cut_length / c.length);
    add(w.overlap, 1 - c.overlap);
    return all > 0 ? sum / all : 0;
}

} // namespace filum::choose
