#include "render/tint.hpp"

#include "base/number.hpp"
#include "geom/polyline.hpp"
#include "machine/feed.hpp"

#include <algorithm>
#include <set>

namespace filum::render {

namespace {

using toolpath::Feature;
using toolpath::Role;

constexpr int kSteps = 1024; // number of steps of the ramp

// The amount that colours a segment: its feed for By::speed, else its mean width.
double amount(const Tint& tint, const toolpath::Span& s, std::size_t i) {
    if (tint.by == ColourBy::speed) return machine::bead_feed(*tint.profile, machine::extruding_move(s, i));
    return (s.width_at(i) + s.width_at(i + 1)) / 2;
}

void amount_range(const Scene& scene, Tint& out) {
    std::vector<std::pair<double, double>> all; // pairs of amount and length
    double total = 0;
    for (const auto& s : scene.spans) {
        if (!toolpath::extrudes(s.role)) continue;
        for (std::size_t i = 0; i + 1 < s.points.size(); ++i) {
            all.emplace_back(amount(out, s, i), geom::distance(s.points[i], s.points[i + 1]));
            total += all.back().second;
        }
    }
    std::sort(all.begin(), all.end());
    double sum = 0;
    out.lo = out.hi = all.empty() ? 0 : all.front().first;
    for (const auto& [w, l] : all) {
        if (sum <= 0.01 * total) out.lo = w;
        if (sum <= 0.99 * total) out.hi = w;
        sum += l;
    }
}

} // namespace

Tint tint(const Scene& scene, ColourBy by, const machine::Profile* profile) {
    Tint out;
    out.by = by;
    out.profile = profile;
    for (int k = 0; k < kSteps; ++k) out.ramp.push_back(to_srgb8(ramp((k + 0.5) / kSteps)));
    std::set<std::uint32_t> strokes;
    std::uint32_t lo = UINT32_MAX, hi = 0;
    double along = 0;
    for (const auto& s : scene.spans) {
        strokes.insert(s.stroke);
        if (by == ColourBy::tool && toolpath::extrudes(s.role)) out.tools.insert(s.tool);
        lo = std::min(lo, s.layer);
        hi = std::max(hi, s.layer);
        if (s.feature == Feature::none || s.role != Role::bead)
            out.roles[static_cast<std::size_t>(s.role)] = true;
        else
            out.features[static_cast<std::size_t>(s.feature)] = true;
        if (by != ColourBy::progress) continue;
        out.begin.push_back(along);
        if (toolpath::extrudes(s.role)) along += geom::length(s.points);
    }
    out.strokes = strokes.size();
    if (by == ColourBy::progress) out.hi = std::max(along, 1e-9);
    if (by == ColourBy::layer) {
        out.lo = std::min(lo, hi);
        out.hi = hi;
    }
    if (by == ColourBy::width || by == ColourBy::speed) amount_range(scene, out);
    return out;
}

const char* role_name(Role role) {
    constexpr const char* kNames[] = {"bead", "lift", "jog", "connector", "travel", "hairpin"};
    return kNames[static_cast<std::size_t>(role)];
}

Rgb role_colour(Role role) {
    switch (role) {
    case Role::bead:
        return oklch(0.72, 0.09, 235);
    case Role::lift:
        return oklch(0.76, 0.17, 65);
    case Role::jog:
        return oklch(0.64, 0.21, 350);
    case Role::connector:
        return oklch(0.60, 0.22, 28);
    case Role::travel:
        return oklch(0.55, 0.02, 260);
    case Role::hairpin:
        return oklch(0.66, 0.16, 300);
    }
    return {};
}

Rgb feature_colour(Feature feature) {
    switch (feature) {
    case Feature::none:
        return role_colour(Role::bead);
    case Feature::outer_wall:
        return oklch(0.62, 0.17, 45);
    case Feature::wall:
        return oklch(0.80, 0.14, 80);
    case Feature::top:
        return oklch(0.60, 0.17, 330);
    case Feature::solid:
        return oklch(0.66, 0.12, 250);
    case Feature::bottom:
        return oklch(0.58, 0.12, 220);
    case Feature::gap:
        return oklch(0.75, 0.12, 20);
    case Feature::ironing:
        return oklch(0.70, 0.10, 0);
    case Feature::tower:
        return oklch(0.60, 0.05, 200);
    case Feature::bridge:
        return oklch(0.55, 0.18, 285);
    case Feature::infill:
        return oklch(0.68, 0.15, 150);
    case Feature::support:
        return oklch(0.78, 0.04, 100);
    case Feature::interface:
        return oklch(0.62, 0.07, 110);
    case Feature::skirt:
        return oklch(0.70, 0.03, 60);
    }
    return {};
}

Srgb8 colour(const Tint& tint, const Scene& scene, std::size_t s, std::size_t i, double along) {
    const toolpath::Span& span = scene.spans[s];
    if (!toolpath::extrudes(span.role)) return to_srgb8(role_colour(span.role));
    const auto on_ramp = [&](double v) {
        const double t = tint.hi > tint.lo ? (v - tint.lo) / (tint.hi - tint.lo) : 0.6;
        return tint.ramp[static_cast<std::size_t>(std::clamp(t * kSteps, 0.0, kSteps - 1.0))];
    };
    switch (tint.by) {
    case ColourBy::progress:
        return on_ramp(tint.begin[s] + along);
    case ColourBy::stroke:
        return to_srgb8(distinct(span.stroke));
    case ColourBy::layer:
        return on_ramp(span.layer);
    case ColourBy::width:
    case ColourBy::speed:
        return on_ramp(amount(tint, span, i));
    case ColourBy::tool:
        return to_srgb8(distinct(span.tool));
    case ColourBy::role:
        return to_srgb8(span.role == Role::bead ? feature_colour(span.feature) : role_colour(span.role));
    }
    return {};
}

void add_legend(Key& key, const Tint& tint) {
    switch (tint.by) {
    case ColourBy::progress:
        return key.ramp("start", "end");
    case ColourBy::stroke:
        return key.text(std::to_string(tint.strokes) + (tint.strokes == 1 ? " stroke" : " strokes"));
    case ColourBy::layer:
        return key.ramp({"layer", tint.lo, tint.hi});
    case ColourBy::width:
        return key.ramp({"width", tint.lo, tint.hi, "mm"});
    case ColourBy::speed:
        return key.ramp({"speed", tint.lo, tint.hi, "mm/s"});
    case ColourBy::tool:
        for (const std::uint32_t tool : tint.tools) key.swatch(distinct(tool), "tool " + std::to_string(tool));
        return;
    case ColourBy::role:
        for (std::size_t r = 0; r < tint.roles.size(); ++r)
            if (tint.roles[r]) key.swatch(role_colour(static_cast<Role>(r)), role_name(static_cast<Role>(r)));
        for (std::size_t f = 0; f < tint.features.size(); ++f)
            if (tint.features[f]) key.swatch(feature_colour(static_cast<Feature>(f)), toolpath::kFeatureNames[f]);
    }
}

void draw_legend(Canvas& canvas, const Tint& tint) {
    Key key(canvas);
    add_legend(key, tint);
}

} // namespace filum::render
