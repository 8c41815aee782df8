// How closely fibres follow the directions of principal stress.
#pragma once

#include "metrics/surface/ground.hpp"
#include "surface/sheet.hpp"

#include <span>
#include <string>

namespace filum::metrics::surface {

// A load case of a sheet: its fields stress.NAME.s1 and stress.NAME.d1.
struct LoadCase {
    std::string name;
    const filum::surface::Field* s1 = nullptr; // MPa; may be null
    const filum::surface::Field* d1 = nullptr;
};

// In the order of the fields. Throws Error(bad_input) if a d1 is not a field of vectors, or an s1 not one of numbers.
std::vector<LoadCase> load_cases(const filum::surface::Sheet& sheet);

// The direction of a field of vectors at a place, unit: the weighted mean of those of the triangle's corners, each
// with the sign that agrees with the one of the greatest weight; (0, 0, 0) if unknown.
Vec3 direction(const Surface& s, const filum::surface::Field& d1, const filum::surface::curve::Place& at);

// All are means of absolute values, as directions have no sign. Samples without a known stress do not count.
struct LoadFigures {
    double known = 0; // fraction of the length with a known d1
    double mean = 0;  // of |t . d1|, by length; t: unit, along the path
    double tangential =
        0; // of the cosine of the angle between t and d1, both projected onto the tangent plane, by length
    double weighted = 0; // the same, weighted by length times |s1|
    double best = 0;     // the upper bound of `mean` on this surface: the mean length of d1's projection
    double random = 0;   // the value of `tangential` for random directions: 2 / pi, computed
    double within = 0;   // fraction of the length with an angle of at most 15 degrees
};
LoadFigures adequacy(std::span<const Sample> samples, const Surface& surface, const LoadCase& load);

// The paper's value (Kipping et al. 2022, 4.1.4): the mean over samples of |t . d1|, d1 at the nearest vertex of the
// triangle below, of the load cases the one that aligns best at each place.
struct PaperLoad {
    double mean = 0;
    double best = 0;   // its upper bound: the best direction in the tangent plane at every sample
    double random = 0; // what it comes to by directions at random in the tangent plane: the mean over 180 of them
};
PaperLoad paper_adequacy(std::span<const Sample> samples, const Surface& surface, std::span<const LoadCase> loads);

// The paper's rule by sizes of the stress: the greatest pull along the path of any load case at each sample, over the
// greatest pull there is: the sum of max_k(s_k |t . d_k|) over that of max_k(s_k), with s_k = max(0, s1), or 1 where no
// s1 is known of the case; by length, at the nearest vertex of the triangle below.  nan if nothing pulls.
double pull_adequacy(std::span<const Sample> samples, const Surface& surface, std::span<const LoadCase> loads);

// The same of a place: the pull along the unit vector `t` at `vertex`, and the greatest that there is, MPa.
struct Pull {
    double along = 0, most = 0;
};
Pull pull(std::span<const LoadCase> loads, std::uint32_t vertex, const Vec3& t);

} // namespace filum::metrics::surface
