// fill - bead lines that fill each region
// reads:  Regions
// writes: Paths
// memory: one region per thread
#include "fill/fill.hpp"
#include "cli/command.hpp"
#include "wire/planar.hpp"

namespace {

using namespace filum;

cli::Spec spec(fill::Options& o) {
    return {.name = "fill",
            .synopsis = "bead lines that fill each region",
            .description = "Fills.",
            .in = cli::reads(stream::Payload::regions),
            .out = cli::writes(stream::Payload::paths),
            .memory = "one region per thread",
            .options = {cli::Option{"bead-width", &o.bead_width, "MM", "width of a bead"}.above(0)},
            .examples = {{"slice part.stl | regions | sequence | fill > part.paths", "the fill of a part"}}};
}

void run(const fill::Options& options, const cli::Io& io) {
    cli::map_stage(io, stream::Payload::regions, stream::Payload::paths, [&](stream::RawFrame frame, Notes& notes) {
        return std::vector{wire::frame(fill::fill(wire::region(frame), options, notes))};
    });
}

} // namespace

int main(int argc, char** argv) { return cli::main<fill::Options>(argc, argv, spec, run); }
