// The candidate paths of a patch.
#pragma once

#include "choose/seed.hpp"
#include "surfpath/algorithm.hpp"

#include <vector>

namespace filum::choose {

struct Candidate {
    surfpath::Algorithm algorithm;
    Seed seed;
};

// The candidates in this order, which decides ties:
// - what the patch carries: its algorithm with its sources; of its sources only fina, fexa and ortheo, of a single
//   point geo-spiral and ortheo;
// - field along the stresses, if there are any, and along the directions below;
// - geo-contour, geo-fiso and hybrid inside all rims; geo-spiral around the place nearest to the centroid and around
//   the vertex farthest from the rims;
// - fina along, and ortheo from, lines along and across the tension through both places;
// - for directions in the mean plane of the patch, every 22.5 degrees from its mean tension (or its long axis), and its
//   principal axes: rows of that direction by fexa through the centroid, and by fina through it and a fifth of the
//   patch from either end; ortheo from a perpendicular plane through the centroid and a twentieth from either end;
// - fina and ortheo from sides of the rims between corners (rim_sides.hpp), or from whole rims without corners: the six
//   longest.
std::vector<Candidate> candidates(const Sheet& sheet, const std::vector<Vec3>& pull);

// How much of the tension would run along such a path, estimated from the directions of a distance field on `sheet`:
// as metrics::surface::pull_adequacy, by area. NaN without load cases.
// Throws Error as sources() does.
double estimate(const Sheet& sheet, const std::vector<Vec3>& pull, const Candidate& candidate);

} // namespace filum::choose
