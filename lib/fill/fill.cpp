#include "fill/fill.hpp"

#include "base/error.hpp"
#include "fill/contour.hpp"
#include "fill/rectilinear.hpp"
#include "fill/ringed_zigzag.hpp"
#include "fill/spiral.hpp"
#include "fill/sun2019.hpp"
#include "fill/zigzag.hpp"

#include <numbers>

namespace filum::fill {

namespace {

double angle(const polygon::Region& r, const Options& o) {
    if (o.angles_deg.empty()) return 0;
    return o.angles_deg[r.layer % o.angles_deg.size()] * std::numbers::pi / 180;
}

int rings(const Options& o, int usual) { return o.rings < 0 ? usual : static_cast<int>(o.rings); }

std::vector<toolpath::Curve> curves(const polygon::Region& r, const Options& o, double& unplaced, Notes& notes) {
    const double w = o.bead_width;
    if (o.pattern == "spiral" && o.method == "cyc") {
        const double least = o.min_width > 0 ? o.min_width : w / 4;
        Spiral s = spiral(r.loops, {.bead_width = w, .min_width = least, .min_radius = o.min_radius}, notes);
        unplaced = s.unplaced;
        return std::move(s.curves);
    }
    if (o.pattern == "spiral" && o.method == "sun2019")
        return sun2019(r.loops, {.offset = w, .threshold = o.threshold}, notes);
    if (o.pattern == "contour") return contour(r.loops, {.bead_width = w, .rings = rings(o, 0)}, notes);
    if (o.pattern == "zigzag") return zigzag(r.loops, {.bead_width = w, .angle = angle(r, o)}, notes);
    if (o.pattern == "rectilinear")
        return rectilinear(r.loops, {.bead_width = w, .angle = angle(r, o), .rings = rings(o, 0)}, notes);
    if (o.pattern == "spiral+zigzag" || o.pattern == "contour+zigzag") {
        const bool linked = o.pattern == "spiral+zigzag";
        return ringed_zigzag(r.loops, {.bead_width = w, .angle = angle(r, o), .rings = rings(o, 2), .linked = linked},
                             notes);
    }
    throw Error(Exit::usage, "cannot fill by the pattern '" + o.pattern + "' and method '" + o.method + "'");
}

} // namespace

toolpath::RegionPaths fill(const polygon::Region& r, const Options& o, Notes& notes) {
    toolpath::RegionPaths out;
    out.region = r.id, out.layer = r.layer, out.z = r.z, out.height = r.height, out.area = r.area;
    out.stroke = r.stroke, out.join = r.join;
    const std::size_t before = notes.size();
    out.curves = curves(r, o, out.unplaced, notes);
    for (std::size_t i = before; i < notes.size(); ++i) {
        notes[i].layer = r.layer;
        if (notes[i].what == "not reached by a bead") out.unplaced += notes[i].amount;
    }
    return out;
}

} // namespace filum::fill
