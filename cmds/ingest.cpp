// ingest - the G-code of any slicer to a toolpath
// reads:  G-code
// writes: Toolpath
// memory: the program
#include "app/ingest/ingest.hpp"

namespace {

using namespace filum;

constexpr const char* kDescription =
    "Reads a finished program, of Filum or of any slicer, so that metrics, render and collide can examine it: "
    "'ingest part.gcode | metrics' counts the strokes and stops of a print. Programs can be text, binary G-code "
    "(.bgcode), or a project with one program a plate (.gcode.3mf).\n\n"
    "It understands the dialects of Marlin, Klipper, RepRapFirmware and LinuxCNC. Moves are G0 to G3 (arcs by I J or "
    "R), G10, G11 and G28. Modes are G20, G21, G52 to G59, G90, G91, G92, M82, M83 and M200 D. Tools are T, M6 and "
    "ACTIVATE_EXTRUDER. Other moves, and axes that the machine lacks, are an error that names the line. So are codes "
    "that turn or scale the following lines (G5, G43.4, G51, G68, M128). All other commands are counted.\n\n"
    "The comments of PrusaSlicer, SuperSlicer, OrcaSlicer, Bambu Studio and Cura mark layers, and give the purpose "
    "and height of beads and the thickness of the filament. Without them a bead is as high as its level lies above "
    "the one below, and layers follow from that. The width of a bead follows from its volume, length and height, as "
    "a rectangle. Neighbouring moves share a width if the decimals of the program cannot distinguish them; no volume "
    "is lost by that.\n\n"
    "Material before the first layer, such as a purge line, is left out with a note. Facts count strokes, stops, "
    "travels and retractions. A stroke ends where the nozzle moves more than 0.5 mm aside or two layers up or down "
    "without extruding, or retracts. A stop is a move of more than 0.05 mm without extruding, or a retraction.\n\n"
    "--machine names the profile of the program. It defines extruder words other than E, valves and fibre, tools, "
    "and rotary axes, from which tip and tool axis are computed. The part keeps the place that it has in the "
    "program: postproc --place as-is leaves it there.";

cli::Spec spec(app::ingest::Options& o) {
    using cli::Option;
    return {.name = "ingest",
            .synopsis = "the G-code of any slicer to a toolpath",
            .description = kDescription,
            .in = cli::file("G-code, .bgcode, .gcode.3mf"),
            .out = cli::writes(stream::Payload::toolpath),
            .memory = "the program",
            .options =
                {Option{"machine", &o.machine, "NAME|FILE", "machine profile; default: three axes, E is the extruder"}
                     .not_a_setting(),
                 Option{"set", &o.set, "KEY=VALUE,...", "changes keys of the profile, such as extrusion.diameter=2.85"}
                     .when("machine"),
                 Option{"filament-diameter", &o.filament, "MM",
                        "diameter of the filament; 0: from the program, else the profile, else 1.75"}
                     .at_least(0)
                     .at_most(100)
                     .a_limit(),
                 Option{"bead", &o.bead, "MM,MM", "width and height of beads, if the program does not contain them"}
                     .above(0)
                     .at_most(100)
                     .numbers(2)
                     .a_limit(),
                 Option{"plate", &o.plate, "N", "plate of a .gcode.3mf, counted from 1; 0: the first"}.within(0, 1000),
                 Option{"start-code", &o.start_code, "", "keeps material before the first layer, too"}.a_limit(),
                 Option{"arc-tolerance", &o.arc_tolerance, "MM",
                        "largest distance between lines and the arcs that they replace"}
                     .at_least(0.0001)
                     .at_most(1)
                     .a_limit()},
            .examples = {{"filum print part.stl -o part.gcode; ingest part.gcode | metrics",
                          "strokes, stops, length and volume of a program"},
                         {"filum print part.stl -o part.gcode; ingest part.gcode | render --output part.png",
                          "a picture of it"}},
            .see_also = {"metrics", "render", "collide", "postproc"}};
}

} // namespace

int main(int argc, char** argv) { return cli::main<app::ingest::Options>(argc, argv, spec, app::ingest::run); }
