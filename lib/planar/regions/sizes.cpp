#include "regions/sizes.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>

namespace filum::regions {

namespace {

// Limit on the squares one bead wide in a layer: later stages hold some hundred bytes for each. A layer of 2 x 2 m with
// beads of 0.4 mm has as many.
constexpr double kMostBeads = 2.5e7;
constexpr double kSame = 1 + 1e-9; // tolerance for the rounding of heights

} // namespace

void check_layer(const polygon::Layer& layer, double bead_width, geom::Box2& box) {
    if (layer.height > bead_width * kSame)
        throw Error(Exit::usage, "cannot lay beads " + fixed_text(bead_width, 4) + " mm wide in a layer " +
                                     fixed_text(layer.height, 4) +
                                     " mm high: a bead is no higher than it is wide; give a larger --bead-width, or "
                                     "slice with a smaller --layer-height");
    const double area = polygon::signed_area(layer.contours);
    if (area > kMostBeads * bead_width * bead_width)
        throw Error(Exit::bad_input, "cannot fill layer " + std::to_string(layer.index) + " of " +
                                         fixed_text(area / 1e6, 2) + " m2 with beads " + fixed_text(bead_width, 4) +
                                         " mm wide: it takes " + fixed_text(area / bead_width / 1e6, 1) +
                                         " km of them and gigabytes of memory; check --unit and --scale of slice, or "
                                         "give a larger --bead-width");
    for (const geom::Vec2 p : layer.contours.points) box.add(p);
}

void check_part(const geom::Box2& box, double bead_width, Notes& notes) {
    if (box.empty()) return;
    const double w = box.hi.x - box.lo.x, d = box.hi.y - box.lo.y;
    if (std::max(w, d) * kSame < bead_width)
        throw Error(Exit::usage, "cannot lay beads " + fixed_text(bead_width, 4) + " mm wide in a part of " +
                                     fixed_text(w, 2) + " x " + fixed_text(d, 2) +
                                     " mm: they are wider than all of it; give a smaller --bead-width");
    if (std::min(w, d) * kSame < bead_width)
        notes.push_back({.code = NoteCode::part_below_bead, .amount = std::min(w, d)});
}

} // namespace filum::regions
