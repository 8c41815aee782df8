// sequence-sun2019 - order regions layer by layer, as the 2019 paper does
// reads:  Regions
// writes: Regions
// memory: the whole graph
#include "app/sequence/sequence.hpp"
#include "baselines/sun2019/order.hpp"

namespace {

using namespace filum;
using app::sequence::Work;

cli::Spec spec(Work& o) {
    return {.name = "sequence-sun2019",
            .synopsis = "order regions layer by layer, as the 2019 paper does",
            .description = cli::kDescription,
            .in = cli::reads(stream::Payload::regions),
            .out = cli::writes(stream::Payload::regions),
            .memory = "the whole graph",
            .options =
                {cli::Option{"report", &o.report, "", "prints strokes and bounds on standard error"}.not_a_setting()},
            .examples = {{"slice part.stl | regions | sequence-sun2019 > part.sequence", "the order of the paper"}},
            .see_also = {"sequence", "fill-sun2019", "link3d-sun2019"}};
}

void run(const Work& given, const cli::Io& io) {
    Work work = given;
    work.how.by_layers = true;
    work.how.layers = baselines::sun2019::order;
    app::sequence::run(work, io);
}

} // namespace

int main(int argc, char** argv) { return cli::main<Work>(argc, argv, spec, run); }
