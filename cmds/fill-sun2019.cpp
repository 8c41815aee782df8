// fill-sun2019 - the spiral of the 2019 paper that fills each region
// reads:  Regions
// writes: Paths
// memory: one region per thread, and outlines filled before, up to 32 MB
#include "base/density.hpp"
#include "base/error.hpp"
#include "baselines/sun2019/spiral.hpp"
#include "cli/command.hpp"
#include "wire/planar.hpp"

namespace {

using namespace filum;
using baselines::sun2019::SpiralOptions;
using cli::Option;

cli::Spec spec(SpiralOptions& o) {
    return {.name = "fill-sun2019",
            .synopsis = "the spiral of the 2019 paper that fills each region",
            .description = cli::kDescription,
            .in = cli::reads(stream::Payload::regions),
            .out = cli::writes(stream::Payload::paths),
            .memory = "one region per thread, and outlines filled before, up to 32 MB",
            .options = {Option{"bead-width", &o.offset, "MM", "width of a bead, and distance of the contours"}
                            .within(0.01, 100)
                            .same_as({"regions.bead-width"}),
                        Option{"threshold", &o.threshold, "WIDTHS", "contours within this distance are adjacent"}
                            .within(1, 4)
                            .a_limit(),
                        Option{"start-shift", &o.start_shift, "MM",
                               "how far the start moves along the outer contour from layer to layer"}
                            .within(0, 1e6)},
            .examples = {{"slice part.stl | regions | sequence-sun2019 | fill-sun2019 > part.paths",
                          "the spirals of the paper"},
                         {"filum print part.stl --stage fill=fill-sun2019 -o part.gcode",
                          "in place of fill in the chain of today"}},
            .see_also = {"fill", "sequence-sun2019", "link3d-sun2019"}};
}

void run(const SpiralOptions& o, const cli::Io& io) {
    fill::ReuseByWidth filled([&](double width) {
        SpiralOptions own = o;
        own.offset = width;
        return baselines::sun2019::filler(own);
    });
    cli::map_stage(
        io, stream::Payload::regions, stream::Payload::paths, [&](const stream::RawFrame& frame, Notes& notes) {
            const polygon::Region region = wire::region(frame);
            if (region.walls > 0)
                throw Error(
                    Exit::bad_input,
                    "cannot fill a region of layer " + std::to_string(region.layer) +
                        ": it has walls and sparse areas, and this method fills solid regions; leave 'skins' out");
            const double width = region.width > 0 ? region.width : o.offset;
            check_density(polygon::signed_area(region.loops), width, Exit::usage, "--bead-width");
            return std::vector{wire::frame(filled.of(width)(region, notes))};
        });
}

} // namespace

int main(int argc, char** argv) { return cli::main<SpiralOptions>(argc, argv, spec, run); }
