// regions - contours to connected regions and the overlap graph
// reads:  Layers
// writes: Regions
// memory: 17 layers
#include "cli/command.hpp"
#include "regions/sizes.hpp"
#include "regions/stack.hpp"
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
            "What is nearer than two beads flow together, or narrower, cannot be told apart in print: a hairline, "
            "0.107 of the bead width, or --hairline. Gaps narrower than that are closed, a region nowhere as wide is "
            "left "
            "out, and where regions of two layers share nothing as wide, neither lies on the other. The first two are "
            "told. So the same part gives the same regions however its surface is cut into triangles.\n\n"
            "Each connected set of material becomes one region: an outer loop and its holes, with its area, bounding "
            "box, the region whose hole holds it, and its overlaps with the regions of the layer below: the common "
            "area, a radius that certainly fits into it, and whether a stroke can climb there. It can where a circle "
            "of half a bead's diameter fits into the common area, or, between walls thinner than a bead, one of half "
            "the thinner wall's.\n\n"
            "What is farther than half a bead from the layer below hangs in the air: each region tells its area, and "
            "one line on standard error the sum, and of the place farthest from anything below the longest bridge, the "
            "shortest straight way over it from what carries to what carries, or how far it hangs over. The first "
            "layer lies on the bed.\n\n"
            "Layers higher than a bead is wide, and beads wider than the part, are refused, as are layers that take "
            "more beads than memory holds: 25 million squares of a bead's width.",
        .in = cli::reads(stream::Payload::layers),
        .out = cli::writes(stream::Payload::regions),
        .memory = "17 layers",
        .options = {cli::Option{"bead-width", &o.bead_width, "MM",
                                "width of a bead, which decides where a stroke can climb"}
                        .within(0.01, 100)
                        .a_limit(),
                    cli::Option{"tolerance", &o.tolerance, "MM",
                                "how far a removed contour point may lie from the outline"}
                        .within(0, 1)
                        .a_limit(),
                    cli::Option{"hairline", &o.hairline, "MM",
                                "narrower gaps, walls and contacts do not count; 0: 0.107 of the bead width"}
                        .within(0, 10)
                        .a_limit()},
        .examples = {{"slice part.stl | regions > part.regions", "the regions of a part"},
                     {"slice part.stl | regions --bead-width 0.8 | peek", "for a wide nozzle; what came out"}},
        .see_also = {"slice", "sequence", "fill"}};
}

void run(const regions::Options& options, const cli::Io& io) {
    regions::Stack stack(options, io.threads);
    geom::Box2 box;
    const auto emit_all = [](const std::vector<polygon::Region>& done, const auto& emit) {
        for (const polygon::Region& r : done) emit(wire::frame(r));
    };
    cli::scan_stage(
        io, stream::Payload::layers, stream::Payload::regions,
        [&](const stream::RawFrame& frame, const auto& emit, Notes& notes) {
            auto layer = wire::layer(frame);
            regions::check_layer(layer, options.bead_width, box);
            emit_all(stack.add(std::move(layer), notes), emit);
        },
        [&](const auto& emit, Notes& notes) {
            emit_all(stack.end(notes), emit);
            regions::check_part(box, options.bead_width, notes);
            if (const auto said = regions::note(stack.air())) notes.push_back(*said);
        });
}

} // namespace

int main(int argc, char** argv) { return cli::main<regions::Options>(argc, argv, spec, run); }
