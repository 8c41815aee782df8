#include "fill/contour.hpp"

#include "fill/inset.hpp"
#include "polygon/clip.hpp"

#include <algorithm>
#include <cmath>

namespace filum::fill {

using polygon::Loops;

namespace {

constexpr double kWider = 0.1; // a bead may be this share wider than asked before one more ring is laid

void add_rings(const Loops& loops, double width, std::vector<toolpath::Curve>& out) {
    for (std::size_t i = 0; i < loops.size(); ++i) out.push_back({true, {loops[i].begin(), loops[i].end()}, {width}});
}

// Simplifying may make a ring cross itself where it all but touches itself.
Loops uncrossed(const Loops& loops) { return polygon::unite(loops); }

} // namespace

std::vector<toolpath::Curve> contour(const Loops& region, const ContourOptions& o, Notes& notes) {
    std::vector<toolpath::Curve> out;
    double width = o.bead_width;
    if (o.fit) {
        const double r = inradius(region, o.bead_width / 2, o.bead_width / 256);
        if (r > 0) width = r / std::max(1.0, std::ceil(r / o.bead_width - kWider));
    }
    const double first = width / 2;
    Loops loops = inset(region, first);
    note_unplaced(region, inset(loops, -first), o.bead_width, notes);
    for (int ring = 1; !loops.empty(); ++ring) {
        loops = uncrossed(loops);
        add_rings(loops, width, out);
        if (ring == o.rings) break;
        loops = inset(loops, width);
    }
    return out;
}

} // namespace filum::fill
