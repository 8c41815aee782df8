// route - leads the head past what it would meet
// reads:  Toolpath
// writes: Toolpath
// memory: the toolpath at 1000 bytes per move, meshes at 150 per triangle
#include "app/route/route.hpp"
#include "cli/head_options.hpp"

namespace {

using namespace filum;

cli::Spec spec(app::route::Options& o) {
    using cli::Option;
    return {.name = "route",
            .synopsis = "lead the head past what it would meet",
            .description = cli::kDescription,
            .in = cli::reads(stream::Payload::toolpath),
            .out = cli::writes(stream::Payload::toolpath),
            .memory = "the toolpath at 1000 bytes per move, meshes at 150 per triangle",
            .options = cli::with(
                {Option{"lift", &o.lift, "MM", "how high the tool travels at least; default: the profile's, else 0.6"}
                     .within(0, 1000)
                     .numbers(1)
                     .a_limit(),
                 Option{"bath", &o.bath, "MM",
                        "in a bath of gel: distance of travels from beads on all sides; in and out beside the part"}
                     .within(0, 100)
                     .when("!head=none")
                     .a_limit(),
                 Option{"tilt", &o.tilt, "DEG", "largest angle by which the tool may lean off its normals"}
                     .within(0, 80)
                     .a_limit(),
                 Option{"tilt-rate", &o.tilt_rate, "DEG/MM", "largest change of this angle along the path"}
                     .within(0.1, 90)
                     .when("tilt")
                     .a_limit(),
                 Option{"leaning", &o.leaning, "FILE", "list of strokes whose tool leans, as TSV"}.not_a_setting().when(
                     "tilt")},
                app::collide::options(o)),
            .groups = {{"where the head is in the way", {"tilt", "tilt-rate", "leaning", "lift", "bath"}},
                       app::collide::group(),
                       cli::head_group()},
            .examples = {{"slice part.stl | regions | sequence | fill | link3d | route --bed | postproc > part.gcode",
                          "travels that go no higher than they have to"}},
            .see_also = {"assemble", "collide", "postproc"}};
}

} // namespace

int main(int argc, char** argv) { return cli::main<app::route::Options>(argc, argv, spec, app::route::run); }
