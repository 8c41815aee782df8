// route - leads the head past what it would meet
// reads:  Toolpath
// writes: Toolpath
// memory: the toolpath at 1000 bytes per move, meshes at 150 per triangle
#include "app/route/route.hpp"
#include "cli/head_options.hpp"

namespace {

using namespace filum;

constexpr const char* kDescription =
    "Finds a way for every travel between two strokes on which the head touches nothing: no earlier bead, none of "
    "the meshes of --part and --fixture, and with --bed not the bed at z = 0. These are the obstacles and the head "
    "of `collide`. The tool rises along its own axis by at least --lift, turns only on the way across, and descends "
    "along the axis of the next stroke. Three ways are tried, and the shortest free one is taken: straight across, "
    "as low as possible over the obstacles, or around them. These travels carry normals, and postproc follows them "
    "exactly.\n\n"
    "With --tilt the tool may also lean off its normals by so many degrees, where the head touches something along a "
    "stroke: as little as frees it, and no faster along the path than --tilt-rate. Places and material of the path "
    "stay. --leaning lists the strokes.\n\n"
    "The result is checked as `collide` does, with the least clearances as facts. If the head still touches "
    "something, route ends with 1 and gives the place; with --strict=false it continues with a note. --places lists "
    "all such places.";

cli::Spec spec(app::route::Options& o) {
    using cli::Option;
    return {.name = "route",
            .synopsis = "lead the head past what it would meet",
            .description = kDescription,
            .in = cli::reads(stream::Payload::toolpath),
            .out = cli::writes(stream::Payload::toolpath),
            .memory = "the toolpath at 1000 bytes per move, meshes at 150 per triangle",
            .options = cli::with(
                {Option{"lift", &o.lift, "MM", "how high the tool travels at least; default: the profile's, else 0.6"}
                     .within(0, 1000)
                     .numbers(1)
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
            .groups = {{"where the head is in the way", {"tilt", "tilt-rate", "leaning", "lift"}},
                       app::collide::group(),
                       cli::head_group()},
            .examples = {{"slice part.stl | regions | sequence | fill | link3d | route --bed | postproc > part.gcode",
                          "travels that go no higher than they have to"}},
            .see_also = {"assemble", "collide", "postproc"}};
}

} // namespace

int main(int argc, char** argv) { return cli::main<app::route::Options>(argc, argv, spec, app::route::run); }
