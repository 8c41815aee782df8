// laminate - plies at angles to a direction, one on the other
// reads:  Surface
// writes: Toolpath
// memory: the model and all plies
#include "app/laminate/laminate.hpp"

namespace {

using namespace filum;
using app::laminate::Options;
using cli::Option;

std::vector<Option> options(Options& o) {
    return {
        Option{"plies", &o.plies, "DEG,...", "angle of every ply, from the surface outwards"}.when("!table"),
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
        Option{"min-radius", &o.how.least_radius, "MM", "minimum radius of turns, where there is room"}.within(0, 1e5),
        Option{"turns", &o.how.turns, "",
               "rows end at the rim, or continue by hairpins or wide turns; usual: those with less void, overlap and "
               "tight length, wide ones outside the part"}
            .one_of({"usual", "none", "hairpin", "wide"}),
        Option{"rim-beads", &o.how.rim_beads, "N",
               "plies have up to N closed beads along the rims, so that their turns lie in different strips"}
            .within(0, 20)
            .when("!turn-outside !turns=none"),
        Option{"width-change", &o.how.width_change, "SHARE",
               "beads may be wider or narrower by this share of the spacing, to fit the room between lines"}
            .within(0, 0.5),
        Option{"strict", &o.how.strict, "",
               "refuse (exit 1) a ply if more than --max-tight of it turns tighter than --min-radius"}
            .a_limit(),
        Option{"max-tight", &o.how.max_tight, "SHARE",
               "share of a ply's length that may turn tighter than --min-radius"}
            .within(0, 1)
            .when("strict")
            .a_limit(),
        Option{"min-length", &o.how.min_length, "MM", "pieces of fibre shorter than this are left out"}
            .within(0, 1e6)
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
        Option{"machine", &o.machine, "NAME|FILE", "profile whose limits must allow this, as postproc checks later"}
            .not_a_setting()
            .when("turn-outside"),
        Option{"lift", &o.how.lift, "MM", "how high the tool travels"}.within(0, 1e4).a_limit(),
        Option{"map", &o.map, "FILE",
               "writes the surface with thickness and angles at every point; a large map has fewer"}
            .not_a_setting()};
}

cli::Spec spec(Options& o) {
    return {.name = "laminate",
            .synopsis = "plies at angles to a direction, one on the other",
            .description = cli::kDescription,
            .in = cli::reads(stream::Payload::surface),
            .out = cli::writes(stream::Payload::toolpath),
            .memory = "the model and all plies",
            .options = options(o),
            .groups = {{"the plies",
                        {"plies", "table", "symmetric", "reference", "keep", "layer-height", "stagger", "ramp"}},
                       {"lines",
                        {"spacing", "width-change", "turns", "rim-beads", "min-radius", "strict", "max-tight",
                         "min-length", "turn-outside", "trim-list", "machine"}}},
            .examples =
                {{"geodesic part.stl --cut 0,0,1,0.9 | laminate --plies 0,90 --symmetric --spacing 2 > part.toolpath",
                  "four plies on a surface, here a part without its top"}},
            .see_also = {"geodesic", "surfpath", "metrics", "render"}};
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, app::laminate::run); }
