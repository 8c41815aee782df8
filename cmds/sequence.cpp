// sequence - processing order over all layers
// reads:  Regions
// writes: Regions
// memory: one region
#include "cli/command.hpp"
#include "wire/planar.hpp"

namespace {

using namespace filum;

struct Options {
    std::string order = "layers";
};

cli::Spec spec(Options& o) {
    return {.name = "sequence",
            .synopsis = "processing order over all layers",
            .description = "Layer by layer.",
            .in = cli::reads(stream::Payload::regions),
            .out = cli::writes(stream::Payload::regions),
            .memory = "the whole graph",
            .options = {cli::Option{"order", &o.order, "", "how to order"}.one_of({"layers"})},
            .examples = {{"slice part.stl | regions | sequence > part.sequence", "the order of a part"}}};
}

void run(const Options&, const cli::Io& io) {
    std::int64_t last = -1;
    std::uint32_t stroke = 0;
    cli::scan_stage(io, stream::Payload::regions, stream::Payload::regions,
                    [&](const stream::RawFrame& frame, const auto& emit, Notes&) {
                        auto r = wire::region(frame);
                        r.join = Join::start;
                        for (const auto& o : r.below)
                            if (o.below == last && o.inradius > 0) r.join = Join::vertical;
                        if (r.join == Join::start && last >= 0) ++stroke;
                        r.stroke = stroke;
                        last = r.id;
                        emit(wire::frame(r));
                    });
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
