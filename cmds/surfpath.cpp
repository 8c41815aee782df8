// surfpath - lay a path on a curved surface
// reads:  Surface
// writes: Toolpath
// memory: the model, and windows of distance
#include "surfpath/surfpath.hpp"
#include "cli/command.hpp"
#include "wire/planar.hpp"
#include "wire/surface.hpp"

namespace {

using namespace filum;
using cli::Option;

struct Options {
    surfpath::Options plan;
    surfpath::Laying laying;
};

constexpr const char* kDescription = "Fills a surface with lines as far apart as the bead is wide.";

cli::Spec spec(Options& o) {
    return {
        .name = "surfpath",
        .synopsis = "lay a path on a curved surface",
        .description = kDescription,
        .in = cli::reads(stream::Payload::surface),
        .out = cli::writes(stream::Payload::toolpath),
        .memory = "the model, and windows of distance",
        .options = {Option{"algorithm", &o.plan.algorithm, "", "what lines the path follows; the first word may say it"}
                        .one_of({"fina", "fexa", "ortheo", "geo-fiso", "geo-contour", "geo-spiral"}),
                    Option{"method", &o.plan.method, "", "ours, or as Kipping et al. 2022"}.one_of(
                        {"filum", "kipping2022"}),
                    Option{"spacing", &o.plan.spacing, "MM", "between neighbouring lines"}.above(0),
                    Option{"least-radius", &o.plan.least_radius, "MM", "of turns, where there is room"}.at_least(0),
                    Option{"height", &o.laying.height, "MM", "of the bead"}.above(0),
                    Option{"lift", &o.laying.lift, "MM", "how high the tool travels above the surface"}.at_least(0)},
        .examples = {{"geodesic part.stl --source boundary | surfpath geo-fiso --spacing 2 > part.toolpath",
                      "one path over a surface"}},
        .see_also = {"geodesic", "metrics", "render"},
        .arguments = "[ALGORITHM] [INPUT]",
        .leading = "algorithm"};
}

void run(const Options& o, const cli::Io& io) {
    surface::Sheet sheet;
    auto whole = cli::read_all(io.input, stream::Payload::surface,
                               [&](const stream::RawFrame& frame) { sheet = wire::sheet(frame); });
    surfpath::Plan plan = surfpath::plan(sheet, o.plan);
    surfpath::Laying laying = o.laying;
    laying.width = o.plan.spacing;
    const auto spans = surfpath::spans(sheet.surface, plan, laying);
    whole.header.expected = spans.size();
    stream::Writer writer(io.output, cli::header(io, stream::Payload::toolpath, {&whole.header}));
    cli::Report report(io);
    for (const auto& note : whole.notes) writer.write(note);
    for (const auto& fact : whole.facts) writer.write(fact);
    for (auto note : plan.notes) {
        note.stage = io.program;
        report.add(note), writer.write(note);
    }
    for (const auto& fact : plan.facts) writer.write(Fact{io.program, fact.name, fact.value, fact.unit});
    for (const auto& span : spans) writer.write(wire::frame(span));
    report.say();
    writer.close();
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
