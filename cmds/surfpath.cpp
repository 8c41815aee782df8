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

constexpr const char* kDescription =
    "Fills a surface with lines one spacing apart, inside its rims, as one stroke where there is a way. What "
    "they follow is where `geodesic` measured from: fina, rows at equal distances from a line; fexa, rows in "
    "planes along a plane cut; ortheo, lines straight away from a line; geo-fiso, rings inside the rims, in and out "
    "again; geo-contour, rings that end on the ridge; geo-spiral, a spiral around a point, then arcs. Two "
    "need no source: lines of field follow the stress, an angle to a reference direction, as plies are given, a rim, "
    "or rings about all rims; those of hybrid are rings about holes and along rims that turn into each other where "
    "they meet, and so cover what a wide turn of a whole ring leaves bare. The fact rings-bound says what share closed "
    "lines can cover that bend no tighter than --min-radius. Rows are taken some apart, so that turns "
    "are wide; those that must be tighter than --min-radius are spans of their own, declared as hairpins. What cannot "
    "be placed is noted. Rings of closed surfaces begin at a seam, which is found and noted, or at the source. The "
    "fact "
    "cuts-bound says how few cuts there can be, for whoever covers all and lays no more than --cut-length twice to "
    "save "
    "one.\n\n"
    "Of several surfaces, patches of one part, each is filled in its turn. What `choose` has planned for a surface "
    "travels with it, and is followed unless an algorithm is named; without any plan it is geo-fiso. A patch without "
    "a plan among others that have one is left out, and noted. Facts of several patches begin with 'patch.' and their "
    "names.\n\n"
    "--method kipping2022 does it as J. Kipping, Z. Kallai, T. Schueppstuhl, 2022, section 3, for comparison: rows "
    "beside a plane, fina by distance on the surface, fexa by that in space; ortheo, lines across the isocontours of a "
    "seed curve; rings inside the rims, geo-fiso as one path, geo-contour as spirals; geo-spiral around a seed point. "
    "The last group of options is for this method only. What the paper does not give: --resample, --savgol-window, "
    "--savgol-degree, --min-spacing. Smoothing takes the path off the surface.";

std::vector<Option> paper_options(Options& o) {
    return {Option{"plane", &o.plane, "NX,NY,NZ,D", "beside which rows lie; none: that of the sources"}
                .numbers(4)
                .within(-1e7, 1e7)
                .when("algorithm=planned|fina|fexa|ortheo"),
            Option{"resample", &o.paper.resample, "MM", "between points of the path; 0: spacing / 4"}
                .zero_or_at_least(0.001)
                .at_most(1000),
            Option{"savgol-window", &o.paper.window, "POINTS", "of the Savitzky-Golay filter, odd; 1: none"}.within(
                1, 9999),
            Option{"savgol-degree", &o.paper.degree, "", "of its polynomials"}.within(0, 9),
            Option{"d-iso", &o.paper.iso, "MM", "between isocontours that ortheo steps along; 0: spacing"}
                .zero_or_at_least(0.001)
                .at_most(1e4)
                .when("algorithm=planned|ortheo"),
            Option{"min-spacing", &o.paper.least_spacing, "MM", "where ortheo ends lines; 0: 0.4 d"}
                .within(0, 1e4)
                .when("algorithm=planned|ortheo")
                .a_limit(),
            Option{"t-dist", &o.paper.reach, "MM", "farthest that rings are joined across; 0: 1.2 d"}
                .within(0, 1e4)
                .when("algorithm=planned|geo-fiso|geo-contour")
                .a_limit(),
            Option{"n-thresh", &o.paper.run, "POINTS", "that they are so near for; 0: spacing / resample"}
                .within(0, 1e6)
                .when("algorithm=planned|geo-fiso|geo-contour|geo-spiral")
                .a_limit()};
}

