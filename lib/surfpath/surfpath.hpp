// The whole job of `surfpath`: an algorithm, a surface, a plan of strokes (docs/algorithms/surfaces.md).
#pragma once

#include "surface/sheet.hpp"
#include "surfpath/algorithm.hpp"
#include "surfpath/field/directions.hpp"
#include "surfpath/plan/plan.hpp"

#include <optional>

namespace filum::surfpath {

using geom::Vec2;
using geom::Vec3;
using plan::Piece;
using plan::Plan;
using plan::Stroke;
using surface::Surface;
using surface::curve::Line;
using surface::curve::Place;

enum class Method : std::uint8_t { filum, kipping2022 }; // ours, or as the paper says
// Of ortheo and field: lines end at the rim, or go on; usual: of ortheo they end, of field they go on by wide turns.
enum class RowTurns : std::uint8_t { usual, none, hairpin, wide };

// What lines of field keep to where both cannot be had; usual: the angle, if that is all they were asked to follow.
enum class Keep : std::uint8_t { usual, spacing, angle };

struct Options {
    Algorithm algorithm = Algorithm::geo_fiso;
    Method method = Method::filum;
    double spacing = 1;        // mm, d: between neighbouring lines
    double least_radius = 2.4; // mm: of turns, where there is room
    RowTurns turns = RowTurns::usual;
    double min_length = 0; // mm: of the lines of ortheo; shorter ones are left out
    double offset = 0;     // mm: along the normals, at which the path will be laid
    field::Sources
        follow{}; // what field follows; nothing: directions that the sheet carries, else its stress, else the angle
    Keep keep = Keep::usual;
    double shift = 0;       // of a spacing, 0 to 1: how far the lines of field lie beside where they would else
    bool backwards = false; // lines of field are taken in the reverse order, so that turns lie elsewhere
    std::vector<Vec3> births_apart{}; // where no lines of field shall be born, if elsewhere is nearly as good
    double cut_length = 50;  // mm: of fibre that a cut costs; no way of field or hybrid along what is laid is longer
    bool strict = false;     // no turn may be tighter than least_radius
    double turn_outside = 0; // mm: how far beyond the rims rows may turn (outside.hpp); 0: not
    // Of a sheet with a flange (outside.hpp), per triangle: it lies so far beyond the part that lines there cover
    // nothing of it; rows that lie on such triangles only are left out, and turns lie as far out as they can.  Empty:
    // no flange.
    std::vector<char> beyond{};
    std::uint32_t part = surface::kNone;   // triangles, the first ones, that are to be covered
    std::optional<surface::Plane> plane{}; // of fexa, for all components of a sheet; none: that of the sources
};

// Strokes on the surface of `sheet`, along the field "distance" or from its sources.  Every component is planned by
// itself (components.hpp).  Rings on those that have neither a rim nor a source begin at a seam (opened.hpp), told in a
// note.
// Throws Error(usage) for options that cannot be followed, Error(bad_input) if the sheet lacks what the algorithm
// needs: "needs a seed curve; run geodesic --source plane:NX,NY,NZ,D first".
Plan plan_paths(const surface::Sheet& sheet, const Options& options);

// What is to be said of a plan, whoever made it: declares what turns within less than the least radius
// (plan/declare.hpp), in facts "hairpins", "hairpin-length" and "least-radius" and the note "turn tighter than the
// least radius", and tells what is bare and what is laid twice (plan/bare.hpp). Throws Error(failure) with the place if
// a turn is too tight and the options are strict.
void finish(const Surface& surface, Plan& plan, const Options& options);

} // namespace filum::surfpath
