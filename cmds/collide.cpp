// collide - checks that the head meets nothing
// reads:  Toolpath
// writes: Toolpath
// memory: the toolpath at 350 bytes per move, meshes at 150 per triangle
#include "app/collide/collide.hpp"
#include "cli/head_options.hpp"

namespace {

using namespace filum;

cli::Spec spec(app::collide::Options& o) {
    using cli::Option;
    return {
        .name = "collide",
        .synopsis = "check that the head meets nothing",
        .description = cli::kDescription,
        .in = cli::reads(stream::Payload::toolpath),
        .out = cli::writes(stream::Payload::toolpath),
        .memory = "the toolpath at 350 bytes per move, meshes at 150 per triangle",
        .options = cli::with(
            app::collide::options(o),
            {Option{"program", &o.program, "FILE", "check this machine code instead of a toolpath"}.not_a_setting(),
             Option{"bead", &o.bead, "MM,MM", "width and height of the program's beads"}
                 .above(0)
                 .at_most(100)
                 .numbers(2)
                 .not_a_setting()
                 .when("program"),
             Option{"shift", &o.shift, "MM,MM,MM", "shift from the program's coordinates to those of the meshes"}
                 .numbers(3)
                 .within(-1e7, 1e7)
                 .not_a_setting()
                 .when("program"),
             Option{"format", &o.format, "", "how to write the program's figures"}
                 .one_of({"table", "tsv", "json"})
                 .not_a_setting()
                 .when("program")}),
        .groups = {{"machine code", {"program", "bead", "shift", "format"}}, app::collide::group(), cli::head_group()},
        .examples = {{"slice part.stl | regions | sequence | fill | link3d | collide --bed | postproc > part.gcode",
                      "a program only if the head meets nothing"},
                     {"slice part.stl | regions | sequence | fill | link3d | postproc > part.gcode; collide --program "
                      "part.gcode --machine marlin",
                      "how near the head comes in a finished program"}},
        .see_also = {"sequence", "link3d", "surfpath", "postproc"}};
}

} // namespace

int main(int argc, char** argv) { return cli::main<app::collide::Options>(argc, argv, spec, app::collide::run); }
