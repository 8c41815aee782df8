// ORTHEO: straight lines perpendicular to a seed curve (seeded ortho-isogeodesics).
#pragma once

#include "surface/sheet.hpp"
#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

// Lines along the gradient of the exact distance from the sheet's sources, which are straightest lines perpendicular
// to them (Kipping, Kallai, Schueppstuhl 2022, 3.1.3, who march from each isoline to the closest point of the next).
// Births and deaths of single lines or pairs keep them `spacing` apart; neighbours make way for these
// (lines/lines.hpp). Fans around the ends of a source curve, around point sources and behind holes follow from the
// same rule.
// Turns "none": every line is a stroke, in alternating directions. "hairpin" and "wide" connect lines as the rows of
// fina: by hairpins, or by turns of the least radius where there is room. Ends inside the surface are reached
// along other lines.
// Facts: rows, births, deaths, births-lower-bound, cuts. Notes: lines that are too short, with their lengths.
// Throws Error(bad_input) if the sheet has no sources, Error(usage) as Fronts does.
Plan ortheo(const surface::Sheet& sheet, const Options& options);

} // namespace filum::surfpath
