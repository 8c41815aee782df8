// skins - what of each region must be solid, and what is filled in part
// reads:  Regions
// writes: Regions
// memory: the whole part at 8 times the bytes that it reads, and per thread the infill of one layer at 30 times the
// bytes that 'fill' writes for it
#include "app/skins/skins.hpp"

namespace {

using namespace filum;

using app::skins::Options;

// The width of the beads of one role.
cli::Option role_width(const char* name, double* width, const char* help) {
    return cli::Option{name, width, "MM", help}.zero_or_at_least(0.01).at_most(100).a_limit();
}

std::vector<cli::Option> options(Options& all) {
    using cli::Option;
    skins::Options& o = all.how;
    return {
        Option{"infill", &all.infill, "PERCENT",
               "share of the volume inside that is filled: 15%, or 0.15; 0%: the inside stays empty; 100%: everything "
               "is solid"}
            .a_limit(),
        Option{"infill-pattern", &all.pattern, "", "pattern of sparse parts"}
            .one_of({"rows", "wave", "concentric"})
            .a_limit(),
        Option{"walls", &o.walls, "N", "rings along the outline"}.within(1, 1000).a_limit(),
        Option{"top", &o.top, "LAYERS", "solid layers below top surfaces"}.within(0, 1e6).a_limit(),
        Option{"bottom", &o.bottom, "LAYERS", "solid layers above bottom surfaces"}.within(0, 1e6).a_limit(),
        Option{"solid-below", &o.solid_below, "MM2", "smaller connected sparse parts become solid"}
            .within(0, 1e6)
            .a_limit(),
        Option{"bridge", &o.bridge, "MM",
               "widest gap below a skin: lines under skins are added to keep it, and wider air is crossed by a bridge"}
            .within(0.01, 1e6)
            .a_limit(),
        Option{"modifier", &all.modifiers, "FILE:SETTINGS",
               "settings inside the body of FILE: infill=40%,walls=4, out of infill, infill-pattern, walls, top, "
               "bottom and bead-width; or a slicer's project, PROJECT.3mf, whose modifiers have settings of their own; "
               "several with ';' between"}
            .not_a_setting()
            .a_limit(),
        role_width("inner-width", &o.inner_width,
                   "width of beads inside the outer wall; 0: as --bead-width, which the outer wall has"),
        role_width("infill-width", &o.infill_width, "width of the lines of sparse parts; 0: as --inner-width"),
        role_width("solid-width", &o.solid_width,
                   "width of beads in solid parts inside the walls; 0: as --inner-width"),
        Option{"bead-width", &o.bead_width, "MM", "width of a bead"}
            .within(0.01, 100)
            .same_as({"regions.bead-width"})
            .a_limit()};
}

cli::Spec spec(Options& all) {
    return {.name = "skins",
            .synopsis = "what of each region must be solid, and what is filled in part",
            .description = cli::kDescription,
            .in = cli::reads(stream::Payload::regions),
            .out = cli::writes(stream::Payload::regions),
            .memory =
                "the whole part at 8 times the bytes that it reads, and per thread the infill of one layer at 30 times "
                "the bytes that 'fill' writes for it",
            .options = options(all),
            .groups = {{"sparse parts", {"infill", "infill-pattern", "solid-below"}},
                       {"walls and skins", {"walls", "top", "bottom", "bridge"}},
                       {"widths of beads", {"inner-width", "infill-width", "solid-width"}}},
            .examples = {{"slice part.stl | regions | skins > part.regions", "two walls, four skins, 15 % inside"},
                         {"slice part.stl | regions | skins --infill 30% --walls 3 | sequence | fill > part.paths",
                          "stronger"}},
            .see_also = {"regions", "sequence", "fill"}};
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, app::skins::run); }
