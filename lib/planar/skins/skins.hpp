// Which parts of a region must be solid, and which can be sparse (docs/algorithms/skins.md).
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "polygon/region.hpp"

#include <span>
#include <string>
#include <vector>

namespace filum::skins {

struct Options {
    double bead_width = 0.4;          // mm; of the outer wall, if others are given:
    double inner_width = 0;           // mm, of the beads inside the outer wall; 0: as bead_width
    double infill_width = 0;          // mm, of the lines of sparse areas; 0: as inner_width
    double solid_width = 0;           // mm, of solid areas inside the walls; 0: as inner_width
    std::int64_t top = 4, bottom = 4; // layers, >= 0
    std::int64_t walls = 2;           // rings along the outline, >= 1
    double infill = 0.15;             // share of the volume of sparse areas that beads fill; 0: they stay empty
    double solid_below = 70;          // mm2: sparse parts smaller than this become solid
    double bridge = 2; // mm: the widest gap that a skin crosses without a bridge or denser lines below it
    polygon::InfillPattern pattern = polygon::InfillPattern::rows;
};

// The widths in mm of the beads inside the outer wall, of sparse lines, and of solid areas.
double inner_width(const Options& options);
double infill_width(const Options& options);
double solid_width(const Options& options);

// The number of layers, up and down, that can influence a region. It holds for the settings of all modifiers that have
// the same `top` and `bottom`. An empty stretch of that many layers has the same effect as a longer one.
std::uint32_t reach_in_layers(const Options& options);

// Reads a share: 0.15 from "15%" or "0.15". Throws Error(usage) if the value is below 0 or above 1.
double share(const std::string& text);

// A body inside which other settings hold than in the rest of the part.
struct Modifier {
    std::vector<polygon::Loops> where; // its outlines per layer of the part, from the first; empty beyond its ends
    Options how;                       // see `modified`
};

// The settings that a modifier can have: the options of `skins` with these names.
inline const std::vector<std::string> kModifierSettings = {"infill", "infill-pattern", "walls",
                                                           "top",    "bottom",         "bead-width"};

// The settings of a modifier in a part with `options`. `settings` is a list like "infill=40%,walls=4", with names from
// kModifierSettings. Throws Error(usage) for other names, and for values that the settings do not accept.
Options modified(Options options, const std::string& settings);

// Reads a pattern: rows, wave or concentric. Throws Error(usage) for any other text.
polygon::InfillPattern pattern(const std::string& text);

// Sets the areas and walls of all regions of a part. Regions come in the order of their layers. Nothing changes if the
// infill is 1 and there are no modifiers.
//
// An area is sparse if it has `top` layers of material above it and `bottom` layers below it. It excludes walls and
// places too narrow for lines. Below skins, sparse lines lie so near to each other that no gap is wider than `bridge`.
// A skin over air that is carried at both ends, and is wider than `bridge`, becomes a bridge (bridges.hpp).
//
// A modifier with the walls and the bead width of the part begins one bead inside its outline. The rest of the part
// ends one bead outside it, so that a wall fits between. A modifier with other walls or bead widths makes zones. The
// side with more walls has them along the border, too.
//
// Where beads inside the outer wall, or in solid areas, have widths of their own, a zone covers the region. A region
// with a width of its own (Region::width) has that width throughout.
//
// Returns notes on settings of modifiers that have no effect: other walls in a region that is all solid, another bead
// width in a region that has one of its own, and for the outer wall, which keeps that of the part. Facts: the spacing
// of each setting in mm, and the share in percent that concentric lines, and few lines, reach.
Notes skins(std::vector<polygon::Region>& regions, const Options& options, std::span<const Modifier> modifiers,
            Facts& facts);

} // namespace filum::skins
