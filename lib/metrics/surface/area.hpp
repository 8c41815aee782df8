// How much of a surface lies under beads.
#pragma once

#include "geodesic/exact.hpp"
#include "metrics/surface/ground.hpp"

#include <limits>
#include <span>

namespace filum::metrics::surface {

// The path as source of exact distances on the finer surface, one field per bead width: widths within 2 % of each other
// count as one, their mean; at most 64.
struct PathField {
    struct Class {
        double width = 0; // mm
        geodesic::ExactField field;
    };
    std::vector<Class> classes;
};
PathField path_field(const Ground& ground, const Shadow& shadow);

// Distance from the nearest bead's edge, mm: below 0 under beads.
double clearance(const Ground& ground, const PathField& field, std::uint32_t fine_triangle, const Vec3& p);

struct Area {
    double surface = 0;       // mm2
    double covered = 0;       // mm2 within half a bead's width of the path, along the surface
    double unreached = 0;     // mm2 of components without any path
    double strip = 0;         // mm2 within `strip_width` of a rim,
    double strip_covered = 0; // of it covered
    double void_radius = 0;   // mm: the greatest clearance of a place that a path reaches
    Vec3 void_at{};           // where
    double row = 0;           // mm between the rows that were swept
};

// Areas are swept by rows in every triangle, with ends solved from the exact windows; rows come closer, from an eighth
// of the widest bead to a 128th, until coverage changes by less than `stable`.  No strip along rims with a width of 0.
Area measure_area(const Ground& ground, const PathField& field, double strip_width, int threads, double stable = 1e-4);

// The paper's share (Kipping et al. 2022, 4.1.3): 1 - A_u / A_s, where A_u are triangles whose three corners are all
// farther than `d` from the path.  Its text prints (1 - A_u) / A_s, but says what 0 and 1 mean.  Path points are the
// ends of the samples; distances are exact, the triangles those of the finer surface.
double paper_area_fraction(const Ground& ground, std::span<const Sample> samples, double d, int threads);

} // namespace filum::metrics::surface
