// supports - what carries overhangs, and what holds the first layer
// reads:  Regions
// writes: Regions
// memory: the whole part
#include "app/supports/supports.hpp"

namespace {

using namespace filum;

using app::supports::Options;

constexpr const char* kDescription =
    "Adds regions that are not part of the model: with --support columns under everything that leans out by more "
    "than --support-angle, with --raft layers under all of it, with --brim a band around the first layer, with "
    "--skirt a separate ring. They are ordered, filled and joined like all regions. A column is a stroke of its own, "
    "printed before the part that it carries.\n\n"
    "A column stands on the bed or, by default, also on the part. It keeps --beside away from the part in a layer, "
    "and --gap layers above and below. It is a ring filled with rows --support-spacing apart, and two bead widths "
    "apart in the last --interface layers. Downwards it shrinks by --support-taper, but stays a tenth as wide as it "
    "is high. Columns nearer to each other than four bead widths become one.\n\n"
    "--raft raises the part by so many layers and --gap, and carries all of its first layer by a support as wide as "
    "it and two beads more. A brim and a skirt surround everything on the bed, but not the inside of holes. A brim's "
    "rings are the first part of a stroke of the first layer.\n\n"
    "--support-in and --no-support-in name a body, a mesh in the coordinates of the part's file, in which supports "
    "are wanted or unwanted. Slicers call these enforcers and blockers. Of a slicer's project (3MF) with such "
    "bodies, or with painted faces, these count and not the part itself.\n\n"
    "The overhang that 'regions' reported is measured again. It remains where there is no room for a column, where a "
    "column may not stand, between a wall and a column --beside it, and where a part leans by less than "
    "--support-angle but by more than half a bead. Put this stage behind 'skins', if you use that.";

cli::Spec spec(Options& all) {
    using cli::Option;
    supports::Options& o = all.how;
    return {.name = "supports",
            .synopsis = "what carries overhangs, and what holds the first layer",
            .description = kDescription,
            .in = cli::reads(stream::Payload::regions),
            .out = cli::writes(stream::Payload::regions),
            .memory = "the whole part",
            .options =
                {Option{"support", &o.support, "", "adds supports under overhangs"}.a_limit(),
                 Option{"support-in", &all.wanted, "FILE",
                        "supports everything that leans out inside this body; without --support nothing else"}
                     .not_a_setting()
                     .a_limit(),
                 Option{"no-support-in", &all.unwanted, "FILE", "adds no supports inside this body"}
                     .not_a_setting()
                     .when("support/support-in")
                     .a_limit(),
                 Option{"support-on", &all.on, "", "where columns may stand"}
                     .one_of({"everywhere", "bed"})
                     .when("support/support-in")
                     .a_limit(),
                 Option{"support-angle", &all.angle_deg, "DEG",
                        "walls that lean by less from the vertical need no supports"}
                     .within(0, 89)
                     .when("support")
                     .a_limit(),
                 Option{"support-taper", &all.taper_deg, "DEG", "columns taper downwards by this angle; 0: straight"}
                     .within(0, 60)
                     .when("support/support-in")
                     .a_limit(),
                 Option{"gap", &o.gap, "LAYERS", "empty layers between part and support"}
                     .within(1, 100)
                     .when("support/support-in/raft")
                     .a_limit(),
                 Option{"beside", &o.beside, "MM", "distance between part and support in a layer"}
                     .within(0, 100)
                     .when("support/support-in")
                     .a_limit(),
                 Option{"interface", &o.interface, "LAYERS", "layers of a support next to the part, with closer lines"}
                     .within(0, 100)
                     .when("support/support-in/raft")
                     .a_limit(),
                 Option{"support-spacing", &o.spacing, "MM", "distance between lines of a support"}
                     .within(0.1, 100)
                     .when("support/support-in/raft")
                     .a_limit(),
                 Option{"raft", &o.raft, "LAYERS", "layers of support under all of the part; 0: none"}.within(0, 1000),
                 Option{"brim", &o.brim, "MM", "width of a band around the first layer"}.within(0, 100),
                 Option{"skirt", &o.skirt, "MM", "distance of a ring from the first layer; 0: no ring"}.within(0, 100),
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
