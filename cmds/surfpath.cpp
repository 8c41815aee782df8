// surfpath - lay a path on a curved surface
// reads:  Surface
// writes: Toolpath
// memory: the model, and windows of distance
#include "app/surfpath/surfpath.hpp"

namespace {

using namespace filum;
using app::surfpath::Options;
using cli::Option;

// What lines of field follow.
std::vector<Option> field_options(Options& o) {
    return {
        Option{
            "follow", &o.follow, "NAME=W,...",
            "directions that field follows: direction, stress, angle, rim, rings; none: the first that the surface has"}
            .when("algorithm=planned|field"),
        Option{"angle", &o.angle_deg, "DEG", "angle of field from the reference, counter-clockwise"}
            .within(-360, 360)
            .when("algorithm=planned|field"),
        Option{"reference", &o.reference, "X|Y|Z|x,y,z", "of the angle: a direction, laid onto the surface"}.when(
            "algorithm=planned|field"),
        Option{"keep", &o.plan.keep, "",
               "where directions spread, lines of field keep the spacing, or keep the angle with more births; usual: "
               "the angle if field follows nothing else"}
            .one_of({"usual", "spacing", "angle"})
            .when("algorithm=planned|field"),
        Option{
            "coarsen", &o.plan.coarsen, "",
            "field and hybrid plan on larger triangles if those given are needlessly fine (the default; =false: never)"}
            .when("algorithm=planned|field|hybrid")
            .a_limit()};
}

// How rows turn beyond the rims.
std::vector<Option> outside_options(Options& o) {
    return {Option{"turn-outside", &o.plan.turn_outside, "MM",
                   "rows may turn so far beyond the rims, where they are trimmed; 0: they turn on the part"}
                .zero_or_at_least(0.001)
                .at_most(1000)
                .when("algorithm=planned|fina|fexa|ortheo|field")
                .same_as({"choose.turn-outside"}),
            Option{"trim-list", &o.trim_list, "FILE", "writes where to trim: stroke, mm along it, and the place"}
                .not_a_setting()
                .when("turn-outside"),
            Option{"machine", &o.machine, "NAME|FILE", "profile whose limits must allow this, as postproc checks later"}
                .not_a_setting()
                .when("turn-outside")};
}

std::vector<Option> options(Options& o) {
    std::vector<Option> out{Option{"algorithm", &o.algorithm, "", "algorithm; it can also be the first word"}.one_of(
        {"planned", "fina", "fexa", "ortheo", "geo-fiso", "geo-contour", "geo-spiral", "field", "hybrid"})};
    out = cli::with(
        cli::with(out, app::surfpath::line_options(o)),
        {Option{"turns", &o.plan.turns, "",
                "rows end at the rim, or continue by hairpins or wide turns; usual: none for ortheo; for field the "
                "turns with less void, overlap and tight length; else wide"}
             .one_of({"usual", "none", "hairpin", "wide"})
             .when("algorithm=planned|fina|fexa|ortheo|field"),
         Option{"rim-beads", &o.plan.rim_beads, "N", "closed beads along every rim; rows turn inside of them"}
             .within(0, 20)
             .when("algorithm=planned|field !turn-outside !turns=none"),
         Option{"width-change", &o.plan.width_change, "SHARE",
                "beads may be wider or narrower by this share of the spacing, to fit the room between lines"}
             .within(0, 0.5),
         Option{"cut-length", &o.plan.cut_length, "MM",
                "length of fibre that a cut costs; to avoid one, field and hybrid lay at most so much fibre on fibre"}
             .within(0, 1e6)
             .when("algorithm=planned|field|hybrid")
             .same_as({"choose.cut-length"})
             .a_limit()});
    return cli::with(cli::with(out, app::surfpath::bead_options(o)), cli::with(field_options(o), outside_options(o)));
}

cli::Spec spec(Options& o) {
    return {
        .name = "surfpath",
        .synopsis = "lay a path on a curved surface",
        .description = cli::kDescription,
        .in = cli::reads(stream::Payload::surface),
        .out = cli::writes(stream::Payload::toolpath),
        .memory = "the model, and windows of distance",
        .options = options(o),
        .groups = {{"the path and its turns",
                    {"spacing", "min-radius", "strict", "max-tight", "min-length", "turns", "rim-beads", "cut-length"}},
                   {"the bead", {"width-change", "layer-height", "ply", "offset", "lift"}},
                   {"field", {"follow", "angle", "reference", "keep", "coarsen"}},
                   {"turns beyond the rims", {"turn-outside", "trim-list", "machine"}}},
        .examples = {{"geodesic part.stl --cut 0,0,1,0.9 --source boundary | surfpath geo-fiso > part.toolpath",
                      "one path over a surface, here a part without its top"}},
        .see_also = {"geodesic", "metrics", "render"},
        .arguments = "[ALGORITHM] [INPUT]",
        .leading = "algorithm"};
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, app::surfpath::run); }
