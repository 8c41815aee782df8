// supports - what carries overhangs, and what holds the first layer
// reads:  Regions
// writes: Regions
// memory: the whole part
#include "app/supports/supports.hpp"

namespace {

using namespace filum;

using app::supports::Options;

std::vector<cli::Option> options(Options& all) {
    using cli::Option;
    supports::Options& o = all.how;
    return {
        Option{"support", &o.support, "", "adds supports under overhangs"}.a_limit(),
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
        Option{"support-angle", &all.angle_deg, "DEG", "walls that lean by less from the vertical need no supports"}
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
        Option{"support-width", &o.support_width, "MM", "width of the beads of supports and rafts; 0: as --bead-width"}
            .zero_or_at_least(0.01)
            .at_most(100)
            .when("support/support-in/raft")
            .a_limit(),
        Option{"raft", &o.raft, "LAYERS", "layers of support under all of the part; 0: none"}.within(0, 1000),
        Option{"brim", &o.brim, "MM", "width of a band around the first layer"}.within(0, 100),
        Option{"skirt", &o.skirt, "MM", "distance of a ring from the first layer; 0: no ring"}.within(0, 100),
        Option{"bead-width", &o.bead_width, "MM", "width of a bead"}
            .within(0.01, 100)
            .same_as({"regions.bead-width"})
            .a_limit()};
}

cli::Spec spec(Options& all) {
    return {.name = "supports",
            .synopsis = "what carries overhangs, and what holds the first layer",
            .description = cli::kDescription,
            .in = cli::reads(stream::Payload::regions),
            .out = cli::writes(stream::Payload::regions),
            .memory = "the whole part",
            .options = options(all),
            .groups = {{"supports",
                        {"support", "support-in", "no-support-in", "support-on", "support-angle", "support-taper",
                         "beside"}},
                       {"supports and rafts", {"gap", "interface", "support-spacing", "support-width"}},
                       {"the first layer", {"raft", "brim", "skirt"}}},
            .examples = {{"slice part.stl | regions | supports --support | sequence > part.sequence", "with supports"},
                         {"slice part.stl | regions | skins | supports --brim 5 | sequence | fill > part.paths",
                          "a hollow part with a brim"}},
            .see_also = {"regions", "skins", "sequence"}};
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, app::supports::run); }
