// link3d-sun2019 - curves to one toolpath, as the 2019 paper links them
// reads:  Paths
// writes: Toolpath
// memory: all regions
#include "app/link3d/link.hpp"
#include "baselines/sun2019/link.hpp"

namespace {

using namespace filum;
using baselines::sun2019::LinkOptions;

cli::Spec spec(LinkOptions& o) {
    return {.name = "link3d-sun2019",
            .synopsis = "curves to one toolpath, as the 2019 paper links them",
            .description = cli::kDescription,
            .in = cli::reads(stream::Payload::paths),
            .out = cli::writes(stream::Payload::toolpath),
            .memory = "all regions",
            .options = {cli::Option{"start-shift", &o.start_shift, "MM", "distance of starts from layer to layer"}
                            .within(0, 1e6)
                            .same_as({"fill-sun2019.start-shift"})},
            .examples = {{"slice part.stl | regions | sequence-sun2019 | fill-sun2019 | link3d-sun2019 > part.toolpath",
                          "the whole method of the paper"}},
            .see_also = {"link3d", "fill-sun2019", "sequence-sun2019"}};
}

void run(const LinkOptions& o, const cli::Io& io) { app::link3d::link(baselines::sun2019::Linker(o), io); }

} // namespace

int main(int argc, char** argv) { return cli::main<LinkOptions>(argc, argv, spec, run); }
