// regions - contours to connected regions and the overlap graph
// reads:  Layers
// writes: Regions
// memory: 33 layers at 9 times the bytes that it reads
#include "cli/command.hpp"
#include "regions/sizes.hpp"
#include "regions/stack.hpp"
#include "wire/planar.hpp"

namespace {

using namespace filum;

cli::Spec spec(regions::Options& o) {
    return {.name = "regions",
            .synopsis = "split layers into connected regions and find how they lie on each other",
            .description = cli::kDescription,
            .in = cli::reads(stream::Payload::layers),
            .out = cli::writes(stream::Payload::regions),
            .memory = "33 layers at 9 times the bytes that it reads",
            .options = {cli::Option{"bead-width", &o.bead_width, "MM",
                                    "width of a bead; it decides where a stroke can climb"}
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
            regions::check_layer(layer, layer.width > 0 ? layer.width : options.bead_width, box);
            emit_all(stack.add(std::move(layer), notes), emit);
        },
        [&](const auto& emit, Notes& notes) {
            emit_all(stack.end(notes), emit);
            regions::check_part(box, options.bead_width, notes);
            if (const auto gaps = regions::note(stack.gaps())) notes.push_back(*gaps);
            if (const auto said = regions::note(stack.air())) notes.push_back(*said);
        });
}

} // namespace

int main(int argc, char** argv) { return cli::main<regions::Options>(argc, argv, spec, run); }
