// Fills one connected region with bead lines in a given pattern.
#pragma once

#include "base/note.hpp"
#include "fill/scaffold/gradient.hpp"
#include "polygon/region.hpp"
#include "toolpath/path.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace filum::fill {

// spiral_zigzag and contour_zigzag: rings outside, joined as in `spiral` or separate as in `contour`, and rows inside.
enum class Pattern : std::uint8_t { spiral, contour, zigzag, spiral_zigzag, contour_zigzag, rectilinear, scaffold };
inline constexpr std::array kPatternNames{"spiral",         "contour",     "zigzag",  "spiral+zigzag",
                                          "contour+zigzag", "rectilinear", "scaffold"};

// How the spiral fills walls thinner than a bead.
enum class Thin : std::uint8_t {
    lanes,       // two narrow lanes side by side, there and back
    half_height, // two passes of half the layer height, one on the other
    single,      // one pass, where the curve may have two ends
};
inline constexpr std::array kThinNames{"lanes", "half-height", "single"};

struct Options {
    Pattern pattern = Pattern::spiral;
    double bead_width = 0.4;        // mm
    double min_width = 0.1;         // mm: a note reports narrower beads of the spiral
    double min_radius = 0;          // mm: the minimum radius of the spiral where it has room
    std::vector<double> angles_deg; // of straight lines from the x axis, one per layer, repeated;
                                    // empty: the default of the pattern (0; scaffold 0, 90)
    std::int64_t rings = -1;        // along the outline: contour at most this many, other patterns exactly;
                                    // -1: the default (contour all, the hybrids 2, others 0)
    Thin thin = Thin::lanes;
    double spacing = 0; // scaffold: mm between strands; 0: 2.5 bead widths
    double stagger = 0; // scaffold: shift of every other round of angles, in spacings
    // scaffold: mm between strands at a place, whose x and y count from the middle of the box of the column's first
    // region; none: `spacing`. With `true` it is an Error(usage) if the place has none, else the nearest that is
    // possible.
    std::function<double(geom::Vec3, bool)> spacing_at = {};
    // scaffold: spacings are changed by one factor, so that the first region of a column gets the share of material
    // that endless strands would have
    bool by_share = false;
};

// Options for the layer at z whose strands leave `pores`, which must outlive them. `options` if no pores are given.
Options with_pores(Options options, const scaffold::Pores& pores, double z);

// Fills `region`. The result carries the id, layer, height, stroke and join of the region. Order and ties of curves are
// those of the pattern's header. spiral, zigzag and spiral+zigzag give one closed curve, except where rings cannot be
// joined or `thin` is `single`. A region without area gives no curve and a note.
toolpath::RegionPaths fill(const polygon::Region& region, const Options& options, Notes& notes);

// Fills `region` with curves from `lay`, such as a baseline's.
using Lay = std::function<std::vector<toolpath::Curve>(const polygon::Region&, Notes&)>;
toolpath::RegionPaths fill_by(const Lay& lay, const polygon::Region& region, Notes& notes);

// What a scaffold needs to know about the regions before: where the last curve ended, and the lattices of the columns.
struct ScaffoldState {
    struct Column {
        geom::Box2 box;        // bounding box of the outline of its first region
        polygon::Loops region; // its first region
        // The factor on spacings (Options::by_share), and the spacing for which it was found; 0: not yet.
        double factor = 1, fitted = 0;
    };
    std::vector<Column> columns;
    std::size_t column = 0;         // index of the column of the previous region
    std::optional<geom::Vec2> exit; // last point of its last curve; none if that is closed
};

// Fills `region` with a scaffold. Call it with regions in processing order; it updates `before`. `after`: the next
// region, to which the stroke may climb; null: none. A region joined
// vertically to the previous one begins where that one ended, and belongs to its column. Any other region belongs to
// the first column whose box contains the centre of its own; without one it begins a column. All regions of a column
// share one lattice.
toolpath::RegionPaths fill_scaffold(const polygon::Region& region, const Options& options, ScaffoldState& before,
                                    Notes& notes, const polygon::Region* after = nullptr);

// The distance between strands in mm. Throws Error(usage) if strands would overlap.
double strand_spacing(const Options& options);

} // namespace filum::fill
