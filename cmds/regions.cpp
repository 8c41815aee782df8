// regions - contours to connected regions and the overlap graph
// reads:  Layers
// writes: Regions
// memory: two layers
#include "regions/regions.hpp"
#include "cli/command.hpp"
#include "wire/planar.hpp"

namespace {

using namespace filum;

cli::Spec spec(regions::Options& o) {
    return {.name = "regions",
            .synopsis = "contours to connected regions and the overlap graph",
            .description = "Splits.",
            .in = cli::reads(stream::Payload::layers),
            .out = cli::writes(stream::Payload::regions),
            .memory = "two layers",
            .options = {cli::Option{"bead-width", &o.bead_width, "MM", "width of a bead"}.above(0)},
            .examples = {{"slice part.stl | regions > part.regions", "the regions of a part"}}};
}

void run(const regions::Options& options, const cli::Io& io) {
    std::vector<polygon::Region> below;
    std::uint32_t id = 0;
    cli::scan_stage(io, stream::Payload::layers, stream::Payload::regions,
                    [&](const stream::RawFrame& frame, const auto& emit, Notes& notes) {
                        below = regions::regions(wire::layer(frame), below, id, options, notes);
                        id += static_cast<std::uint32_t>(below.size());
                        for (const auto& r : below) emit(wire::frame(r));
                    });
}

} // namespace

int main(int argc, char** argv) { return cli::main<regions::Options>(argc, argv, spec, run); }
