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
constexpr int kCorrections = 2;                // most corrections of sizes where the surfaces are too far apart
constexpr double kPieces = 2, kFinePieces = 8; // sample points per side: to check the distance, and to report it

double longest_side(const Surface& s, std::uint32_t t) {
    return std::max({side_length(s, 3 * t), side_length(s, 3 * t + 1), side_length(s, 3 * t + 2)});
}

// Reduces sizes where the distance between `s` and `now` exceeds the tolerance; returns whether any changed.
bool corrected(const Surface& s, std::span<const Deviation> there, const Surface& now, std::span<const Deviation> back,
               double tolerance, Sizes& sizes) {
    bool out = false;
    const auto shorten = [&](double far, std::uint32_t old, std::uint32_t fitted) {
        if (!(far > tolerance)) return;
        const double most = longest_side(now, fitted) / kLong * tolerance / far;
        for (const std::uint32_t v : s.triangles[old]) {
            const double size = std::max(sizes.least[v], most);
            out = out || size < sizes.wanted[v];
            sizes.wanted[v] = std::min(sizes.wanted[v], size);
        }
    };
    for (std::uint32_t t = 0; t < there.size(); ++t) shorten(there[t].far, there[t].nearest, t);
    for (std::uint32_t t = 0; t < back.size(); ++t) shorten(back[t].far, t, back[t].nearest);
    if (out) grade(s, sizes.wanted);
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

Sizes checked_sizes(const Surface& s, const Options& o) {
    Sizes out = sizes(s, o.longest, o.tolerance);
    if (!(triangles(s, out.wanted) <= kMostTriangles))
        throw Error(Exit::usage, "cannot remesh to sides of " + shortest_text(o.longest) +
                                     " mm: that takes more than 20 million triangles; ask for longer ones");
    return out;
}

std::size_t most_splits(const Surface& s, std::span<const double> sizes) {
    return static_cast<std::size_t>(std::ceil(kMostWork * triangles(s, sizes)));
}

// Whether triangles are so long and thin that halving their sides would make more than kMostWork times as many as the
// sizes ask for: halving the sides of a triangle makes about as many as those of a compact one with the same sides.
bool needles(const Surface& s, std::span<const double> sizes) {
    double work = 0;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto& [a, b, c] = s.triangles[t];
        const double share = longest_side(s, t) / ((sizes[a] + sizes[b] + sizes[c]) / 3);
        if (share > kLong) work += share * share;
    }
    return work > kMostWork * triangles(s, sizes);
}

} // namespace

Surface evened(const Surface& s, const Options& o) {
    const Sizes size = checked_sizes(s, o);
    const Locator locator(s);
    Fitter fitter(s, locator, size.wanted, editable(s, size.wanted, o.tolerance), most_splits(s, size.wanted));
    fitter.run_by_halves();
    return compact(fitter.result());
}

FittedSurface fitted(const Surface& s, const Locator& locator, const Options& o) {
    Sizes size = checked_sizes(s, o);
    Fitter fitter(s, locator, size.wanted, editable(s, size.wanted, o.tolerance), most_splits(s, size.wanted));
    if (needles(s, size.wanted))
        fitter.run_by_halves();
    else
        fitter.run();
    Surface now = compact(fitter.result());
    for (int k = 0; k < kCorrections; ++k) {
        const double step = mean_edge(now) / kPieces;
        if (!corrected(s, deviations(now, locator, step), now, deviations(s, Locator(now), step), o.tolerance, size))
            break;
        fitter.resize(most_splits(s, size.wanted));
        fitter.run();
        now = compact(fitter.result());
    }
    return {std::move(now), -1, {}, fitter.splits(), most_splits(s, size.wanted)};
}

FittedSurface fitted(const Surface& s, const Options& o) {
    const Locator locator(s);
    FittedSurface out = fitted(s, locator, o);
    const double step = mean_edge(out.surface) / kFinePieces;
    for (const auto& list : {deviations(out.surface, locator, step), deviations(s, Locator(out.surface), step)})
        for (const Deviation& a : list)
            if (a.far > out.off) {
                out.off = a.far;
                out.off_at = a.at;
            }
    return out;
}

} // namespace filum::surface::fit
