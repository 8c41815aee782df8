// Rows beside a plane: FInA and FExA (section 3.1).
//
// The text is read as follows:
// - "the mesh is split into two halves by the plane P": phi gets the sign of the side, so that the isocontours of the
//   halves are those at i d and at -i d.
// - Order of traversal: rows follow the section of the surface with the plane, from the side where they begin on the
//   first row of a half, and alternate in direction from level to level. Pieces of a level follow each other along that
//   direction; a closed one begins nearest to the current position.
// - "travel motions between the corresponding segments" of a level; from level to level the path continues on a
//   straight line of any length.
// - "upon computing and connecting both sides": the first half from its farthest row to the seed curve, then the other
//   half outwards.
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
