#include "fill/fill.hpp"

#include "polygon/clip.hpp"

namespace filum::fill {

toolpath::RegionPaths fill(const polygon::Region& r, const Options& options, Notes&) {
    toolpath::RegionPaths out;
    out.region = r.id, out.layer = r.layer, out.z = r.z, out.height = r.height, out.area = r.area;
    out.stroke = r.stroke, out.join = r.join;
    auto loops = polygon::offset(r.loops, -options.bead_width / 2);
    while (!loops.empty()) {
        loops = polygon::simplify(loops, 0.001);
        for (std::size_t i = 0; i < loops.size(); ++i)
            out.curves.push_back({true, {loops[i].begin(), loops[i].end()}, {options.bead_width}});
        loops = polygon::offset(loops, -options.bead_width);
    }
    return out;
}

} // namespace filum::fill
