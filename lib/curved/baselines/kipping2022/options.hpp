// The options of the paper's six algorithms.
#pragma once

#include "surface/section.hpp"
#include "surfpath/algorithm.hpp"

#include <cstdint>
#include <optional>

namespace filum::baselines::kipping2022 {

// 0 stands for a default that depends on other options; settled() inserts it.
struct Options {
    surfpath::Algorithm algorithm = surfpath::Algorithm::geo_fiso;
    double spacing = 1;                    // mm, d: between neighbouring lines
    std::optional<surface::Plane> plane{}; // P of fina and fexa; none: the plane of the sources
    double resample = 0;                   // mm, r_resample: between points of paths; default d / 4
    std::int64_t window = 5;               // points of the Savitzky-Golay filter: odd; 1: no filter
    std::int64_t degree = 2;               // of its polynomials, less than the window
    double iso = 0;                        // mm, d_iso of ortheo: between its isocontours; default d
    double least_spacing = 0;              // mm: ortheo ends a line nearer than this to the one before; default 0.4 d
    double reach = 0;                      // mm, t_dist: largest distance of contours that are joined; default 1.2 d
    std::int64_t run = 0;                  // points, n_thresh: length of a place for that; default ceil(d / r_resample)
};

// Inserts the defaults that depend on other options.
// Throws Error(usage) for numbers that allow no path.
Options settled(Options options);

} // namespace filum::baselines::kipping2022
