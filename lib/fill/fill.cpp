#include "fill/fill.hpp"

#include "fill/cycle.hpp"
#include "fill/thin.hpp"
#include "polygon/clip.hpp"

namespace filum::fill {

toolpath::RegionPaths fill(const polygon::Region& r, const Options& options, Notes&) {
    toolpath::RegionPaths out;
    out.region = r.id, out.layer = r.layer, out.z = r.z, out.height = r.height, out.area = r.area;
    out.stroke = r.stroke, out.join = r.join;
    const double w = options.bead_width;
    const auto first = first_rings(r.loops, w, 0.003);
    out.unplaced = first.unplaced;
    const auto rings = nested_rings(first.rings, w * (1 - 1.0 / 512), 1.3 * w, 0.003);
    const auto beads = even_spacing(rings, r.loops, w, 2, 0.003);
    for (auto& line : join_rings(beads, w)) out.curves.push_back({true, std::move(line.points), std::move(line.width)});
    return out;
}

} // namespace filum::fill