// What lines of field follow.
std::vector<Option> field_options(Options& o) {
    return {
        Option{"follow", &o.follow, "NAME=W,...",
               "what field follows: direction, stress, angle, rim, rings; none: the first that the surface has"}
            .when("!method=kipping2022 algorithm=planned|field"),
        Option{"angle", &o.angle_deg, "DEG", "of field, from the reference, counter-clockwise"}.within(-360, 360).when(
            "!method=kipping2022 algorithm=planned|field"),
        Option{"reference", &o.reference, "X|Y|Z|x,y,z", "of the angle: a direction, laid onto the surface"}.when(
            "!method=kipping2022 algorithm=planned|field"),
        Option{"keep", &o.plan.keep, "",
               "where directions spread, lines of field keep to the spacing, or to the angle by ending more of "
               "them; usual: the angle if that alone is asked for"}
            .one_of({"usual", "spacing", "angle"})
            .when("!method=kipping2022 algorithm=planned|field")};
}

// How rows turn beyond the rims.
std::vector<Option> outside_options(Options& o) {
    return {Option{"turn-outside", &o.plan.turn_outside, "MM",
                   "rows turn beyond the rims, so far at most, and are trimmed there; 0: on the part"}
                .zero_or_at_least(0.001)
                .at_most(1000)
                .when("!method=kipping2022 algorithm=planned|fina|fexa|ortheo|field")
                .same_as({"choose.turn-outside"}),
            Option{"trim-list", &o.trim_list, "FILE", "also where to trim: stroke, mm along it, and the place"}
                .not_a_setting()
                .when("turn-outside"),
            Option{"machine", &o.machine, "NAME|FILE", "profile that must allow that, as postproc asks of it later"}
                .not_a_setting()
                .when("turn-outside")};
}

cli::Spec spec(Options& o) {
    return {
        .name = "surfpath",
        .synopsis = "lay a path on a curved surface",
        .description = kDescription,
        .in = cli::reads(stream::Payload::surface),
        .out = cli::writes(stream::Payload::toolpath),
        .memory = "the model, and windows of distance",
        .options = cli::with(
            {Option{"algorithm", &o.algorithm, "", "what lines the path follows; the first word may say it"}.one_of(
                 {"planned", "fina", "fexa", "ortheo", "geo-fiso", "geo-contour", "geo-spiral", "field", "hybrid"}),
             Option{"method", &o.plan.method, "", "ours, or as Kipping et al. 2022"}.one_of({"filum", "kipping2022"}),
             Option{"spacing", &o.plan.spacing, "MM", "between neighbouring lines"}
                 .within(0.001, 1000)
                 .same_as({"choose.spacing"}),
             Option{"min-radius", &o.plan.least_radius, "MM", "of turns, where there is room"}.within(0, 1e5).same_as(
                 {"choose.min-radius"}),
             Option{"strict", &o.plan.strict, "", "no path, exit 1, if a turn must be tighter than --min-radius"}
                 .a_limit(),
             Option{"turns", &o.plan.turns, "",
                    "lines end at the rim, or go on by tight or wide turns; usual: of ortheo none, of field wide"}
                 .one_of({"usual", "none", "hairpin", "wide"})
                 .when("!method=kipping2022 algorithm=planned|ortheo|field"),
             Option{"min-length", &o.plan.min_length, "MM", "of lines of ortheo: shorter ones are left out"}
                 .within(0, 1e6)
                 .when("!method=kipping2022 algorithm=planned|ortheo")
                 .a_limit(),
             Option{"cut-length", &o.plan.cut_length, "MM",
                    "of fibre that a cut costs: field and hybrid go no farther along what is laid to save one"}
                 .within(0, 1e6)
                 .when("!method=kipping2022 algorithm=planned|field|hybrid")
                 .same_as({"choose.cut-length"})
                 .a_limit(),
             Option{"layer-height", &o.laying.height, "MM", "of the bead, along the normals"}.within(0.001, 100),
             Option{"ply", &o.ply, "N", "number of this ply, its layer in the toolpath"}.within(0, 1e6),
             Option{"offset", &o.laying.offset, "MM", "along the normals: the plies below"}.within(0, 1e4),
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
