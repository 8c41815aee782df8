// Bead lines that fill one connected region, by the pattern asked for.
#pragma once

#include "base/note.hpp"
#include "polygon/region.hpp"
#include "toolpath/path.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace filum::fill {

// spiral_zigzag and contour_zigzag: rings outside, as of the first, and rows inside.
enum class Pattern : std::uint8_t { spiral, contour, zigzag, spiral_zigzag, contour_zigzag, rectilinear, scaffold };
inline constexpr std::array kPatternNames{"spiral",         "contour",     "zigzag",  "spiral+zigzag",
                                          "contour+zigzag", "rectilinear", "scaffold"};

// How walls of the spiral that are thinner than a bead are laid.
enum class Thin : std::uint8_t {
    lanes,       // two narrow ones, there and back
    half_height, // there at half the layer's height, and back on top
    single,      // once, where the curve may have two ends for it
};
inline constexpr std::array kThinNames{"lanes", "half-height", "single"};

struct Options {
    Pattern pattern = Pattern::spiral;
    double bead_width = 0.4;        // mm
    double min_width = 0.1;         // mm: narrower beads of the spiral are reported
    double min_radius = 0;          // mm: the spiral turns no tighter where it has room
    std::vector<double> angles_deg; // of straight lines from the x axis: layer after layer, over and over;
                                    // none: the pattern's own (0; scaffold 0, 90)
    std::int64_t rings = -1;        // along the outline: of contour at most this many, of the others exactly;
                                    // -1: the pattern's own number (all, 2 of the hybrids, 0)
    Thin thin = Thin::lanes;
    double spacing = 0; // scaffold: mm between strands; 0: two and a half bead widths
    double stagger = 0; // scaffold: spacings by which every other round of angles is shifted
};

// What fills `region`, with the region's own data handed on.  Curves and ties as the pattern's own header says; spiral,
// zigzag and spiral+zigzag give one closed curve.
toolpath::RegionPaths fill(const polygon::Region& region, const Options& options, Notes& notes);

// The same by another way to lay curves, such as a baseline's.
using Lay = std::function<std::vector<toolpath::Curve>(const polygon::Region&, Notes&)>;
toolpath::RegionPaths fill_by(const Lay& lay, const polygon::Region& region, Notes& notes);

// What a scaffold's next region takes from those before: where it begins, and which lattice its strands lie on.
struct Before {
    struct Column {
        geom::Box2 box;        // of its first region
        polygon::Loops region; // that
    };
    std::vector<Column> columns;
    std::size_t column = 0;         // of the region before
    std::optional<geom::Vec2> exit; // of its curve
};

// The same, of a scaffold; regions come in processing order.  A region that continues the one before it begins where
// that ended.  It shares the lattice of the first column that its middle lies in; else it begins a column.
toolpath::RegionPaths fill_scaffold(const polygon::Region& region, const Options& options, Before& before,
                                    Notes& notes);

// The strands' spacing, mm.  Throws Error(usage) where strands would overlap.
double strand_spacing(const Options& options);

} // namespace filum::fill
