// sequence - the order in which all regions are printed
// reads:  Regions
// writes: Regions
// memory: the whole graph at 8 times the bytes that it reads
#include "app/sequence/sequence.hpp"
#include "cli/head_options.hpp"
#include "sequence/budget.hpp"

namespace {

using namespace filum;

enum class Order : std::uint8_t { columns, layers };

struct Options {
    Order order = Order::columns;
    std::string budget = "600";
    app::sequence::Work work;
};

cli::Spec spec(Options& o) {
    return {
        .name = "sequence",
        .synopsis = "order the regions of all layers so that few strokes print them",
        .description = cli::kDescription,
        .in = cli::reads(stream::Payload::regions),
        .out = cli::writes(stream::Payload::regions),
        .memory = "the whole graph at 8 times the bytes that it reads",
        .options = cli::with(
            cli::with({cli::Option{"order", &o.order, "ORDER", "climb columns, or go layer by layer"}
                           .one_of({"columns", "layers"})
                           .a_limit()},
                      cli::head_options(o.work.head)),
            {cli::Option{"clearance", &o.work.clearance, "MM",
                         "distance that the head keeps from finished regions, as in a "
                         "bath of gel"}
                 .within(0, 100)
                 .when("!head=none")
                 .not_a_setting()
                 .a_limit(),
             cli::Option{"from-inside", &o.work.how.from_inside, "",
                         "of strokes that surround each other, prints the inner one first where it can"}
                 .when("order=columns")
                 .not_a_setting()
                 .a_limit(),
             cli::Option{"budget", &o.budget, "MILLIONS|SECONDSs",
                         "steps of the search, about 3 ms per million; 10s: steps for about 10 s"}
                 .when("order=columns")
                 .a_limit(),
             cli::Option{"tool-changes", &o.work.how.first, "WHEN",
                         "with several tools: reduces the changes of the tool second, after the strokes, or first"}
                 .one_of({"second", "first"})
                 .not_a_setting()
                 .a_limit(),
             cli::Option{"report", &o.work.report, "", "prints strokes and bounds on standard error"}.not_a_setting(),
             cli::Option{"pause-at", &o.work.pause_at, "LAYER|Zmm,...",
                         "prints everything below a layer (12, counted from 0) or a height (2.4mm) before it begins "
                         "anything above, for a pause by postproc"}
                 .a_limit(),
             cli::Option{"ends", &o.work.ends, "FILE", "writes a line per stroke with the cause of its end, as TSV"}
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

void run(const Options& o, const cli::Io& io) {
    app::sequence::Work work = o.work;
    work.how.by_layers = o.order == Order::layers;
    work.how.budget = sequence::budget(o.budget);
    app::sequence::run(work, io);
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
