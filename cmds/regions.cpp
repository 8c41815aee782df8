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
    return {
        .name = "regions",
        .synopsis = "split layers into connected regions and find how they lie on each other",
        .description =
            "Simplifies the contours of every layer, once for the whole pipeline: a point is removed if it lies within "
            "--tolerance of what stays. Afterwards no two edges cross; outlines that came to meet are united.\n\n"
            "Each connected set of material becomes one region: an outer loop and its holes, with its area, bounding "
            "box, the region whose hole holds it, and its overlaps with the regions of the layer below: the common "
            "area, a radius that certainly fits into it, and whether a stroke can climb there. It can where a circle "
            "of half a bead's diameter fits into the common area, or, between walls thinner than a bead, one of half "
            "the thinner wall's. The rest of the area hangs free and is reported as unsupported.\n\n"
            "Regions that touch in a single point are separate. A region into which no circle of --least-width fits is "
            "left out, with a note.",
        .in = cli::reads(stream::Payload::layers),
        .out = cli::writes(stream::Payload::regions),
        .memory = "two layers",
        .options = {cli::Option{"bead-width", &o.bead_width, "MM",
                                "width of a bead, which decides where a stroke can climb"}
                        .within(0.01, 100)
                        .a_limit(),
                    cli::Option{"tolerance", &o.tolerance, "MM",
                                "how far a removed contour point may lie from the outline"}
                        .within(0, 1)
                        .a_limit(),
                    cli::Option{"least-width", &o.least_width, "MM", "regions nowhere as wide as this are left out"}
                        .above(0)
                        .at_most(10)
                        .a_limit()},
        .examples = {{"slice part.stl | regions > part.regions", "the regions of a part"},
                     {"slice part.stl | regions --bead-width 0.8 | peek", "for a wide nozzle; what came out"}},
        .see_also = {"slice", "sequence", "fill"}};
}

void run(const regions::Options& options, const cli::Io& io) {
    std::vector<polygon::Region> below;
    std::uint32_t id = 0;
    std::int64_t last = -2;
    cli::scan_stage(io, stream::Payload::layers, stream::Payload::regions,
                    [&](const stream::RawFrame& frame, const auto& emit, Notes& notes) {
                        const auto layer = wire::layer(frame);
                        if (layer.index != last + 1) below.clear(); // a gap in the stack carries nothing
                        last = layer.index;
                        below = regions::regions(layer, below, id, options, notes);
                        id += static_cast<std::uint32_t>(below.size());
                        for (const auto& r : below) emit(wire::frame(r));
                    });
}

} // namespace

int main(int argc, char** argv) { return cli::main<regions::Options>(argc, argv, spec, run); }
