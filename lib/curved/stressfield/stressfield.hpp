// Transfers stresses to a surface, as fields of its vertices.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "stressfield/samples.hpp"
#include "surface/sheet.hpp"

#include <span>

namespace filum::stressfield {

struct Options {
    double reach = 0;     // mm, see stencil.hpp; 0: from the spacing of the samples
    double mask = 0;      // fraction of the greatest |s1| on the surface below which there is no direction
    bool tangent = false; // directions in the tangent plane
};

// Adds the fields stress.CASE.s1, .s2, .s3 (MPa) and stress.CASE.d1 of every case to `sheet`: the principal stresses,
// and the unit vector of the greatest, with the sign of signed_direction(). All are infinite where no sample is near;
// s2 and s3 where they are unknown; d1 where s1 has no unique direction or is below the mask. With `tangent`, d1 is
// the direction of the greatest stress in the plane perpendicular to the vertex's normal, and the values remain those
// in space. Notes, by area: vertices without stress, and those where (above the mask, without `tangent`) the angle
// between d1 and the tangent plane exceeds 45 degrees, so that d1 is irrelevant for directions in the surface.
// Throws Error(bad_input) if no vertex has a stress, Error(usage) if the fields of a case already exist.
void add(surface::Sheet& sheet, const Samples& samples, const Options& options, int threads, Notes& notes,
         Facts& facts);

// The same for several sheets, as the patches of a part. Facts are named "patch.PATCH.FACT" then, by the names of the
// sheets or their numbers from 1, and notes and errors name the patch. Throws Error(bad_input) without sheets.
void add(std::span<surface::Sheet> sheets, const Samples& samples, const Options& options, int threads, Notes& notes,
         Facts& facts);

} // namespace filum::stressfield
