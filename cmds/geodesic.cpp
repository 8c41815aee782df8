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
    "Reads a triangle mesh, open or closed, from a file or standard input, and makes it a surface: every edge has "
    "one or two triangles, every vertex has one fan of them, and all face one way. Notes report the repairs: copies "
    "of triangles, triangles without area or against their neighbours, edges of more than two triangles (the "
    "flattest pair stays joined, the others are cut off), and parts that touch in a point. Several components stay "
    "as they are. The input can also be a Surface stream, with its fields.\n\n"
    "Then --cut cuts the surface by a plane, --cut-mesh by a closed mesh, and --remesh makes new triangles. Fields "
    "and CAD faces are kept. With --remesh auto triangles are as large as bends and --longest allow, and never "
    "smaller than the given ones where these bend. The fact remesh-off is the distance between both surfaces; a note "
    "appears if it exceeds --tolerance.\n\n"
    "With --source it computes the distance of every vertex from the nearest source along the surface. It is "
    "infinite on components without a source. Sources are given in quotes with blanks between. vertex:ID is a "
    "vertex, numbered as in the file from 0 (in an STL as corners first appear); after a cut or --remesh as in 'peek "
    "--text'. point:X,Y,Z is the nearest point of the surface. boundary is all rims, boundary:outer the one of each "
    "component that spans most, and boundary:N a single one. plane:NX,NY,NZ,D is the line where the plane NX x + NY "
    "y + NZ z = D cuts the surface.\n\n"
    "--source-lines names a text of points, drawn onto the surface: three numbers a line, with an empty line between "
    "two lines of points. --source-mesh names a mesh, open or closed. Sources are the lines where the surface "
    "crosses it, and rims that run along it, within a twentieth of a mean edge, as where two patches share a border. "
    "With --signed, distances are negative on the back of planes and meshes, and to the right of lines, seen from "
    "the side that the surface faces.\n\n"
    "By default distances are exact: the length of the shortest path on the triangles to the nearest point of the "
    "sources, found by propagating windows. Lines are sources themselves, not their vertices. Isolines cross edges "
    "exactly where the distance has their level, and bend between them to 0.001 mm.\n\n"
    "--method heat lets heat flow instead; auto does so on more than 300,000 triangles, if exact distances would "
    "take longer. It is off by some percent beyond 16 mean edges from the sources, and more where triangles differ "
    "much in size. Facts compare it with exact distances as far as a second of work reaches. Its isolines are "
    "straight in every triangle. --paper follows Kipping et al. 2022, with the vertices nearest to lines as sources, "
    "for comparison only.\n\n"
    "Facts in the stream give the number of vertices reached, the farthest distance, and how far the slope of the "
    "distances, linear in every triangle, differs from 1. It differs where fronts meet, near points and on coarse "
    "meshes.";

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
            {{"source", &o.source, "SOURCES", "places with distance 0; none: only make the surface"},
             Option{"source-lines", &o.lines, "FILE", "lines of points that are sources as well; see above"}
                 .not_a_setting(),
             Option{"source-mesh", &o.mesh, "FILE",
                    "a mesh in the input's coordinates; the lines where it meets the surface are sources"}
                 .not_a_setting(),
             Option{"signed", &o.measure.with_sides, "", "distances are negative on one side of the sources; see above"}
                 .when(kMeasured),
             Option{"method", &o.measure.method, "", "method for distances"}
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
             Option{"first", &o.measure.first, "MM", "distance of the first of these; 0: one spacing"}
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
