// collide - checks that the head meets nothing
// reads:  Toolpath
// writes: Toolpath
// memory: the toolpath at 350 bytes per move, meshes at 150 per triangle
#include "app/collide/collide.hpp"
#include "cli/head_options.hpp"

namespace {

using namespace filum;

constexpr const char* kDescription =
    "Moves the head along the whole toolpath, travels too, and looks at how near it comes to what stands there: the "
    "beads laid so far, the meshes of --part (a printed core, a mould) and --fixture, the bed at z = 0 with --bed. If "
    "it meets nothing the toolpath goes on unchanged, with the number of moves and the least clearances as facts, so "
    "that collide can stand in a pipeline before postproc. Else it ends with 1 and says where; --strict=false goes on "
    "with a note. --places lists all collisions.\n\n"
    "The head is a nozzle (flat, cone), a carriage box and a gantry, as the options or the profile of --machine say; "
    "upwards it has no end. The tool stands along the normals of the toolpath, upright without. How a carriage is "
    "turned about the tool is known on three axes only; else the round column about it is taken. A travel without "
    "normals rises above all that is printed first, as postproc makes it.\n\n"
    "Only what rises above the plane through the tip across the tool's axis, by more than --press, counts: the rest "
    "lies below the head. Clearances are distances to that. The nozzle may sink into beads by as much, as they are "
    "soft, and not into anything else; --margin asks for more. The bead of the last stretch of the way, as long as it "
    "is wide plus the flat's diameter, does not count: the nozzle has just shaped it. Beads are as wide and high as "
    "the toolpath says, below their points, with ends rounded by half their height. Meshes are taken where they are, "
    "in mm.\n\n"
    "Moves are halved until nothing can be nearer than the least clearance or until no point of the head, as far up as "
    "anything reaches, moves by more than --step from one check to the next: so no clearance is below what is said by "
    "more than half of --step.\n\n"
    "--program checks finished machine code instead, from its lines alone: X Y Z and the rotary words of the profile, "
    "with the numbers of the tip or of the axes as the profile says, G0 and G1; other lines are counted. The figures "
    "are written instead of a toolpath. Beads are as wide and high as the comments WIDTH: and HEIGHT: of the program "
    "or --bead say, and lie where the extruder goes forward, or between the codes of a valve or of a fibre. The part "
    "is where the program has it: use postproc --place as-is, or say with --shift how to get from there to the meshes. "
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
             Option{"shift", &o.shift, "MM,MM,MM", "from places in the program to those of the meshes"}
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
