// Stresses onto a surface, as fields of its vertices.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "stressfield/samples.hpp"
#include "surface/sheet.hpp"

#include <span>

namespace filum::stressfield {

struct Options {
    double reach = 0;     // mm, see stencil.hpp; 0: by the spacing of the samples
    double mask = 0;      // share of the greatest |s1| on the surface below which there is no direction
    bool tangent = false; // directions in the tangent plane
};

// Adds the fields stress.CASE.s1, .s2, .s3 (MPa) and stress.CASE.d1 of every case to `sheet`: the principal stresses,
// and the unit vector of the greatest, signed as signed_direction says.  All are infinite where no sample is near; s2
// and s3 where they are not given; d1 where s1 is no direction of its own or below the mask.  With `tangent`, d1 is the
// direction of the greatest stress within the plane across the vertex's normal, and the values stay those in space.
// Noted, by area: vertices without stress, and where (above the mask, without `tangent`) d1 leans out of the tangent
// plane by more than 45 degrees: there it says nothing about the surface's own directions.
// Throws Error(bad_input) if no vertex has a stress, Error(usage) if a case's fields are there already.
void add(surface::Sheet& sheet, const Samples& samples, const Options& options, int threads, Notes& notes,
         Facts& facts);

// The same for every sheet of several, as the patches of a part; facts are named "PATCH.FACT" then, by the sheets'
// names or their numbers from 1, and notes and errors name the patch.  Throws Error(bad_input) if there is no sheet.
void add(std::span<surface::Sheet> sheets, const Samples& samples, const Options& options, int threads, Notes& notes,
         Facts& facts);

} // namespace filum::stressfield
