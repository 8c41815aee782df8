// What the six algorithms of the paper are told.
#pragma once

#include "surface/section.hpp"
#include "surfpath/algorithm.hpp"

#include <cstdint>
#include <optional>

namespace filum::baselines::kipping2022 {

// 0 stands for a default that depends on others; settled() puts it in.
struct Options {
    surfpath::Algorithm algorithm = surfpath::Algorithm::geo_fiso;
    double spacing = 1;                    // mm, d: between neighbouring lines
    std::optional<surface::Plane> plane{}; // P of fina and fexa; none: the one that the sources lie in
    double resample = 0;                   // mm, r_resample: between points of paths; default d / 4
    std::int64_t window = 5;               // points, of the Savitzky-Golay filter: odd; 1: none
    std::int64_t degree = 2;               // of its polynomials, below the window
    double iso = 0;                        // mm, d_iso of ortheo: between the isocontours it steps along; default d
    double least_spacing = 0;              // mm: ortheo ends a line that comes nearer to the one before; default 0.4 d
    double reach = 0;                      // mm, t_dist: of what contours are joined across; default 1.2 d
    std::int64_t run = 0;                  // points, n_thresh: of a place for that; default ceil(d / r_resample)
};

// With the defaults that depend on others put in.
// Throws Error(usage) for numbers that make no path.
Options settled(Options options);

} // namespace filum::baselines::kipping2022
