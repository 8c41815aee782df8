#include "fill/fill.hpp"

#include "base/error.hpp"
#include "fill/spiral.hpp"

namespace filum::fill {

toolpath::RegionPaths fill(const polygon::Region& r, const Options& o, Notes& notes) {
    toolpath::RegionPaths out;
    out.region = r.id, out.layer = r.layer, out.z = r.z, out.height = r.height, out.area = r.area;
    out.stroke = r.stroke, out.join = r.join;
    const std::size_t before = notes.size();
    if (o.pattern == "spiral") {
        Spiral s = spiral(r.loops, {.bead_width = o.bead_width, .min_width = o.min_width}, notes);
        out.curves = std::move(s.curves), out.unplaced = s.unplaced;
    } else {
        throw Error(Exit::usage, "unknown pattern '" + o.pattern + "'");
    }
    for (std::size_t i = before; i < notes.size(); ++i) notes[i].layer = r.layer;
    return out;
}

} // namespace filum::fill
