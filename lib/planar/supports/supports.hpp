// Supports that carry overhangs, rafts, and the brim and skirt of the first layer (docs/algorithms/supports.md).
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "polygon/region.hpp"

#include <numbers>
#include <vector>

namespace filum::supports {

struct Options {
    double bead_width = 0.4;  // mm
    double support_width = 0; // mm, of beads of supports and rafts; 0: as bead_width
    bool support = false;
    double angle = std::numbers::pi / 4; // rad from the vertical: walls that lean out less carry themselves
    bool on_part = true;                 // supports may stand on the part
    double taper = 0;                    // rad from the vertical: columns get narrower downwards at this angle
    std::int64_t gap = 1;                // empty layers between part and support, >= 1
    double beside = 1;                   // mm between part and support within a layer
    std::int64_t interface = 2;          // support layers next to the part, with denser lines
    double spacing = 2.5;                // mm from line to line
    std::int64_t raft = 0;               // layers of support below the whole part, which rises by these and `gap`
    double brim = 0;                     // mm: width of the brim around the first layer
    double skirt = 0;                    // mm between the first layer and the two beads around it; 0: no skirt
    // Per layer of the part: areas where every overhang is carried, however small, and areas where none is.
    std::vector<polygon::Loops> wanted{}, unwanted{};

    [[nodiscard]] double own_width() const { return support_width > 0 ? support_width : bead_width; } // of supports
    [[nodiscard]] bool carries() const { return support || raft > 0 || !wanted.empty(); }
};

// Adds supports, raft, brim and skirt to the regions of a part. Returns all regions with new ids, layer by layer; in
// each layer those of the part come first. A raft raises the part: layers and heights are those of the print.
//
// Preconditions: polygon::fault finds nothing, and layer numbers are indices.
//
// An overhang is the area of a layer that lies farther from the layer below than the angle allows. It must be as wide
// as half a bead somewhere. Inside `wanted` areas the angle is 0; inside `unwanted` areas nothing overhangs.
//
// Columns carry the overhang from `gap` + 1 layers below it down to the bed or the part. They get narrower downwards by
// `taper`, by at most half a bead per layer, and stay a tenth as wide as they are high. A region carried by a support
// has an overlap without a link with it.
//
// With supports, `unsupported` of the part's regions and the note give what still hangs (regions::hang): the area
// farther than half a bead from the layer below, and from supports across the gap. Fact: the volume of the supports in
// mm3.
std::vector<polygon::Region> supports(std::vector<polygon::Region> regions, const Options& options, Facts& facts,
                                      Notes& notes);

} // namespace filum::supports
