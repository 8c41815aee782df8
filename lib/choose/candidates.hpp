// What paths a patch could have.
#pragma once

#include "choose/seed.hpp"
#include "surfpath/algorithm.hpp"

#include <vector>

namespace filum::choose {

struct Candidate {
    surfpath::Algorithm algorithm;
    Seed seed;
};

// In this order, which decides ties:
// - what the patch came with: its algorithm with its sources; of sources only fina, fexa and ortheo, of a single point
//   geo-spiral and ortheo;
// - field along the stresses, if there are any; along the directions below;
// - geo-contour, geo-fiso and hybrid within all rims; geo-spiral about the centroid (the nearest place to it) and the
// vertex
//   farthest from the rims;
// - fina along, and ortheo from a line across the pull, through both places;
// - for directions in the mean plane of the patch, every 22.5 degrees from its mean pull (or its long axis), and its
//   principal axes: rows that run so, fexa through the centroid and fina through it and a fifth of the patch from
//   either end; ortheo from a plane across, through the centroid and a twentieth from either end;
// - fina and ortheo from sides of the rims, between corners (rim_sides.hpp), or
//   whole if there are none: the six longest.
std::vector<Candidate> candidates(const Sheet& sheet, const std::vector<Vec3>& pull);

// How much of the pull would run along such a path, by the directions of a distance field on `sheet`: as
// metrics::surface::pull_adequacy, by area.  nan without load cases.  Throws Error as sources() does.
double estimate(const Sheet& sheet, const std::vector<Vec3>& pull, const Candidate& candidate);

} // namespace filum::choose
