// postproc - a toolpath to machine code
// reads:  Toolpath
// writes: text
// memory: half a million moves (100 MB), further ones at 4 to 28 bytes, some spans at 32 times the bytes that it reads;
// what else arrives is kept, beyond 48 MiB in a temporary file
#include "app/postproc/postproc.hpp"
#include "cli/deviation_options.hpp"
#include "cli/head_options.hpp"

namespace {

using namespace filum;

std::vector<cli::Option> options(postproc::Options& o) {
    return cli::with(
        {cli::Option{"machine", &o.machine, "NAME|FILE", "machine profile"}.not_a_setting(),
         cli::Option{"place", &o.place, "", "place of the part: the center of the bed, or as-is"}.one_of(
             {"center", "as-is"}),
         {"orient", &o.orient, "",
          "rotation of the part on a machine with rotary axes: as-is; RX,RY,RZ: degrees about x, then y, then z; "
          "up:X,Y,Z: this direction points up; auto: the largest tilt becomes as small as possible"},
         {"set", &o.set, "KEY=VALUE,...",
          "changes keys of the profile, such as feeds.bead=40; without a section those of [values], such as "
          "nozzle_temp=230. A list is [0,300], a text with commas \"a, b\""},
         cli::Option{"diameter", &o.diameter, "MM",
                     "diameter of the filament, or of the syringe's bore; default: the profile's"}
             .numbers(1)
             .within(0.1, 200),
         cli::Option{"nozzle", &o.nozzle, "MM",
                     "diameter of the nozzle's hole; beads of more than four of its squares are refused; default: "
                     "the profile's"}
             .numbers(1)
             .within(0.01, 100)
             .a_limit(),
         cli::Option{"least-layer-time", &o.layer_time, "S",
                     "feeds are lowered so that printing a layer takes at least this long, for material that must "
                     "cool or set; default: the profile's limits.layer_time"}
             .numbers(1)
             .within(0, 1e5)
             .a_limit(),
         cli::Option{"wall-height", &o.wall_height, "MM",
                     "height of walls around the part, such as those of wells, above z = 0: travels, the first "
                     "approach and the end keep 2 mm above; default: the profile's travel.above"}
             .numbers(1)
             .within(0, 1e4)
             .a_limit(),
         cli::Option{"z-offset", &o.z_offset, "MM",
                     "added to every z of the program, to correct the end stop; default: the profile's"}
             .numbers(1)
             .within(-100, 100),
         {"pause-at", &o.pause_at, "LAYER|Zmm,...",
          "wait for the user (templates.pause) before a layer, counted from 0, as 12, or above a height, as 2.4mm; "
          "2.4mm:colour changes the filament there; give sequence the same"},
         {"by-layer", &o.by_layer, "LAYER:NAME=VALUE,...",
          "change [values] from a layer on, as 50:nozzle_temp=205; the codes of the layers run again there"},
         {"thumbnails", &o.thumbnails, "WxH,...",
          "pictures of what is printed at the program's head, as PrusaSlicer's, for printers and hosts that show "
          "them: 220x124,16x16"},
         cli::Option{"job", &o.job, "FILE", "writes the figures of the job, tool by tool, as TSV"}.not_a_setting(),
         cli::Option{"summary", &o.summary, "FILE", "also the four lines at its head on what the program makes"}
             .not_a_setting(),
         cli::Option{"modules", &o.modules, "FOLDER",
                     "for robots: folder for the modules of a program longer than robot.module_moves"}
             .not_a_setting()},
        cli::deviation_options(o));
}

cli::Spec spec(postproc::Options& o) {
    return {.name = "postproc",
            .synopsis = "a toolpath to machine code",
            .description = cli::kDescription,
            .in = cli::reads(stream::Payload::toolpath),
            .out = cli::text("machine code"),
            .memory = "half a million moves (100 MB), further ones at 4 to 28 bytes, some spans at 32 times the bytes "
                      "that it reads; what else arrives is "
                      "kept, beyond 48 MiB in a temporary file "
                      "in $TMPDIR",
            .options = options(o),
            .groups = {{"where the part stands", {"place", "orient", "z-offset", "wall-height"}},
                       {"the machine", {"machine", "set", "nozzle", "diameter", "least-layer-time"}},
                       {"changes on the way", {"pause-at", "by-layer"}},
                       {"accuracy", {"path-tolerance", "axis-tolerance", "flatten"}},
                       {"what else it writes", {"thumbnails", "job", "summary", "modules"}}},
            .examples =
                {{"slice part.stl | regions | sequence | fill | link3d | postproc --machine marlin > part.gcode",
                  "G-code for a filament printer"},
                 {"slice part.stl | regions | sequence | fill | link3d | postproc --set feeds.bead=80 -o part.gcode",
                  "the same, faster"}},
            .see_also = {"link3d", "metrics", "sequence"}};
}

} // namespace

int main(int argc, char** argv) { return cli::main<postproc::Options>(argc, argv, spec, app::postproc::run); }
