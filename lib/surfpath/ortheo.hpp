// Lines that stand upright on a seed curve and run straight over the surface: seeded ortho-isogeodesics.
#pragma once

#include "surface/sheet.hpp"
#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

// Lines along the slope of the exact distance from the sheet's sources, which are straightest lines upright on them
// (Kipping, Kallai, Schueppstuhl 2022, 3.1.3, who march from each isoline to the closest point of the next): as far
// apart as `spacing` by births and deaths of single lines or pairs, to which their neighbours give way (strands.hpp).
// Fans about the ends of a source curve, point sources and the lee of holes come by the same law.
//
// Turns "none": each line is a stroke of its own, laid alternately there and back.  "hairpin", "wide": lines are led
// into each other as the rows of fina are, by declared hairpins or by turns of the least radius where there is room;
// from ends within the surface along other lines.
// Facts: rows, births, deaths, births-lower-bound, cuts.  Notes: lines that are too short, with their lengths.
// Throws Error(bad_input) if the sheet has no sources, Error(usage) as Fronts does.
Plan ortheo(const surface::Sheet& sheet, const Options& options);

} // namespace filum::surfpath
