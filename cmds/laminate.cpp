// laminate - plies at angles to a direction, one on the other
// reads:  Surface
// writes: Toolpath
// memory: the model and all plies
#include "app/laminate/laminate.hpp"

namespace {

using namespace filum;
using app::laminate::Options;
using cli::Option;

constexpr const char* kDescription =
    "Makes a stack of plies on a surface. Each ply consists of the lines of `surfpath field` at its angle from the "
    "reference direction, counter-clockwise as seen from the side that the surface faces. It lies on the surface "
    "raised by the true distance of the plies below it. So grooves become narrower and corners round; a groove "
    "without room for a ply is a note. The toolpath has a layer per ply, beginning with 0.\n\n"
    "--plies gives the angles from the surface outwards, and --symmetric adds the same in reverse. --table FILE "
    "describes each ply: its first line names columns, out of angle, spacing, height, tool, side (over, or under for "
    "the surface's back) and within, and a line per ply follows. Missing columns are as the options say. A note "
    "reports a stack that is not symmetric about its middle, or has more plies of one angle than of its opposite.\n\n"
    "A ply need not cover everything. The column within says where it lies: 'all'; 'faces:3,4', faces of the CAD "
    "model by number; or a file of closed curves on or near the surface. Such a file has points as for `geodesic "
    "--source-lines`, with the ply to their left as seen from the side that the surface faces. Plies above step down "
    "beside its end over one spacing, or as gently as --ramp 1:20 asks. Then edges of plies that end within each "
    "other are moved apart as far as necessary; a note reports edges that cannot move.\n\n"
    "--turn-outside lets plies continue over the surface's rims and turn there, as surfpath does. Three radii and "
    "half a spacing leave room for turns at any slant. Holes and notches without room for that are covered, to be "
    "cut out, with a note. Where a ply ends within the part, it turns on it.\n\n"
    "Plies of one direction are shifted by shares of a spacing. Their births lie beside each other, so that gaps do "
    "not lie over gaps (--stagger=false: not). Facts give the thickness at points (mean, least, most, the thinnest "
    "and the thickest hundredth) and as means about a bead's width ('even'). For each ply they give cuts, length, "
    "the shares of the area under no bead and under two or three, the gap that ninety-nine hundredths of the area "
    "stay below, and how far the fibres are off the angle, including turns. 'metrics --surface' shows them. --map "
    "writes the surface with all of it at every point, as 'metrics --map' does. 'render --by thickness map.surface' "
    "draws it, and 'render map.surface -o map.vtp' is for ParaView.";

cli::Spec spec(Options& o) {
    return {
        .name = "laminate",
        .synopsis = "plies at angles to a direction, one on the other",
        .description = kDescription,
        .in = cli::reads(stream::Payload::surface),
        .out = cli::writes(stream::Payload::toolpath),
        .memory = "the model and all plies",
        .options =
            {Option{"plies", &o.plies, "DEG,...", "angle of every ply, from the surface outwards"}.when("!table"),
             Option{"table", &o.table, "FILE", "table of the plies, a line each, instead of --plies"}.not_a_setting(),
             Option{"symmetric", &o.symmetric, "", "adds the same plies in reverse order on top"},
             Option{"reference", &o.reference, "X|Y|Z|x,y,z",
                    "direction from which angles count, projected onto the surface"},
             Option{"spacing", &o.like.spacing, "MM", "between neighbouring lines"}.within(0.001, 1000),
             Option{"keep", &o.how.keep, "",
                    "where directions spread, lines keep the spacing or the angle; usual: the angle"}
                 .one_of({"usual", "spacing", "angle"}),
             Option{"layer-height", &o.like.height, "MM", "height of a ply, along the normals"}.within(0.001, 100),
             Option{"tool", &o.tool, "N", "tool of the machine for the plies"}.within(0, 1e6),
             Option{"min-radius", &o.how.least_radius, "MM", "minimum radius of turns, where there is room"}.within(
                 0, 1e5),
             Option{"strict", &o.how.strict, "", "no path, exit 1, if a turn must be tighter than --min-radius"}
                 .a_limit(),
             Option{"stagger", &o.how.stagger, "", "plies of one direction are shifted against each other"}.a_limit(),
             Option{"ramp", &o.ramp, "1:N", "steepest ramp where plies end within the part"},
             Option{"turn-outside", &o.how.turn_outside, "MM",
                    "rows may turn so far beyond the rims, where they are trimmed; 0: they turn on the part"}
                 .zero_or_at_least(0.001)
                 .at_most(1000),
             Option{"trim-list", &o.trim_list, "FILE", "writes where to trim: ply, stroke, mm along it, and the place"}
                 .not_a_setting()
                 .when("turn-outside"),
             Option{"machine", &o.machine, "NAME|FILE",
                    "profile whose limits must allow this, as postproc checks later"}
                 .not_a_setting()
                 .when("turn-outside"),
             Option{"lift", &o.how.lift, "MM", "how high the tool travels"}.within(0, 1e4).a_limit(),
             Option{"map", &o.map, "FILE", "writes the surface with thickness and angles at every point"}
                 .not_a_setting()},
        .groups = {{"the plies",
                    {"plies", "table", "symmetric", "reference", "keep", "layer-height", "stagger", "ramp"}},
                   {"lines", {"spacing", "min-radius", "strict", "turn-outside", "trim-list", "machine"}}},
        .examples =
            {{"geodesic part.stl --cut 0,0,1,0.9 | laminate --plies 0,90 --symmetric --spacing 2 > part.toolpath",
              "four plies on a surface, here a part without its top"}},
        .see_also = {"geodesic", "surfpath", "metrics", "render"}};
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, app::laminate::run); }
