// ingest - the G-code of any slicer to a toolpath
// reads:  G-code
// writes: Toolpath
// memory: the program
#include "app/ingest/ingest.hpp"

namespace {

using namespace filum;

cli::Spec spec(app::ingest::Options& o) {
    using cli::Option;
    return {.name = "ingest",
            .synopsis = "the G-code of any slicer to a toolpath",
            .description = cli::kDescription,
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
