// `surfpath`: plans the strokes of a path on a surface (docs/algorithms/surfaces.md).
#pragma once

#include "surface/sheet.hpp"
#include "surfpath/algorithm.hpp"
#include "surfpath/field/directions.hpp"
#include "surfpath/plan/plan.hpp"

#include <optional>

namespace filum::surfpath {

using geom::Vec2;
using geom::Vec3;
using plan::Plan;
using plan::Section;
using plan::Stroke;
using surface::Surface;
using surface::curve::Line;
using surface::curve::Place;

// Turns between rows: none (lines of ortheo and field end at rims), hairpins to the next row, or wide turns. usual:
// none for ortheo, those that cost less for field, otherwise wide.
enum class RowTurns : std::uint8_t { usual, none, hairpin, wide };

// What lines of field keep where they cannot keep both. usual: the angle if only an angle is followed, otherwise the
// spacing.
enum class Priority : std::uint8_t { usual, spacing, angle };

struct Options {
    Algorithm algorithm = Algorithm::geo_fiso;
    double spacing = 1;        // mm between neighbouring lines
    double least_radius = 2.4; // mm: radius of turns where there is room
    RowTurns turns = RowTurns::usual;
    double min_length = 0; // mm: shorter strokes, and shorter lines of ortheo, are left out
    double offset = 0;     // mm: distance of the path from the surface along its normals
    // What field follows. If nothing is set: the sheet's field of directions, else its stress, else the angle.
    field::DirectionMix follow{};
    Priority keep = Priority::usual;
    bool whole_rings = false; // the lines of hybrid are the rings themselves (field/rings.hpp)
    double shift = 0;         // spacings, 0 to 1: displacement of the lines of field across their direction
    bool backwards = false;   // takes the lines of field in reverse order, which moves the turns to other places
    bool coarsen = true;      // plans lines of field on larger triangles, if those given are much finer than they need
    std::vector<Vec3> births_apart{}; // places where no line of field should begin, if another place is almost as good
    // mm of fibre that a cut costs; field and hybrid run no farther along other lines to avoid one
    double cut_length = 50;
    bool strict = false;       // fail if more than max_tight of the length turns tighter than least_radius
    double max_tight = 0.01;   // a share
    double width_change = 0;   // share by which beads may be wider or narrower than the spacing (plan/widths.hpp)
    long rim_beads = 0;        // closed lines of field along every rim; rows turn inside of them
    double rim_bead_width = 1; // spacings, of each of them
    double turn_outside = 0;   // mm outside the rims in which rows may turn (outside.hpp); 0: none
    // On a sheet with a flange (outside.hpp), per triangle: it lies so far outside the part that lines on it cover
    // nothing of it. Rows on such triangles only are left out, and turns lie as far outside as possible. Empty: no
    // flange.
    std::vector<char> beyond{};
    std::uint32_t part = surface::kNone;   // number of triangles to be covered; they come first
    std::optional<surface::Plane> plane{}; // cutting plane of fexa for all components; none: the plane of the sources
};

// Plans strokes on the surface of `sheet`, from its sources or its field "distance". Every component is planned by
// itself (components.hpp). Rings on components without rim and source start at a slit (slits.hpp), with
// a note.
// Throws Error(usage) for options that cannot be followed, and Error(bad_input) if the sheet lacks what the algorithm
// needs, as "needs a seed curve; run geodesic --source plane:NX,NY,NZ,D first".
Plan plan_paths(const surface::Sheet& sheet, const Options& options);

// Leaves out strokes shorter than `least` mm, with NoteCode::line_too_short.
void leave_out_short(Plan& plan, double least);

// Finishes a plan from any planner. Leaves out strokes shorter than the least length, with a note. Measures and marks
// turns tighter than the least radius (plan/declare.hpp): facts "tight-turns", "tight-length", "kink-length" and
// "least-radius", note NoteCode::bend_too_tight. Reports voids and overlap (plan/coverage.hpp). Throws Error(failure)
// with the place if more than the allowed share is too tight and the options are strict.
void finish(const Surface& surface, Plan& plan, const Options& options);

} // namespace filum::surfpath
