// The area of a surface that beads cover.
#pragma once

#include "geodesic/exact.hpp"
#include "metrics/surface/ground.hpp"

#include <limits>
#include <span>

namespace filum::metrics::surface {

// Exact distances from the path on the finer surface, one field per class of bead widths: widths within 2 % of each
// other form a class with their mean; at most 64 classes.
struct PathField {
    struct Class {
        double width = 0; // mm
        geodesic::ExactField field;
    };
    std::vector<Class> classes;
};
PathField path_field(const Ground& ground, const Shadow& shadow);

// Distance from the edge of the nearest bead, mm; negative under beads.
double clearance(const Ground& ground, const PathField& field, std::uint32_t fine_triangle, const Vec3& p);

struct Area {
    double surface = 0;       // mm2
    double covered = 0;       // mm2 within half a bead width of the path, measured along the surface
    double unreached = 0;     // mm2 of components without any path
    double strip = 0;         // mm2 within `strip_width` of a rim
    double strip_covered = 0; // mm2 of the strip that is covered
    double void_radius = 0;   // mm: the greatest clearance in components with a path
    Vec3 void_at{};           // the place of that
    double row = 0;           // mm: the final distance of the rows
};

// Integrates along parallel rows in every triangle, the ends of their parts solved from the exact windows. The
// distance of rows is reduced from an eighth of the widest bead to a 128th until coverage changes by less than
// `stable`. Without a strip along rims if `strip_width` is 0.
Area measure_area(const Ground& ground, const PathField& field, double strip_width, int threads, double stable = 1e-4);

// The paper's fraction (Kipping et al. 2022, 4.1.3): 1 - A_u / A_s, where A_u is the area of triangles with all three
// corners farther than `d` from the path. The formula in print is (1 - A_u) / A_s, but the text says what 0 and 1
// mean. Path points are the ends of the samples; distances are exact; triangles are those of the finer surface.
double paper_area_fraction(const Ground& ground, std::span<const Sample> samples, double d, int threads);

} // namespace filum::metrics::surface
