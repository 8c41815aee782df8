// postproc - a toolpath to machine code
// reads:  Toolpath
// writes: text
// memory: some spans and half a million moves; what else arrives is kept, beyond 48 MiB in a temporary file
#include "app/postproc/postproc.hpp"
#include "cli/deviation_options.hpp"
#include "cli/head_options.hpp"

namespace {

using namespace filum;

constexpr const char* kDescription =
    "Writes the program that a machine runs: every bead as moves with their own material, every break as a travel "
    "with the profile's retraction and lift. Within a stroke every move deposits material, and nothing is retracted. "
    "Material is exact: rounding errors go into the next move. A stretch within --path-tolerance of one move, "
    "straight or (with format.arcs) an arc, becomes that move; the section of a bead stays within 5 %.\n\n"
    "The output's ending chooses its form. part.bgcode is binary G-code, with tables of settings and the pictures of "
    "--thumbnails. part.gcode.3mf is a print file of Bambu Studio: the program with its MD5 sum, pictures of the "
    "plate, time, weight, and the places of the parts. Anything else is text.\n\n"
    "The toolpath is read to its end first. The head of the program needs the time and the material, the part is "
    "centred on the bed, and limits are checked. So a toolpath that is cut short or breaks a limit gives no program "
    "at all. A program cut short later (a full disk, a killed process) lacks its last line, 'end of program'.\n\n"
    "A machine is a TOML file: NAME.toml in the folders of $FILUM_PROFILES or in share/filum/profiles, or any file "
    "given by its path. Copy the nearest one and edit it; its comments explain each key. Known are marlin, klipper, "
    "reprapfirmware, linuxcnc (filament), cellink-inkredible and bio-x (valves), syringe. A bead above "
    "limits.section or a place off the bed is an error. Feeds are lowered to keep limits.flow and "
    "motion.max_speed_z.\n\n"
    "A profile with a section [kinematics] has rotary axes (linuxcnc-xyzac, linuxcnc-xyzbc, linuxcnc-head-table, "
    "linuxcnc-head-head, polar-xzbc, open5x-duet, klipper-xyzac). The tool follows the toolpath's normals. The "
    "numbers are the tip in the part's frame, or the positions of the axes, cut so fine that the tip keeps to its "
    "line; the program's head says which. The axes travel as little as possible over a stroke that keeps their "
    "limits. Where none can continue, the stroke is broken and the axes unwind in the air. A note and the fact "
    "'unwinds' report it. Near upright the tool may lean a little. kuka-krl, abb-rapid and ur write tool frames. A "
    "place that the axes cannot reach is an error.\n\n"
    "A profile with a section [fibre] (fibre-marlin, fibre-xyzac) uses continuous fibre for one of the tools of "
    "'assemble --tools'. A stroke is anchored slowly, then pulled or fed. It is cut as far before its end as the "
    "cutter is from the nozzle. A stroke too short for that is an error with its place, or left out (--short).\n\n"
    "Templates in the profile contain the codes of the start, the end, and each layer. {names} in them stand for "
    "numbers: every name of the profile's [values], and those that marlin.toml lists, such as {x_min} or {layer}.";

cli::Spec spec(postproc::Options& o) {
    return {
        .name = "postproc",
        .synopsis = "a toolpath to machine code",
        .description = kDescription,
        .in = cli::reads(stream::Payload::toolpath),
        .out = cli::text("machine code"),
        .memory = "some spans and half a million moves; what else arrives is kept, beyond 48 MiB in a temporary file "
                  "in $TMPDIR",
        .options = cli::with(
            {cli::Option{"machine", &o.machine, "NAME|FILE", "machine profile"}.not_a_setting(),
             cli::Option{"place", &o.place, "", "place of the part: the center of the bed, or as-is"}.one_of(
                 {"center", "as-is"}),
             {"orient", &o.orient, "",
              "rotation of the part on a machine with rotary axes: as-is; RX,RY,RZ: degrees about x, then y, then z; "
              "up:X,Y,Z: this direction points up; auto: the largest tilt becomes as small as possible"},
             {"set", &o.set, "KEY=VALUE,...",
              "changes keys of the profile, such as feeds.bead=40; without a section those of [values], such as "
              "nozzle_temp=230"},
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
              "give sequence the same"},
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
            cli::deviation_options(o)),
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
