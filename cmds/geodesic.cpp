// geodesic - distances on a surface, and lines of equal distance
// reads:  a mesh file (STL, OBJ, PLY, OFF, 3MF or STEP), or Surface
// writes: Surface
// memory: the model, and some hundred bytes per edge for exact distances
#include "app/geodesic/geodesic.hpp"
#include "cli/head_options.hpp"
#include "cli/step_options.hpp"

namespace {

using namespace filum;
using cli::Option;

constexpr const char* kDescription =
    "Reads a triangle mesh, open or closed, from a file or standard input, and makes it a surface: every edge with "
    "one or two triangles, every vertex with one fan of them, all facing one way. What had to be repaired for that "
    "is noted: triangles that stand twice or have no area, that face against their neighbours, edges of more than "
    "two triangles (the flattest pair stays joined, the others are cut off), parts that touch in a point. Several "
    "components stay as they are. A Surface stream is taken as well, with the fields it has. Then the surface is cut "
    "by a plane with --cut and by a closed mesh with --cut-mesh, and remeshed with --remesh, if asked; fields and CAD "
    "faces go along. With --remesh auto triangles are as large as bends and --longest allow, never smaller than those "
    "given where these bend; the fact remesh-off tells how far the two surfaces are apart, and a note if that is "
    "more than --tolerance.\n\n"
    "With --source it computes the distance of every vertex from the nearest source along the surface, infinite "
    "where no source is on the same component. Sources, several in quotes with blanks between: vertex:ID, numbered "
    "as in the file from 0 (in an STL as corners first appear), after a cut or --remesh as in 'peek --text'; "
    "point:X,Y,Z, the nearest point of the surface; "
    "boundary, boundary:outer or boundary:N, all rims, the one of each component that spans most, or one; "
    "plane:NX,NY,NZ,D, where the plane NX x + NY y + NZ z = D cuts the surface. --source-lines names a text of "
    "points, three numbers a line, lines of points apart by an empty line, drawn onto the surface. --source-mesh names "
    "a mesh, open or closed: sources are the lines where the surface crosses it, and rims that run along it, within a "
    "twentieth of a mean edge, as where two patches share a border. With --signed, distances are negative on the "
    "other side of planes and meshes than they face, or to the right of lines seen from the side that the surface "
    "faces.\n\n"
    "By default distances are exact: the length of the shortest path on the triangles to the nearest point of the "
    "sources, found by propagating windows; lines are sources as such, not their vertices. Isolines cross edges "
    "where the distance has their level, solved from the windows, and bend between them to 0.001 mm. --method heat "
    "lets heat flow instead (auto: on more than 300,000 triangles, if exact distances would take longer): off by some "
    "percent beyond 16 mean edges from "
    "the sources, and more where triangles differ much in size (facts tell how much, beside exact distances as far as "
    "a "
    "second of work reaches), with isolines that are straight in every triangle. --paper does it as Kipping et al. "
    "2022, with "
    "the vertices nearest to lines as sources, for comparison only.\n\n"
    "Facts in the stream tell how many vertices were reached, the farthest, and how far the slope of the distances, "
    "taken as linear in every triangle, is from 1: it is where fronts meet, near points and on coarse meshes.";

constexpr const char* kMeasured = "source/source-lines/source-mesh";

cli::Spec spec(app::geodesic::Options& o) {
    return {
        .name = "geodesic",
        .synopsis = "measure distances on a surface",
        .description = kDescription,
        .in = cli::file("mesh file or Surface"),
        .out = cli::writes(stream::Payload::surface),
        .memory = "the model, and some hundred bytes per edge for exact distances",
        .options = cli::with(
            {{"source", &o.source, "SOURCES", "where distance is 0; none: only make the surface"},
             Option{"source-lines", &o.lines, "FILE", "lines of points where distance is 0 as well; see above"}
                 .not_a_setting(),
             Option{"source-mesh", &o.mesh, "FILE", "a mesh, placed as the input's: where it meets the surface"}
                 .not_a_setting(),
             Option{"signed", &o.measure.with_sides, "", "distances are negative on one side of the sources; see above"}
                 .when(kMeasured),
             Option{"method", &o.measure.method, "", "how distances are found"}
                 .one_of({"auto", "exact", "heat"})
                 .when(kMeasured),
             Option{"paper", &o.measure.paper, "", "heat as in Kipping et al. 2022: snapped sources, no corrections"}
                 .when("method=heat"),
             Option{"levels", &o.measure.levels, "MM,...", "isolines at these distances"}.above(0).at_most(1e7).when(
                 kMeasured),
             Option{"spacing", &o.measure.spacing, "MM", "isolines at every multiple of this; 0: none"}
                 .zero_or_at_least(0.001)
                 .at_most(1e7)
                 .when(kMeasured),
             Option{"first", &o.measure.first, "MM", "where the first of these is; 0: one spacing away"}
                 .within(0, 1e7)
                 .when("spacing"),
             Option{"unit", &o.place.unit, "",
                    "unit of the file; auto guesses from the size, 3MF and STEP state their own"}
                 .one_of({"mm", "cm", "m", "in", "um", "auto"}),
             Option{"scale", &o.place.scale, "S|X,Y,Z", "factor on the size, one or one per axis; negative ones mirror"}
                 .within(-1e6, 1e6)},
            cli::with(cli::step_options(o.step), app::geodesic::options(o.shape))),
        .groups = {{"distances", {"source", "source-lines", "source-mesh", "signed", "method", "paper"}},
                   {"isolines", {"levels", "spacing", "first"}},
                   {"the file", {"unit", "scale", "deflection", "deflection-angle"}},
                   {"the surface", {"flip", "cut", "cut-mesh", "keep", "remesh", "longest", "tolerance"}}},
        .examples = {{"geodesic part.stl --source vertex:0 > part.surface", "distances from a corner of a part"},
                     {"geodesic part.stl --source 'plane:1,0,0,4.5' --spacing 1 | peek",
                      "lines at 1, 2, 3 ... mm from where a plane cuts a part"},
                     {"geodesic part.stl | peek", "what had to be repaired to make a surface of it"}},
        .see_also = {"slice", "peek"}};
}

} // namespace

int main(int argc, char** argv) { return cli::main<app::geodesic::Options>(argc, argv, spec, app::geodesic::run); }
