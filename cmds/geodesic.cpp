// geodesic - distances on a surface, and lines of equal distance
// reads:  a mesh file (STL, OBJ, PLY, OFF, 3MF, AMF or STEP), or Surface
// writes: Surface
// memory: the model, and some hundred bytes per edge for exact distances
#include "app/geodesic/geodesic.hpp"
#include "cli/head_options.hpp"
#include "cli/step_options.hpp"

namespace {

using namespace filum;
using cli::Option;

constexpr const char* kMeasured = "source/source-lines/source-mesh";

cli::Spec spec(app::geodesic::Options& o) {
    return {
        .name = "geodesic",
        .synopsis = "measure distances on a surface",
        .description = cli::kDescription,
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
