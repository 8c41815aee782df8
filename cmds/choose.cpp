// choose - an algorithm and a seed for every patch of a surface
// reads:  Surface
// writes: Surface
// memory: the patches, and windows of distance of one candidate per thread
#include "choose/choose.hpp"
#include "base/density.hpp"
#include "cli/command.hpp"
#include "cli/progress.hpp"
#include "stream/sink.hpp"
#include "surfpath/patches.hpp"
#include "wire/surface.hpp"

namespace {

using namespace filum;
using cli::Option;

struct Options {
    choose::Options how;
    std::string algorithm = "best", weights = "coverage=1,load=1,angle=0.5,cuts=0.5,overlap=0.5", report, among;
};

cli::Spec spec(Options& o) {
    auto& plan = o.how.plan;
    return {
        .name = "choose",
        .synopsis = "choose the path of every patch of a surface",
        .description = cli::kDescription,
        .in = cli::reads(stream::Payload::surface),
        .out = cli::writes(stream::Payload::surface),
        .memory = "the patches, and windows of distance of one candidate per thread",
        .options =
            {Option{"algorithm", &o.algorithm, "", "best: try all; or only this one, from the patch's sources"}.one_of(
                 {"best", "fina", "fexa", "ortheo", "geo-fiso", "geo-contour", "geo-spiral", "field", "hybrid"}),
             Option{"among", &o.among, "NAME,...", "only candidates of these algorithms; none: of all"}
                 .when("algorithm=best")
                 .a_limit(),
             Option{"weights", &o.weights, "NAME=W,...", "how much each criterion counts; see above"},
             Option{"cut-length", &plan.cut_length, "MM", "length of fibre that a cut costs: from cutter to nozzle"}
                 .within(0, 1e5),
             Option{"finals", &o.how.finals, "N", "candidates that are planned as asked"}
                 .within(1, 1000)
                 .when("algorithm=best")
                 .a_limit(),
             Option{"spacing", &plan.spacing, "MM", "between neighbouring lines"}.within(0.001, 1000),
             Option{"min-radius", &plan.least_radius, "MM", "minimum radius of turns, where there is room"}
                 .within(0, 1e5)
                 .a_limit(),
             Option{"turn-outside", &plan.turn_outside, "MM",
                    "rows may turn so far beyond the rims, where they are trimmed; 0: they turn on the part"}
                 .zero_or_at_least(0.001)
                 .at_most(1000)
                 .when("algorithm=best|fina|fexa|ortheo|field"),
             Option{"turns", &plan.turns, "", "lines of ortheo end at the rim, or continue by tight or wide turns"}
                 .one_of({"usual", "none", "hairpin", "wide"})
                 .when("algorithm=best|ortheo")
                 .a_limit(),
             Option{"min-length", &plan.min_length, "MM", "pieces of fibre shorter than this are left out"}
                 .within(0, 1e6)
                 .a_limit(),
             Option{"report", &o.report, "FILE", "writes all candidates with their criteria, as TSV"}.not_a_setting()},
        .groups = {{"candidates", {"algorithm", "among", "finals", "weights", "cut-length"}},
                   {"lines", {"spacing", "min-radius", "turn-outside", "turns", "min-length"}}},
        .examples = {{"geodesic part.stl --cut 0,0,1,0.9 | choose --spacing 1 | surfpath --spacing 1 > part.toolpath",
                      "the path that scores best on a surface, here a part without its top"}},
        .see_also = {"partition", "stressfield", "surfpath"}};
}

std::vector<surfpath::Algorithm> algorithms(const std::string& names) {
    std::vector<surfpath::Algorithm> out;
    for (std::size_t from = 0; from < names.size();) {
        const std::size_t comma = std::min(names.find(',', from), names.size());
        const std::string name = names.substr(from, comma - from);
        const auto known = surfpath::algorithm(name);
        if (!known) throw Error(Exit::usage, "cannot use '" + name + "' for --among: surfpath has no such algorithm");
        out.push_back(*known);
        from = comma + 1;
    }
    return out;
}

void run(const Options& o, const cli::Io& io) {
    choose::Options how = o.how;
    how.weights = choose::weights(o.weights);
    how.among = algorithms(o.among);
    if (const auto asked = surfpath::algorithm(o.algorithm)) {
        how.plan.algorithm = *asked;
        how.by_hand = true;
    }
    std::vector<surface::Sheet> sheets;
    const cli::WholeInput before = cli::read_all(io.input, stream::Payload::surface,
                                                 [&](const stream::RawFrame& f) { sheets.push_back(wire::sheet(f)); });
    if (sheets.empty()) throw Error(Exit::bad_input, "cannot choose a path: the stream holds no surface");
    Notes notes;
    Facts facts;
    std::string report = choose::head(), without;
    std::vector<stream::RawFrame> frames;
    double area = 0, sum = 0;
    constexpr double kParts = 100; // of a surface, in progress
    cli::Progress progress(io, static_cast<std::uint64_t>(kParts) * sheets.size());
    for (std::size_t k = 0; k < sheets.size(); ++k) {
        const std::string name = surfpath::label(sheets, k);
        Notes own;
        how.far = [&](double share) {
            progress.reach(static_cast<std::uint64_t>(kParts * (static_cast<double>(k) + share)));
        };
        check_density(surface::area(sheets[k].surface), how.plan.spacing, Exit::usage, "--spacing");
        const auto choice = choose::choose(sheets[k], how, io.threads, own);
        const bool several = sheets.size() > 1;
        for (Note& note : own) {
            if (several) note.patch = name;
            notes.push_back(std::move(note));
        }
        for (Fact& fact : choose::facts(choice))
            facts.push_back({"", (several ? "patch." + name + "." : "") + fact.name, fact.value, fact.unit});
        area += choice.area;
        if (choice.best == choose::kNothing)
            without += (without.empty() ? "'" : ", '") + name + "': " + choice.trials.front().failed;
        else
            sum += choice.area * choice.trials[choice.best].score;
        report += choose::report(name, choice);
        frames.push_back(wire::frame(sheets[k]));
    }
    if (sheets.size() > 1) facts.push_back({"", "score", sum / area, ""});
    cli::write_all(io, cli::header(io, stream::Payload::surface, {&before.header}), before, notes, facts, frames);
    if (!o.report.empty()) {
        stream::Sink file(o.report, stream::Sink::Content::text);
        file.write(report);
        file.commit();
    }
    if (!without.empty())
        throw Error(Exit::failure, "cannot find a path for patch " + without + "; --report tells of all");
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
