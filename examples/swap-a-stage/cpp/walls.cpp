// walls - a stage of one's own, in place of `fill`: every outline of a region as one closed bead
#include "cli/command.hpp"
#include "polygon/clip.hpp"
#include "polygon/inset.hpp"
#include "toolpath/identify.hpp"
#include "wire/planar.hpp"

namespace {

using namespace filum;

struct Options {
    double bead_width = 0.4; // mm
};

cli::Spec spec(Options& o) {
    return {.name = "walls",
            .synopsis = "every outline of a region as one closed bead",
            .description = "Draws one bead along each outline, half its width inside, and leaves the rest empty.",
            .in = cli::reads(stream::Payload::regions),
            .out = cli::writes(stream::Payload::paths),
            .memory = "one region per thread",
            .options = {cli::Option{"bead-width", &o.bead_width, "MM", "width of a bead"}.within(0.01, 100)},
            .examples = {{"slice part.stl | regions | sequence | ./walls > part.paths", "the walls of a part"}}};
}

toolpath::RegionPaths walls(const polygon::Region& region, double bead_width, Notes& notes) {
    toolpath::RegionPaths out;
    toolpath::identify(out, region);
    const polygon::Loops lines = polygon::inset(region.loops, bead_width / 2);
    for (std::size_t k = 0; k < lines.size(); ++k)
        out.curves.push_back({.closed = true,
                              .points = std::vector<geom::Vec2>(lines[k].begin(), lines[k].end()),
                              .width = {bead_width}});
    const polygon::Loops reached = polygon::subtract(region.loops, polygon::inset(region.loops, bead_width));
    out.unplaced = polygon::note_unplaced(region.loops, reached, bead_width, notes);
    return out;
}

void run(const Options& o, const cli::Io& io) {
    cli::map_stage(io, stream::Payload::regions, stream::Payload::paths,
                   [&](const stream::RawFrame& frame, Notes& notes) {
                       return std::vector{wire::frame(walls(wire::region(frame), o.bead_width, notes))};
                   });
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
