#include "surface/fit/fit.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "surface/fit/apart.hpp"
#include "surface/fit/fitter.hpp"
#include "surface/fit/sizes.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surface::fit {

namespace {

using curve::Locator;

constexpr double kMostTriangles = 2e7;
constexpr int kCorrections = 3; // of sizes, where chords are off by more
constexpr double kSamples = 4;  // on a side, to tell how far surfaces are apart

// Middles of sides, each once, and of triangles; with the length of the side, or of the longest.
void middles(const Surface& s, std::vector<Vec3>& points, std::vector<double>& lengths) {
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto& [a, b, c] = s.triangles[t];
        double longest = 0;
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            const double length = side_length(s, h);
            longest = std::max(longest, length);
            if (s.twin[h] != kNone && s.twin[h] < h) continue;
            points.push_back(0.5 * (s.vertices[s.tail(h)] + s.vertices[s.head(h)]));
            lengths.push_back(length);
        }
        points.push_back(1.0 / 3 * (s.vertices[a] + s.vertices[b] + s.vertices[c]));
        lengths.push_back(longest);
    }
}

// Makes sizes shorter where chords of `now` are farther from `s` than the tolerance; false if nowhere.
bool corrected(const Surface& s, const Locator& locator, const Surface& now, double tolerance,
               std::vector<double>& sizes) {
    std::vector<Vec3> points;
    std::vector<double> lengths;
    middles(now, points, lengths);
    const auto places = nearest(locator, points);
    bool out = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double far = distance(points[i], places[i].point);
        if (!(far > tolerance)) continue;
        const double most = std::max(kLeast * tolerance, lengths[i] * std::sqrt(tolerance / far));
        for (const std::uint32_t v : s.triangles[places[i].triangle]) {
            out = out || most < sizes[v];
            sizes[v] = std::min(sizes[v], most);
        }
    }
    if (out) grade(s, sizes);
    return out;
}

double triangles(const Surface& s, std::span<const double> sizes) {
    double out = 0;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto& [a, b, c] = s.triangles[t];
        const double size = (sizes[a] + sizes[b] + sizes[c]) / 3;
        out += area(s, t) / (std::sqrt(3) / 4 * size * size);
    }
    return out;
}

} // namespace

Fitted fitted(const Surface& s, const Options& o) {
    auto size = sizes(s, o.longest, o.tolerance);
    if (!(triangles(s, size) <= kMostTriangles))
        throw Error(Exit::usage, "cannot remesh to sides of " + shortest_text(o.longest) +
                                     " mm: that takes more than 20 million triangles; ask for longer ones");
    const Locator locator(s);
    Fitter fitter(s, locator, size, editable(s, size, o.tolerance));
    fitter.run();
    Surface now = compact(fitter.result());
    for (int k = 0; k < kCorrections && corrected(s, locator, now, o.tolerance, size); ++k) {
        fitter.resize();
        fitter.run();
        now = compact(fitter.result());
    }
    const double step = mean_edge(now) / kSamples;
    const Apart there = farthest(now, locator, step), back = farthest(s, Locator(now), step);
    const Apart& most = back.far > there.far ? back : there;
    return {std::move(now), most.far, most.at};
}

} // namespace filum::surface::fit
