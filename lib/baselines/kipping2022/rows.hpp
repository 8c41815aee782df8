// Rows beside a plane: FInA and FExA (section 3.1).
//
// Readings taken:
//  - "the mesh is split into two halves by the plane P": phi gets the sign of the side, so that the halves' isocontours
//    are those at i d and at -i d.
//  - order of traversal: rows run along the plane's cut through the surface, from the side where they begin on the
//    first row of a half, and are reversed every level.  Pieces of a level follow each other along that direction; a
//    closed one begins nearest to where the path is.
//  - "travel motions between the corresponding segments" of a level; from level to level the path goes on in a straight
//    line, however far.
//  - "upon computing and connecting both sides": the first half from its farthest row to the seed curve, then the other
//    half outwards.
#pragma once

#include "baselines/kipping2022/options.hpp"
#include "surface/sheet.hpp"
#include "surfpath/plan/plan.hpp"

namespace filum::baselines::kipping2022 {

// Rows of equal geodesic distance from the seed curve.
surfpath::plan::Plan fina(const surface::Sheet& sheet, const Options& settled);

// The same with the distance from the plane in space; the sheet needs no field if the options name a plane.
surfpath::plan::Plan fexa(const surface::Sheet& sheet, const Options& settled);

} // namespace filum::baselines::kipping2022
