// skins - what of each region must be solid, and what is filled in part
// reads:  Regions
// writes: Regions
// memory: the whole part
#include "app/skins/skins.hpp"

namespace {

using namespace filum;

using app::skins::Options;

std::vector<cli::Option> options(Options& all) {
    using cli::Option;
    skins::Options& o = all.how;
    return {
        Option{"infill", &all.infill, "PERCENT",
               "share of the volume inside that is laid: 15%, or 0.15; 0%: the inside stays empty; 100%: all is "
               "solid"}
            .a_limit(),
        Option{"infill-pattern", &all.pattern, "", "how sparse parts are filled"}
            .one_of({"rows", "wave", "concentric"})
            .a_limit(),
        Option{"walls", &o.walls, "N", "rings along the outline"}.within(1, 1000).a_limit(),
        Option{"top", &o.top, "LAYERS", "solid layers under what is seen from above"}.within(0, 1e6).a_limit(),
        Option{"bottom", &o.bottom, "LAYERS", "solid layers over what is seen from below"}.within(0, 1e6).a_limit(),
        Option{"solid-below", &o.solid_below, "MM2", "connected sparse parts that are smaller are made solid"}
            .within(0, 1e6)
            .a_limit(),
        Option{"bridge", &o.bridge, "MM",
               "widest gap that a skin is laid over as it is: between lines, which lie nearer to each other under "
               "skins if need be, and over air, beyond which it is a bridge"}
            .within(0.01, 1e6)
            .a_limit(),
        Option{"modifier", &all.modifiers, "FILE:SETTINGS",
               "within the body in FILE other settings hold: infill=40%,walls=4, out of infill, infill-pattern, "
               "walls, top, bottom and bead-width; or a slicer's project, PROJECT.3mf, whose modifiers have settings "
               "of their own; several with ';' between"}
            .not_a_setting()
            .a_limit(),
        Option{"bead-width", &o.bead_width, "MM", "width of a bead"}
            .within(0.01, 100)
            .same_as({"regions.bead-width"})
            .a_limit()};
}

cli::Spec spec(Options& all) {
    return {
        .name = "skins",
        .synopsis = "what of each region must be solid, and what is filled in part",
        .description =
            "Says of each region which parts are sparse: filled in part only. Solid stays what is seen from above or "
            "below, --top and --bottom layers deep, what lies within --walls rings of the outline, and what is "
            "narrower than two beads. 'fill' then makes of each region one curve of walls, skins and sparse infill; a "
            "region without sparse parts is filled as if this stage were not there, and so are all with --infill "
            "100%.\n\n"
            "Skins reach over what is sparse by half of what lies between two lines, so that a line lies under each. "
            "Where lines are farther apart than --bridge, those of the two layers under a skin lie nearer to each "
            "other.\n\n"
            "Where a skin spans more than --bridge over air, 'fill' lays it in rows along the direction whose longest "
            "row is the shortest: beads of class bridge, with a feed, flow and fan of their own in the machine's "
            "profile.\n\n"
            "--infill is a share of volume: the spacing of the lines is found such that all that is laid in sparse "
            "parts, links included, is that share of them, but for those under skins with lines nearer to each other. "
            "The spacing is told as a fact. Lines lie at the same places in all layers, rows at 45 and 135 degrees in "
            "turn, so that they lie on each other; waves are the lines of a gyroid; concentric ones follow the walls, "
            "and lie on those below where the outline stays.\n\n"
            "A --modifier is a body in which other settings hold, such as a denser infill about a screw: a mesh in the "
            "coordinates of the part's file, scaled, turned and moved as 'slice' did with that. A wall lies between "
            "what it changes and the rest. With fewer walls in the body, the others follow its border; with more, they "
            "go round within it; another bead width holds for all but the outer wall. Where several overlap, the last "
            "one counts. One that meets nothing of the part is noted.",
        .in = cli::reads(stream::Payload::regions),
        .out = cli::writes(stream::Payload::regions),
        .memory = "the whole part",
        .options = options(all),
        .groups = {{"sparse parts", {"infill", "infill-pattern", "solid-below"}},
                   {"walls and skins", {"walls", "top", "bottom", "bridge"}}},
        .examples = {{"slice part.stl | regions | skins > part.regions", "two walls, four skins, 15 % inside"},
                     {"slice part.stl | regions | skins --infill 30% --walls 3 | sequence | fill > part.paths",
                      "stronger"}},
        .see_also = {"regions", "sequence", "fill"}};
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, app::skins::run); }
