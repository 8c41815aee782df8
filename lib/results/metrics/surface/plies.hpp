// The area under a path, ply by ply.
#pragma once

#include "metrics/surface/area.hpp"
#include "surface/sheet.hpp"

#include <optional>
#include <span>

namespace filum::metrics::surface {

// Sums over the plies, that is layers, of a path; areas count once per ply.
struct Plies {
    std::size_t count = 0;
    Area area;                                     // sums, and the largest void of any ply
    double least = 1;                              // coverage of the worst ply
    double laid = 0;                               // mm2: length times width, except beside the surface
    double paper = 0;                              // the paper's fraction, summed
    double beside = 0, aloft = 0, lost = 0;        // mm of path, see Shadow
    std::optional<filum::surface::Sheet> distance; // field "path-distance": the greatest of all plies
};

struct PlyOptions {
    double spacing = 1;    // mm, d
    bool distance = false; // also computes the field
};

// The level of a ply is the median distance of its samples from the surface.
Plies measure_plies(const Fibres& fibres, const Ground& ground, std::span<const Sample> samples,
                    const PlyOptions& options, int threads);

} // namespace filum::metrics::surface
