// ingest - the G-code of any slicer to a toolpath
// reads:  G-code
// writes: Toolpath
// memory: the program
#include "app/ingest/ingest.hpp"

namespace {

using namespace filum;

constexpr const char* kDescription =
    "Reads a finished program, of Filum or of any slicer, so that metrics, render and collide can judge it: 'ingest "
    "part.gcode | metrics' tells how many strokes and stops a print has. Programs come as text, as binary G-code "
    "(.bgcode), or as a project with one program a plate (.gcode.3mf).\n\n"
    "It understands the dialects of Marlin, Klipper, RepRapFirmware and LinuxCNC: G0 to G3 (arcs by I J or R), G10, "
    "G11, G20, G21, G28, G52 to G59, G90, G91, G92, M82, M83, M200 D, T, M6, and ACTIVATE_EXTRUDER. Other moves, and "
    "codes that turn or scale what follows (G5, G43.4, G51, G68, M128, axes A B C U V W that the machine lacks), are "
    "an error that names the line. All other commands are counted. The comments of PrusaSlicer, SuperSlicer, "
    "OrcaSlicer, Bambu "
    "Studio and Cura "
    "say where layers begin, what a bead is for, how high it is and how thick the filament. Without them a bead is as "
    "high as its level lies above the one below, and layers are counted by that. A bead's width is its volume by way "
    "and height: the rectangle that Filum's beads are. Neighbouring moves share a width where the decimals of the "
    "program cannot tell them apart; no volume is lost by that.\n\n"
    "What is laid before the first layer, such as a purge line, is left out with a note. Facts tell strokes, stops, "
    "travels and retractions. A stroke ends where the nozzle goes more than 0.5 mm aside or two layers up or down "
    "without extruding, or "
    "takes material back; a stop is a way of more than 0.05 mm without extruding, or material taken back.\n\n"
    "--machine names the profile that the program is for: it tells of extruder words other than E, of valves and "
    "fibre, of tools, and of rotary axes, whose tip and tool axis are worked out. The part is where the program has "
    "it: postproc --place as-is leaves it there.";

cli::Spec spec(app::ingest::Options& o) {
    using cli::Option;
    return {.name = "ingest",
            .synopsis = "the G-code of any slicer to a toolpath",
            .description = kDescription,
            .in = cli::file("G-code, .bgcode, .gcode.3mf"),
            .out = cli::writes(stream::Payload::toolpath),
            .memory = "the program",
            .options =
                {Option{"machine", &o.machine, "NAME|FILE", "machine profile; left out: three axes, E the extruder"}
                     .not_a_setting(),
                 Option{"set", &o.set, "KEY=VALUE,...", "change keys of the profile, as extrusion.diameter=2.85"}.when(
                     "machine"),
                 Option{"filament-diameter", &o.filament, "MM", "0: what the program says, else the profile, else 1.75"}
                     .at_least(0)
                     .at_most(100)
                     .a_limit(),
                 Option{"bead", &o.bead, "MM,MM", "width and height of beads that the program does not tell"}
                     .above(0)
                     .at_most(100)
                     .numbers(2)
                     .a_limit(),
                 Option{"plate", &o.plate, "N", "plate of a .gcode.3mf, counted from 1; 0: the first"}.within(0, 1000),
                 Option{"start-code", &o.start_code, "", "keep what is laid before the first layer, too"}.a_limit(),
                 Option{"arc-tolerance", &o.arc_tolerance, "MM", "how far lines may be from the arcs they stand for"}
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
