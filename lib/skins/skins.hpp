// What of a region must be solid (docs/algorithms/skins.md).
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "polygon/region.hpp"

#include <span>
#include <string>
#include <vector>

namespace filum::skins {

struct Options {
    double bead_width = 0.4;          // mm
    std::int64_t top = 4, bottom = 4; // layers, >= 0
    std::int64_t walls = 2;           // rings along the outline, >= 1
    double infill = 0.15;             // share of the sparse areas' volume that is to be laid; 0: they stay empty
    double solid_below = 70;          // mm2: smaller sparse parts are made solid
    double bridge = 2;                // mm: the widest gap that a skin is laid over as it is
    polygon::Pattern pattern = polygon::Pattern::rows;
};

// How many layers up or down what lies there can matter to a region, for any settings of modifiers with the same layers
// of skin: an empty stretch of so many layers is as good as a longer one.
std::uint32_t reach_in_layers(const Options& options);

// 0.15 of "15%" or "0.15".  Error(usage) for what is below 0, or above 1.
double share(const std::string& text);

// A body in which other settings hold than in the rest of a part.
struct Modifier {
    std::vector<polygon::Loops> where; // its outlines in each layer of the part, from the first; none where it ends
    Options how;                       // see `modified`
};

// The names of a modifier's settings: those of `skins`' options.
inline const std::vector<std::string> kModifierSettings = {"infill", "infill-pattern", "walls",
                                                           "top",    "bottom",         "bead-width"};

// The settings of a modifier in a part with `options`: "infill=40%,walls=4", out of kModifierSettings.  Error(usage)
// for others and for values that those refuse.
Options modified(Options options, const std::string& settings);

// rows, wave or concentric; Error(usage) for others.
polygon::Pattern pattern(const std::string& text);

// Sets areas and walls of all regions of a part, which come in the order of their layers; nothing if the infill is 1.
// What a modifier makes otherwise begins a bead inside it, and ends for the rest a bead outside: a wall lies between.
// One with other walls or beads makes zones instead: whichever side has more walls has them along the border, too.
// Under skins lines are so near that no gap is wider than `bridge`.
// Sparse is what has `top` layers of material above it and `bottom` layers below, is no wall, and has room for a line.
// What spans more over air, from material to material of the layer below, is a bridge: with the direction in which it
// is the shortest.
// Returns what modifiers ask for in vain: other walls where all of a region is solid, other beads for its outer wall.
Notes skins(std::vector<polygon::Region>& regions, const Options& options, std::span<const Modifier> modifiers,
            Facts& facts);

} // namespace filum::skins
