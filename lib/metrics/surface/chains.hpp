// Fibres: what a toolpath lays between two cuts.
#pragma once

#include "toolpath/path.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace filum::metrics::surface {

using geom::Vec3;

// One piece of fibre.
struct Chain {
    std::vector<Vec3> points;         // mm; no two in a row are the same; at least two
    std::vector<double> along;        // mm from the start, per point
    std::vector<Vec3> axes;           // per point: where the tool comes from; (0, 0, 0) where that is not said
    std::vector<toolpath::Role> role; // per stretch
    std::vector<std::uint32_t> layer; // per stretch: the ply
    std::vector<double> width;        // mm, per stretch: the mean of its ends
    std::vector<double> height;       // likewise

    [[nodiscard]] double length() const { return along.back(); }
};

// The chains of a toolpath, in its order.  A chain ends where the tool travels, or where a span does not begin within
// 1e-6 mm of where the one before ended.
struct Fibres {
    std::vector<Chain> chains;
    double travel = 0;     // mm between the chains: of travels, and straight across jumps
    std::size_t jumps = 0; // spans that begin elsewhere

    Vec3 at{}; // where the last span ended
    bool begun = false, open = false;
};

// Adds the moves of `span`; stretches of less than 1e-9 mm are left out.
void add(Fibres& fibres, const toolpath::Span& span);

double length(const Fibres& fibres);       // mm
double median_width(const Fibres& fibres); // mm, by length; 0 if there is no fibre

// The point of a chain that is `s` mm from its start; `stretch` is where to begin looking, and becomes the one it lies
// in.  Precondition: s does not lie before that stretch.
Vec3 point_at(const Chain& chain, double s, std::size_t& stretch);

// The chain's points at equal distances along it, as near to `step` mm as divides it evenly; at least its ends.
std::vector<Vec3> resampled(const Chain& chain, double step);

// The value that a share `q` of the weight lies at or below; nan if there is none.
struct Weighted {
    double value, weight;
};
double quantile(std::vector<Weighted>& values, double q); // sorts them

} // namespace filum::metrics::surface
