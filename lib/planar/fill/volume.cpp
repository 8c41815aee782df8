#include "fill/volume.hpp"

#include <algorithm>
#include <cmath>

namespace filum::fill {

namespace {

// The area in mm2 that a bead covers: its width times its length.
double covered(const toolpath::Curve& c) {
    double out = 0;
    const std::size_t n = c.points.size();
    for (std::size_t i = 0; i + (c.closed ? 0 : 1) < n; ++i) {
        const std::size_t j = i + 1 < n ? i + 1 : 0;
        out += geom::distance(c.points[i], c.points[j]) * (c.width_at(i) + c.width_at(j)) / 2;
    }
    return out;
}

} // namespace

void make_exact(toolpath::RegionPaths& paths, Notes& notes) {
    double beads = 0; // mm2
    for (const toolpath::Curve& curve : paths.curves) beads += covered(curve);
    if (beads <= 0 || paths.area <= 0) return;
    const double wanted = paths.area / beads;
    const double factor = std::clamp(wanted, 1 - kMostChange, 1 + kMostChange);
    for (toolpath::Curve& curve : paths.curves)
        for (double& width : curve.width) width *= factor;
    if (factor == wanted) return;
    const geom::Vec2 at = paths.curves.front().points.front();
    const double rest = paths.area - factor * beads; // mm2
    const NoteCode code = rest > 0 ? NoteCode::area_unreached : NoteCode::area_doubled;
    notes.push_back({code, std::abs(rest), 1, paths.layer, at.x, at.y});
}

} // namespace filum::fill
