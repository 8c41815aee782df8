// supports - what carries overhangs, and what holds the first layer
// reads:  Regions
// writes: Regions
// memory: the whole part
#include "app/supports/supports.hpp"

namespace {

using namespace filum;

using app::supports::Options;

constexpr const char* kDescription =
    "Adds regions that are no part: with --support columns under whatever leans out by more than "
    "--support-angle, with --raft layers under all of it, with --brim a band about the first layer, with "
    "--skirt a ring apart from it. They are ordered, filled and joined like all regions: a column climbs as a "
    "stroke of its own, before what it "
    "carries.\n\n"
    "A column stands on the bed or, unless told otherwise, on the part. It keeps clear of the part by --beside "
    "in a layer and by --gap layers above and below, and is a ring filled with rows --support-spacing apart, "
    "in "
    "the last --interface layers two bead widths. Downward it grows narrower by --support-taper, but stays a tenth as "
    "wide "
    "as it is high. Columns nearer to each other than four bead widths are "
    "one.\n\n"
    "--raft raises the part by so many layers and --gap, and carries all of its first layer by a support as "
    "wide as it and two beads more. A brim and a skirt lie about all that lies on the bed, not in its holes; a "
    "brim's rings are the first turns of a stroke of the first layer.\n\n"
    "--support-in and --no-support-in say by a body, a mesh in the coordinates of the part's file, where "
    "supports are wanted and where not: slicers call these enforcers and blockers. Of a slicer's project (3MF) with "
    "such bodies, or with faces painted so, these count and not the part itself.\n\n"
    "What still hangs in the air, as 'regions' tells it, is told anew: where there is no room for a column, "
    "where it may not stand, between a wall and a column --beside it, and what leans by less than "
    "--support-angle but "
    "by more than half a bead. Put this stage behind 'skins', if that is there.";

cli::Spec spec(Options& all) {
    using cli::Option;
    supports::Options& o = all.how;
    return {
        .name = "supports",
        .synopsis = "what carries overhangs, and what holds the first layer",
        .description = kDescription,
        .in = cli::reads(stream::Payload::regions),
        .out = cli::writes(stream::Payload::regions),
        .memory = "the whole part",
        .options = {Option{"support", &o.support, "", "carry what overhangs"}.a_limit(),
                    Option{"support-in", &all.wanted, "FILE",
                           "within this body carry whatever leans out, without --support nothing else"}
                        .not_a_setting()
                        .a_limit(),
                    Option{"no-support-in", &all.unwanted, "FILE", "within this body carry nothing"}
                        .not_a_setting()
                        .when("support/support-in")
                        .a_limit(),
                    Option{"support-on", &all.on, "", "where columns may stand"}
                        .one_of({"everywhere", "bed"})
                        .when("support/support-in")
                        .a_limit(),
                    Option{"support-angle", &all.angle_deg, "DEG",
                           "walls that lean by less from the vertical carry themselves"}
                        .within(0, 89)
                        .when("support")
                        .a_limit(),
                    Option{"support-taper", &all.taper_deg, "DEG", "columns lean inward by this, downward; 0: straight"}
                        .within(0, 60)
                        .when("support/support-in")
                        .a_limit(),
                    Option{"gap", &o.gap, "LAYERS", "left out between part and support"}
                        .within(1, 100)
                        .when("support/support-in/raft")
                        .a_limit(),
                    Option{"beside", &o.beside, "MM", "between part and support in a layer"}
                        .within(0, 100)
                        .when("support/support-in")
                        .a_limit(),
                    Option{"interface", &o.interface, "LAYERS", "of a support next to the part, with closer lines"}
                        .within(0, 100)
                        .when("support/support-in/raft")
                        .a_limit(),
                    Option{"support-spacing", &o.spacing, "MM", "from line to line of a support"}
                        .within(0.1, 100)
                        .when("support/support-in/raft")
                        .a_limit(),
                    Option{"raft", &o.raft, "LAYERS", "under all of the part, of supports; 0: none"}.within(0, 1000),
                    Option{"brim", &o.brim, "MM", "width of a band about the first layer"}.within(0, 100),
                    Option{"skirt", &o.skirt, "MM", "how far a ring keeps away from the first layer; 0: none"}.within(
                        0, 100),
                    Option{"bead-width", &o.bead_width, "MM", "width of a bead"}
                        .within(0.01, 100)
                        .same_as({"regions.bead-width"})
                        .a_limit()},
        .groups = {{"supports",
                    {"support", "support-in", "no-support-in", "support-on", "support-angle", "support-taper",
                     "beside"}},
                   {"supports and rafts", {"gap", "interface", "support-spacing"}},
                   {"the first layer", {"raft", "brim", "skirt"}}},
        .examples = {{"slice part.stl | regions | supports --support | sequence > part.sequence", "with supports"},
                     {"slice part.stl | regions | skins | supports --brim 5 | sequence | fill > part.paths",
                      "a hollow part with a brim"}},
        .see_also = {"regions", "skins", "sequence"}};
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, app::supports::run); }
