// collide - checks that the head meets nothing
// reads:  Toolpath
// writes: Toolpath
// memory: the toolpath at 350 bytes per move, meshes at 150 per triangle
#include "app/collide/collide.hpp"
#include "cli/head_options.hpp"

namespace {

using namespace filum;

constexpr const char* kDescription =
    "Moves the head along the whole toolpath, including travels, and measures how near it comes to obstacles: "
    "earlier beads, the meshes of --part (a printed core, a mould) and --fixture, and the bed at z = 0 with --bed. "
    "If it touches nothing, the toolpath passes unchanged, with the number of moves and the least clearances as "
    "facts. So collide can stand before postproc. Otherwise it ends with 1 and gives the place; with --strict=false "
    "it passes the toolpath with a note. --places lists all collisions.\n\n"
    "The head is a nozzle (flat, cone), a carriage box and a gantry, from the options or the profile of --machine. "
    "Upwards it has no end. The tool follows the normals of the toolpath, and is upright without them. The rotation "
    "of a carriage about the tool is known on three axes only; otherwise the round column about it is used. A travel "
    "without normals first rises above everything printed, as postproc makes it.\n\n"
    "Only obstacles that rise above the plane through the tip across the tool's axis, by more than --press, count. "
    "Clearances are distances to them. The nozzle may sink by as much into beads, which are soft, and into nothing "
    "else. --margin asks for more distance. The bead of the last stretch of path, as long as it is wide plus the "
    "flat's diameter, does not count, because the nozzle has just shaped it. Beads have the width and height of the "
    "toolpath, below their points, with ends rounded by half their height. Meshes stay in their place, in mm.\n\n"
    "Moves are halved until nothing can be nearer than the least clearance, or until no relevant point of the head "
    "moves by more than --step between two checks. So the true clearance is at most half of --step below the "
    "reported one.\n\n"
    "--program checks finished machine code instead, from its lines alone: G0 and G1, X Y Z and the rotary words of "
    "the profile, with the numbers of the tip or of the axes. Other lines are counted. It writes the figures instead "
    "of a toolpath. Width and height of beads come from the comments WIDTH: and HEIGHT: of the program, or from "
    "--bead. Beads lie where the extruder advances, or between the codes of a valve or a fibre. The part keeps the "
    "place that it has in the program: use postproc --place as-is, or give its distance from the meshes by --shift. "
    "Places are right to 0.002 mm.";

cli::Spec spec(app::collide::Options& o) {
    using cli::Option;
    return {
        .name = "collide",
        .synopsis = "check that the head meets nothing",
        .description = kDescription,
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
