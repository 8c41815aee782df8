// surfpath - lay a path on a curved surface
// reads:  Surface
// writes: Toolpath
// memory: the model, and windows of distance
#include "app/surfpath/surfpath.hpp"
#include "cli/head_options.hpp"

namespace {

using namespace filum;
using app::surfpath::Options;
using cli::Option;

std::vector<Option> paper_options(Options& o) {
    return {
        Option{"plane", &o.plane, "NX,NY,NZ,D", "plane of the rows; none: that of the sources"}
            .numbers(4)
            .within(-1e7, 1e7)
            .when("algorithm=planned|fina|fexa|ortheo"),
        Option{"resample", &o.paper.resample, "MM", "distance between points of the path; 0: spacing / 4"}
            .zero_or_at_least(0.001)
            .at_most(1000),
        Option{"savgol-window", &o.paper.window, "POINTS", "window of the Savitzky-Golay filter, odd; 1: none"}.within(
            1, 9999),
        Option{"savgol-degree", &o.paper.degree, "", "degree of its polynomials"}.within(0, 9),
        Option{"d-iso", &o.paper.iso, "MM", "distance between the isocontours of ortheo; 0: spacing"}
            .zero_or_at_least(0.001)
            .at_most(1e4)
            .when("algorithm=planned|ortheo"),
        Option{"min-spacing", &o.paper.least_spacing, "MM", "distance at which ortheo ends lines; 0: 0.4 d"}
            .within(0, 1e4)
            .when("algorithm=planned|ortheo")
            .a_limit(),
        Option{"t-dist", &o.paper.reach, "MM", "longest join between rings; 0: 1.2 d"}
            .within(0, 1e4)
            .when("algorithm=planned|geo-fiso|geo-contour")
            .a_limit(),
        Option{"n-thresh", &o.paper.run, "POINTS",
               "number of points along which rings must be so near; 0: spacing / resample"}
            .within(0, 1e6)
            .when("algorithm=planned|geo-fiso|geo-contour|geo-spiral")
            .a_limit()};
}

// What lines of field follow.
std::vector<Option> field_options(Options& o) {
    return {
        Option{
            "follow", &o.follow, "NAME=W,...",
            "directions that field follows: direction, stress, angle, rim, rings; none: the first that the surface has"}
            .when("!method=kipping2022 algorithm=planned|field"),
        Option{"angle", &o.angle_deg, "DEG", "angle of field from the reference, counter-clockwise"}
            .within(-360, 360)
            .when("!method=kipping2022 algorithm=planned|field"),
        Option{"reference", &o.reference, "X|Y|Z|x,y,z", "of the angle: a direction, laid onto the surface"}.when(
            "!method=kipping2022 algorithm=planned|field"),
        Option{"keep", &o.plan.keep, "",
               "where directions spread, lines of field keep the spacing, or keep the angle with more births; usual: "
               "the angle if field follows nothing else"}
            .one_of({"usual", "spacing", "angle"})
            .when("!method=kipping2022 algorithm=planned|field")};
}

// How rows turn beyond the rims.
std::vector<Option> outside_options(Options& o) {
    return {Option{"turn-outside", &o.plan.turn_outside, "MM",
                   "rows may turn so far beyond the rims, where they are trimmed; 0: they turn on the part"}
                .zero_or_at_least(0.001)
                .at_most(1000)
                .when("!method=kipping2022 algorithm=planned|fina|fexa|ortheo|field")
                .same_as({"choose.turn-outside"}),
            Option{"trim-list", &o.trim_list, "FILE", "writes where to trim: stroke, mm along it, and the place"}
                .not_a_setting()
                .when("turn-outside"),
            Option{"machine", &o.machine, "NAME|FILE", "profile whose limits must allow this, as postproc checks later"}
                .not_a_setting()
                .when("turn-outside")};
}

cli::Spec spec(Options& o) {
    return {
        .name = "surfpath",
        .synopsis = "lay a path on a curved surface",
        .description = cli::kDescription,
        .in = cli::reads(stream::Payload::surface),
        .out = cli::writes(stream::Payload::toolpath),
        .memory = "the model, and windows of distance",
        .options = cli::with(
            {Option{"algorithm", &o.algorithm, "", "algorithm; it can also be the first word"}.one_of(
                 {"planned", "fina", "fexa", "ortheo", "geo-fiso", "geo-contour", "geo-spiral", "field", "hybrid"}),
             Option{"method", &o.plan.method, "", "our method, or that of Kipping et al. 2022"}.one_of(
                 {"filum", "kipping2022"}),
             Option{"spacing", &o.plan.spacing, "MM", "between neighbouring lines"}
                 .within(0.001, 1000)
                 .same_as({"choose.spacing"}),
             Option{"min-radius", &o.plan.least_radius, "MM", "minimum radius of turns, where there is room"}
                 .within(0, 1e5)
                 .same_as({"choose.min-radius"}),
             Option{"strict", &o.plan.strict, "", "no path, exit 1, if a turn must be tighter than --min-radius"}
                 .a_limit(),
             Option{"turns", &o.plan.turns, "",
                    "lines end at the rim, or continue by tight or wide turns; usual: none for ortheo, wide for field"}
                 .one_of({"usual", "none", "hairpin", "wide"})
                 .when("!method=kipping2022 algorithm=planned|ortheo|field"),
             Option{"min-length", &o.plan.min_length, "MM", "lines of ortheo shorter than this are left out"}
                 .within(0, 1e6)
                 .when("!method=kipping2022 algorithm=planned|ortheo")
                 .a_limit(),
             Option{"cut-length", &o.plan.cut_length, "MM",
                    "length of fibre that a cut costs; field and hybrid overlap no more to avoid one"}
                 .within(0, 1e6)
                 .when("!method=kipping2022 algorithm=planned|field|hybrid")
                 .same_as({"choose.cut-length"})
                 .a_limit(),
             Option{"layer-height", &o.laying.height, "MM", "height of the bead, along the normals"}.within(0.001, 100),
             Option{"ply", &o.ply, "N", "number of this ply, its layer in the toolpath"}.within(0, 1e6),
             Option{"offset", &o.laying.offset, "MM", "height of the plies below, along the normals"}.within(0, 1e4),
             Option{"lift", &o.laying.lift, "MM", "how high the tool travels"}.within(0, 1e4).a_limit()},
            cli::with(cli::with(field_options(o), outside_options(o)),
                      cli::when("method=kipping2022", paper_options(o)))),
        .groups = {{"the path and its turns", {"spacing", "min-radius", "strict", "turns", "cut-length", "min-length"}},
                   {"the bead", {"layer-height", "ply", "offset", "lift"}},
                   {"field", {"follow", "angle", "reference", "keep"}},
                   {"turns beyond the rims", {"turn-outside", "trim-list", "machine"}},
                   {"as in the 2022 paper",
                    {"plane", "resample", "savgol-window", "savgol-degree", "d-iso", "min-spacing", "t-dist",
                     "n-thresh"}}},
        .examples = {{"geodesic part.stl --cut 0,0,1,0.9 --source boundary | surfpath geo-fiso > part.toolpath",
                      "one path over a surface, here a part without its top"},
                     {"geodesic part.stl --cut 0,0,1,0.9 --source plane:1,0,0,4 --method heat --paper | surfpath fina "
                      "--method kipping2022 > part.toolpath",
                      "rows beside a plane, as the paper lays them"}},
        .see_also = {"geodesic", "metrics", "render"},
        .arguments = "[ALGORITHM] [INPUT]",
        .leading = "algorithm"};
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, app::surfpath::run); }
