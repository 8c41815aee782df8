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
    "Lays a stack of plies on a surface: each by the lines of `surfpath field` at its angle from the reference "
    "direction, counter-clockwise as seen from the side that the surface faces; each on the surface raised by what "
    "lies below it. Raised means by the true distance, so that grooves become narrower and corners round; where a "
    "groove has no room for a ply, that is noted. The toolpath has a layer per ply, the first one is 0.\n\n"
    "--plies gives the angles from the surface outwards, --symmetric adds the same in reverse. --table FILE says more "
    "of each ply: its first line names columns, out of angle, spacing, height, tool, side (over, or under for the "
    "surface's back) and within, a line per ply follows; what has no column is as the options say. A stack that is not "
    "symmetric "
    "about its middle, or has more plies of one angle than of its opposite, is noted.\n\n"
    "A ply need not lie everywhere. Column within says where it does: 'all'; 'faces:3,4', faces of the CAD model by "
    "number; or a file of closed curves on or near the surface, points a line as for `geodesic --source-lines`, with "
    "the "
    "ply to their left as seen from the side that the surface faces. Plies above step down beside its end over a "
    "spacing, or as gently as --ramp 1:20 asks: then edges of plies that end within each other are moved apart as far "
    "as that takes, and what cannot be is noted.\n\n"
    "--turn-outside lays plies over the surface's rims, and turns there, as surfpath does; three radii and half a "
    "spacing leave room for turns at any slant. "
    "Holes and notches without room for that are laid over, to be cut out, and noted. Where a ply ends within "
    "the part, it turns on it.\n\n"
    "Plies of one direction lie beside each other by shares of a spacing, and their lines are born beside each other's "
    "births, so that gaps do not lie over gaps (--stagger=false: not). What comes of it is told as facts: thickness at "
    "points (mean, least, most, the hundredth "
    "that is "
    "thinnest and that is thickest) and as means about a bead's width ('even'), and of each ply cuts, length, the "
    "shares of the area that are bare or laid twice or thrice, the gap that ninety-nine hundredths of the area stay "
    "below, and how far the fibres are off the angle, turns included. 'metrics --surface' shows them. --map writes the "
    "surface with all "
    "of it at every point, as 'metrics --map' does: 'render --by thickness map.surface' draws it, 'render map.surface "
    "-o map.vtp' is for ParaView.";

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
             Option{"table", &o.table, "FILE", "the plies, a line each, instead"}.not_a_setting(),
             Option{"symmetric", &o.symmetric, "", "the same plies once more, in reverse, on top"},
             Option{"reference", &o.reference, "X|Y|Z|x,y,z", "of the angles: a direction, laid onto the surface"},
             Option{"spacing", &o.like.spacing, "MM", "between neighbouring lines"}.within(0.001, 1000),
             Option{"keep", &o.how.keep, "",
                    "where directions spread, lines keep to the spacing, or to the angle; usual: the angle"}
                 .one_of({"usual", "spacing", "angle"}),
             Option{"layer-height", &o.like.height, "MM", "of a ply, along the normals"}.within(0.001, 100),
             Option{"tool", &o.tool, "N", "of the machine, that lays the plies"}.within(0, 1e6),
             Option{"min-radius", &o.how.least_radius, "MM", "of turns, where there is room"}.within(0, 1e5),
             Option{"strict", &o.how.strict, "", "no path, exit 1, if a turn must be tighter than --min-radius"}
                 .a_limit(),
             Option{"stagger", &o.how.stagger, "", "plies of one direction lie beside each other"}.a_limit(),
             Option{"ramp", &o.ramp, "1:N", "no steeper than that where plies end within the part"},
             Option{"turn-outside", &o.how.turn_outside, "MM",
                    "rows turn beyond the rims, so far at most, and are trimmed there; 0: on the part"}
                 .zero_or_at_least(0.001)
                 .at_most(1000),
             Option{"trim-list", &o.trim_list, "FILE", "also where to trim: ply, stroke, mm along it, and the place"}
                 .not_a_setting()
                 .when("turn-outside"),
             Option{"machine", &o.machine, "NAME|FILE", "profile that must allow that, as postproc asks of it later"}
                 .not_a_setting()
                 .when("turn-outside"),
             Option{"lift", &o.how.lift, "MM", "how high the tool travels"}.within(0, 1e4).a_limit(),
             Option{"map", &o.map, "FILE", "also the surface with thickness and angles at every point"}
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
