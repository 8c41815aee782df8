// What carries overhangs, and what holds the first layer (docs/algorithms/supports.md).
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "polygon/region.hpp"

#include <numbers>
#include <vector>

namespace filum::supports {

struct Options {
    double bead_width = 0.4; // mm
    bool support = false;
    double angle = std::numbers::pi / 4; // rad from the vertical: steeper walls carry themselves
    bool on_part = true;                 // supports may stand on the part
    double taper = 0;                    // rad from the vertical by which columns grow narrower downward
    std::int64_t gap = 1;                // layers left out between part and support, >= 1
    double beside = 1;                   // mm between part and support in a layer
    std::int64_t interface = 2;          // layers next to the part whose lines are nearer to each other
    double spacing = 2.5;                // mm from line to line
    std::int64_t raft = 0;               // layers of support under all of the part, which is raised by these and `gap`
    double brim = 0;                     // mm about the first layer
    double skirt = 0;                    // mm between the first layer and two beads about it; 0: none
    // Per layer of the part: where all that leans out at all is carried, and where nothing is.
    std::vector<polygon::Loops> wanted{}, unwanted{};

    [[nodiscard]] bool carries() const { return support || raft > 0 || !wanted.empty(); }
};

// All regions, those of supports, brims and skirts among them: ids anew, layer by layer, in each layer those of the
// part first.  A raft raises the part: layers and heights are those of the print.  Preconditions: polygon::fault finds
// nothing, and layer numbers are indices. What overhangs is what of a layer lies farther from the layer below than the
// angle allows, in pieces as wide as half a bead, or all of a region that lies on nothing; with an angle of 0 where
// supports are wanted, and nothing where they are unwanted.  It is carried from `gap` + 1 layers below, down to the bed
// or the part by columns that grow narrower by `taper`, by at most half a bead per layer, and stay a tenth as wide as
// they are high.  Regions carried by a support have an overlap without a link with it.  With supports, `unsupported` of
// the part's regions and the note are what still hangs (regions::hang): half a bead from the layer below and from
// supports across the gap.
std::vector<polygon::Region> supports(std::vector<polygon::Region> regions, const Options& options, Facts& facts,
                                      Notes& notes);

} // namespace filum::supports
