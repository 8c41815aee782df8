#include "surfpath/rings.hpp"

#include "base/error.hpp"
#include "geodesic/exact.hpp"
#include "geodesic/isolines.hpp"
#include "parallel/parallel.hpp"
#include "surfpath/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace filum::surfpath {

namespace {

using surface::kNone;

constexpr double kStretch = 0.03;  // of the spacing
constexpr double kOfRidge = 0.9;   // of the way to the ridge that a turn of a ring takes, where the ridge is near
constexpr double kRounder = 1.05;  // least radii: what corners are rounded by, so that little remains to be eased
constexpr double kTightest = 0.3;  // spacings: no ring turns tighter

// The sources, and all rims.
surface::Sources all_sources(const surface::Sheet& sheet) {
    const Surface& s = sheet.surface;
    surface::Sources out = sheet.sources;
    out.segments.clear();
    for (const auto& segment : sheet.sources.segments) out.segments.push_back(segment);
    for (const auto& rim : s.rims)
        for (const auto h : rim.sides) out.segments.push_back({h / 3, s.vertices[s.tail(h)], s.vertices[s.head(h)]});
    if (out.empty())
        throw Error(Exit::bad_input, "cannot lay rings on a closed surface without a source; run geodesic --source "
                                     "vertex:ID (or another) first");
    return out;
}

// The spacing up to `d` for which the farthest place is a whole number of them and a half away, if one is near; else one
// that is a little less, which wins more of the gaps at corners than it loses.
double stretched(double farthest, double d) {
    const double fits = farthest / (std::ceil(farthest / d - 0.5 - 1e-9) + 0.5);
    return fits >= (1 - kStretch) * d ? std::min(fits, d) : (1 - kStretch / 2) * d;
}

// The highest vertex of the triangles that a line runs through; kNone if none is as high as the line.
std::uint32_t top(const Surface& s, const std::vector<double>& far, const Isoline& line) {
    std::uint32_t out = kNone;
    for (const auto t : line.triangles)
        for (const auto v : s.triangles[t])
            if (far[v] >= line.level && (out == kNone || far[v] > far[out] || (far[v] == far[out] && v < out))) out = v;
    return out;
}

// From where to find the highest vertex that can be reached without going below a level.
struct Climb {
    double level;
    std::uint32_t from;       // kNone: leads nowhere
    std::uint32_t to = kNone; // found
};
void climb(const Surface& s, const std::vector<double>& far, std::vector<Climb>& climbs) {
    const auto higher = [&](std::uint32_t a, std::uint32_t b) { return far[a] != far[b] ? far[a] > far[b] : a < b; };
    std::vector<std::uint32_t> order(far.size()), root(far.size()), turn(climbs.size());
    std::iota(order.begin(), order.end(), 0U);
    std::iota(root.begin(), root.end(), 0U);
    std::iota(turn.begin(), turn.end(), 0U);
    std::sort(order.begin(), order.end(), higher);
    std::stable_sort(turn.begin(), turn.end(), [&](auto a, auto b) { return climbs[a].level > climbs[b].level; });
    const auto find = [&](std::uint32_t v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    std::size_t at = 0;
    for (const auto i : turn) {
        Climb& c = climbs[i];
        for (; at < order.size() && far[order[at]] >= c.level; ++at)
            surface::each_outgoing(s, order[at], [&](std::uint32_t h) {
                for (const auto v : {s.head(h), s.tail(surface::prev(h))}) {
                    if (!(far[v] >= c.level)) continue;
                    const auto a = find(v), b = find(order[at]);
                    if (a != b) root[higher(a, b) ? b : a] = higher(a, b) ? a : b;
                }
            });
        if (c.from != kNone) c.to = find(c.from);
    }
}

} // namespace

Rings rings(const surface::Sheet& sheet, const Options& o, Facts& facts) {
    const Surface& s = sheet.surface;
    const auto field = geodesic::exact(s, all_sources(sheet));
    const auto& far = field.distance;
    double farthest = 0;
    for (const double d : far)
        if (std::isfinite(d)) farthest = std::max(farthest, d);
    Rings out;
    out.spacing = stretched(farthest, o.spacing);
    const double d = out.spacing, least = kRounder * o.least_radius;
    std::vector<double> levels;
    for (double l = d / 2; l < farthest; l += d) levels.push_back(l);
    const auto outer = geodesic::isolines(s, field, levels);
    std::vector<Climb> climbs;
    for (const auto& line : outer) climbs.push_back({line.level, top(s, far, line)});
    climb(s, far, climbs);

    // rings by level, those within low ridges apart
    std::vector<Batch> batches;
    std::vector<std::vector<std::uint32_t>> tops; // per batch: where its rings lead up to
    for (const double l : levels) {
        Batch high{l, {}, {{least}, {0.6 * least}, {0.35 * least}}};
        std::vector<std::uint32_t> high_tops;
        for (std::size_t i = 0; i < outer.size(); ++i) {
            if (!outer[i].closed || outer[i].level != l || climbs[i].to == kNone) continue;
            const double rise = far[climbs[i].to] - l, radius = kOfRidge * rise;
            if (rise > least) {
                high.outer.push_back(&outer[i]), high_tops.push_back(climbs[i].to);
                continue;
            }
            const double all = curve::length(curve::line(outer[i]));
            if (radius < kTightest * d || all < kGain * least * 2 * std::numbers::pi * (1 - radius / least)) continue;
            batches.push_back({l, {&outer[i]}, {{radius}, {0.55 * radius}}});
            tops.push_back({climbs[i].to});
        }
        if (!high.outer.empty()) batches.push_back(std::move(high)), tops.push_back(std::move(high_tops));
    }
    std::vector<double> inner_levels;
    for (const auto& b : batches)
        for (const auto& scale : b.scales) inner_levels.push_back(b.level + scale.radius);
    std::sort(inner_levels.begin(), inner_levels.end());
    inner_levels.erase(std::unique(inner_levels.begin(), inner_levels.end()), inner_levels.end());
    const auto inner = geodesic::isolines(s, field, inner_levels);
    struct Use {
        std::size_t batch, scale;
        const Isoline* line;
    };
    std::vector<Use> uses;
    climbs.clear();
    for (std::size_t b = 0; b < batches.size(); ++b)
        for (std::size_t k = 0; k < batches[b].scales.size(); ++k) {
            const double level = batches[b].level + batches[b].scales[k].radius;
            auto at = std::lower_bound(inner.begin(), inner.end(), level,
                                       [](const Isoline& l, double x) { return l.level < x; });
            for (; at != inner.end() && at->level == level; ++at)
                if (at->closed) uses.push_back({b, k, &*at}), climbs.push_back({batches[b].level, top(s, far, *at)});
        }
    climb(s, far, climbs);
    for (std::size_t i = 0; i < uses.size(); ++i) {
        const auto& t = tops[uses[i].batch];
        if (std::find(t.begin(), t.end(), climbs[i].to) != t.end())
            batches[uses[i].batch].scales[uses[i].scale].inner.push_back(uses[i].line);
    }
    const Rounding rounding(s, field, least, d);
    parallel::for_chunks(batches.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) rounding(batches[i]);
    });
    for (auto& b : batches)
        for (auto& line : b.lines) {
            out.lines.push_back(std::move(line));
            out.level.push_back(static_cast<int>(std::lround(b.level / d - 0.5)));
            out.radius.push_back(b.scales[0].radius);
        }
    facts.push_back({"", "rings", static_cast<double>(out.lines.size()), ""});
    facts.push_back({"", "stretch", out.spacing / o.spacing, ""});
    return out;
}

} // namespace filum::surfpath
