// surfpath-kipping2022 - lay a path on a curved surface, as the 2022 paper does
// reads:  Surface
// writes: Toolpath
// memory: the model, and windows of distance
#include "app/surfpath/surfpath.hpp"
#include "base/density.hpp"
#include "baselines/kipping2022/kipping2022.hpp"

namespace {

using namespace filum;
using cli::Option;

struct Options {
    app::surfpath::Options path;
    baselines::kipping2022::Options paper;
    std::vector<double> plane; // normal and distance (mm) of the plane beside which rows lie; empty: from the sources
};

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

cli::Spec spec(Options& o) {
    std::vector<Option> options{
        Option{"algorithm", &o.path.algorithm, "", "algorithm; it can also be the first word"}.one_of(
            {"planned", "fina", "fexa", "ortheo", "geo-fiso", "geo-contour", "geo-spiral"})};
    options = cli::with(cli::with(options, app::surfpath::line_options(o.path)), app::surfpath::bead_options(o.path));
    return {.name = "surfpath-kipping2022",
            .synopsis = "lay a path on a curved surface, as the 2022 paper does",
            .description = cli::kDescription,
            .in = cli::reads(stream::Payload::surface),
            .out = cli::writes(stream::Payload::toolpath),
            .memory = "the model, and windows of distance",
            .options = cli::with(options, paper_options(o)),
            .groups = {{"the path and its turns", {"spacing", "min-radius", "strict", "max-tight", "min-length"}},
                       {"the bead", {"layer-height", "ply", "offset", "lift"}}},
            .examples = {{"geodesic part.stl --cut 0,0,1,0.9 --source plane:1,0,0,4 --method heat --paper | "
                          "surfpath-kipping2022 fina > part.toolpath",
                          "rows beside a plane, as the paper lays them"}},
            .see_also = {"surfpath", "geodesic", "metrics"},
            .arguments = "[ALGORITHM] [INPUT]",
            .leading = "algorithm"};
}

void run(const Options& o, const cli::Io& io) {
    app::surfpath::Options path = o.path;
    path.planner = [&](const surface::Sheet& sheet, const surfpath::Options& asked) {
        baselines::kipping2022::Options paper = o.paper;
        paper.algorithm = asked.algorithm;
        paper.spacing = asked.spacing;
        if (const auto& p = o.plane; !p.empty()) paper.plane = {{p[0], p[1], p[2]}, p[3]};
        const bool ortheo = asked.algorithm == surfpath::Algorithm::ortheo; // the only one that uses the first two
        for (const auto& [spacing, option] : {std::pair{ortheo ? paper.iso : 0, "--d-iso"},
                                              {ortheo ? paper.least_spacing : 0, "--min-spacing"},
                                              {paper.resample, "--resample"}})
            if (spacing > 0) check_density(surface::area(sheet.surface), spacing, Exit::usage, option);
        return baselines::kipping2022::plan(sheet, paper);
    };
    app::surfpath::run(path, io);
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
