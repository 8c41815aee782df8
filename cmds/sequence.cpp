// sequence - the order in which all regions are printed
// reads:  Regions
// writes: Regions
// memory: the whole graph
#include "base/number.hpp"
#include "baselines/sun2019/order.hpp"
#include "cli/head_options.hpp"
#include "cli/output.hpp"
#include "machine/head.hpp"
#include "sequence/budget.hpp"
#include "sequence/slabs_apart.hpp"
#include "wire/planar.hpp"

namespace {

using namespace filum;

enum class Order : std::uint8_t { columns, layers, sun2019 };

struct Options {
    Order order = Order::columns;
    machine::HeadChoice head;
    std::string budget = "600", ends, pause_at;
    bool report = false;
};

cli::Spec spec(Options& o) {
    return {
        .name = "sequence",
        .synopsis = "order the regions of all layers so that few strokes print them",
        .description = cli::kDescription,
        .in = cli::reads(stream::Payload::regions),
        .out = cli::writes(stream::Payload::regions),
        .memory = "the whole graph",
        .options = cli::with(
            cli::with({cli::Option{"order", &o.order, "ORDER",
                                   "climb columns, go layer by layer, or layer by layer as in the 2019 paper"}
                           .one_of({"columns", "layers", "sun2019"})
                           .a_limit()},
                      cli::head_options(o.head)),
            {cli::Option{"budget", &o.budget, "MILLIONS|SECONDSs",
                         "steps of the search, about 3 ms per million; 10s: steps for about 10 s"}
                 .when("order=columns")
                 .a_limit(),
             cli::Option{"report", &o.report, "", "prints strokes and bounds on standard error"}.not_a_setting(),
             cli::Option{"pause-at", &o.pause_at, "LAYER|Zmm,...",
                         "prints everything below a layer (12, counted from 0) or a height (2.4mm) before it begins "
                         "anything above, for a pause by postproc"}
                 .a_limit(),
             cli::Option{"ends", &o.ends, "FILE", "writes a line per stroke with the cause of its end, as TSV"}
                 .when("!pause-at")
                 .not_a_setting()}),
        .groups = {cli::head_group()},
        .examples = {{"slice part.stl | regions | sequence > part.sequence", "the order of a part"},
                     {"slice part.stl | regions | sequence --head none --report > part.sequence",
                      "the fewest strokes, if the head were a needle"},
                     {"slice part.stl | regions | sequence --head marlin --cone-height 5 > part.sequence",
                      "the head of a machine profile, with a shorter nozzle"},
                     {"slice part.stl | regions | sequence --order layers > part.sequence", "strictly layer by layer"}},
        .see_also = {"regions", "fill", "link3d"}};
}

void run(const Options& o, const cli::Io& given) {
    cli::Io io = given;
    sequence::Options options;
    options.head = machine::head(o.head);
    for (const auto& [name, value, changed] : machine::settings(options.head))
        io.settings.push_back({name, value, changed});
    options.by_layers = o.order != Order::columns;
    if (o.order == Order::sun2019) options.layers = baselines::sun2019::order;
    options.budget = sequence::budget(o.budget);
    std::vector<stream::RawFrame> frames;
    std::vector<polygon::Region> regions;
    auto whole = cli::read_all(io.input, stream::Payload::regions, [&](stream::RawFrame frame) {
        regions.push_back(wire::region(frame));
        frames.push_back(std::move(frame));
    });
    const auto pauses = machine::parse_pauses(o.pause_at);
    const auto passed = [&](const polygon::Region& r) { return pauses.before(r.layer, r.z, r.height); };
    if (regions.empty() || passed(regions.back()) == passed(regions.front()))
        io.idle("pause-at", "the part has nothing on both sides of it");
    auto result = pauses.count() > 0 ? sequence::sequence_apart(regions, options, pauses)
                                     : sequence::sequence(std::move(regions), options);

    whole.header.expected = frames.size();
    cli::Output output(io, cli::header(io, stream::Payload::regions, {&whole.header}));
    output.pass_on(whole);
    output.add(result.facts);
    if (o.report)
        for (const auto& fact : result.facts) io.say(fact.name + " " + fixed_text(fact.value, 4));
    if (o.report) io.say("bound-by " + result.bound_by);
    if (!o.ends.empty()) {
        stream::Sink table(o.ends, stream::Sink::Content::text);
        table.write(sequence::table(result.graph, result.ends));
        table.commit();
    }
    for (std::size_t i = 0; i < result.order.size(); ++i) {
        const auto frame = std::move(frames[result.order[i]]);
        auto region = wire::region(frame);
        region.stroke = result.stroke[i];
        region.join = result.join[i];
        output.write(wire::frame(region));
    }
    output.close();
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
