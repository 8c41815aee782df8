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
            "Marks the parts of each region that get sparse infill. Top and bottom surfaces stay solid, --top and "
            "--bottom "
            "layers deep. So do --walls rings inside the outline, and parts narrower than two beads. 'fill' then makes "
            "one "
            "curve of walls, skins and sparse infill in each region. A region without sparse parts is filled as if "
            "this "
            "stage were absent, and with --infill 100% this applies to all.\n\n"
            "Skins reach over sparse parts by half the distance between two lines, so that a line lies under each. "
            "Where "
            "lines are farther apart than --bridge, those of the two layers under a skin lie nearer to each other.\n\n"
            "Where a skin spans more than --bridge over air, 'fill' prints it in rows along the direction whose "
            "longest row "
            "is the shortest. Such beads have the class bridge, with a feed, flow and fan of their own in the "
            "machine's "
            "profile.\n\n"
            "--infill is a share of volume. The spacing of the lines is chosen so that all material in sparse parts, "
            "including links, is that share of them. Parts under skins, with their denser lines, do not count. The "
            "spacing "
            "is a fact. Lines lie in the same places in all layers, so they rest on each other. Rows run at 45 and 135 "
            "degrees in turn, waves are the lines of a gyroid, and concentric lines follow the walls.\n\n"
            "A --modifier is a body with other settings inside, such as a denser infill around a screw. It is a mesh "
            "in the "
            "coordinates of the part's file, and 'slice' scales, turns and moves it with the part. A wall separates it "
            "from "
            "the rest. With fewer walls in the body, the other walls follow its border; with more, they run inside it. "
            "Another bead width applies to everything except the outer wall. Where several bodies overlap, the last "
            "one "
            "counts. A body that does not touch the part is a note.",
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
