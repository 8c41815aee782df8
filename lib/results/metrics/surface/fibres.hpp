// Fibres: the path of a toolpath between two cuts.
#pragma once

#include "toolpath/path.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace filum::metrics::surface {

using geom::Vec3;

// One uncut length of fibre.
struct Fibre {
    std::vector<Vec3> points;         // mm; consecutive points differ; at least two
    std::vector<double> along;        // mm from the start, per point
    std::vector<Vec3> axes;           // unit, per point: from the surface to the tool; (0, 0, 0) if unknown
    std::vector<toolpath::Role> role; // per segment
    std::vector<std::uint32_t> layer; // per segment: the ply
    std::vector<double> width;        // mm, per segment: the mean of its ends
    std::vector<double> height;       // mm, per segment: the mean of its ends

    [[nodiscard]] double length() const { return along.back(); }
};

// The chains of a toolpath in its order. A chain ends at a travel, or where the next span does not begin within 1e-6
// mm of the end of the one before.
struct Fibres {
    std::vector<Fibre> all;
    double travel = 0;     // mm between the chains: of travels, and straight across jumps
    std::size_t jumps = 0; // spans that begin elsewhere than the one before ended

    Vec3 at{}; // the end of the last span
    bool begun = false, open = false;
};

// Adds the moves of `span`, except segments shorter than 1e-9 mm.
void add(Fibres& fibres, const toolpath::Span& span);

double length(const Fibres& fibres);       // mm
double median_width(const Fibres& fibres); // mm, by length; 0 if there is no fibre

// The point of a chain at `s` mm from its start. The search begins at segment `stretch`, which is set to the segment
// of the point. Precondition: s is not before that segment.
Vec3 point_at(const Fibre& chain, double s, std::size_t& stretch);

// Points at equal distances along the chain, as close to `step` mm as divides it evenly; at least its two ends.
std::vector<Vec3> resampled(const Fibre& chain, double step);

// A value with a weight; quantile() returns the least value with at least the fraction `q` of the total weight at or
// below it; nan without values.
struct Weighted {
    double value, weight;
};
double quantile(std::vector<Weighted>& values, double q); // sorts them

} // namespace filum::metrics::surface
