#include "surfpath/ring.hpp"

namespace filum::surfpath {

On nearest(const std::vector<Ring>& rings, const Vec3& p) {
    On out;
    for (std::size_t r = 0; r < rings.size(); ++r)
        for (std::size_t i = 0; i < rings[r].line.size(); ++i)
            if (const double d = distance(rings[r].line[i], p); d < out.distance) out = {r, rings[r].ways[i], d};
    if (out.distance > 1e299) return out;
    // on the stretches beside that point
    const Ring& ring = rings[out.line];
    const double reach = 0.5, all = ring.ways.back();
    const double from = out.way;
    for (int i = -100; i <= 100; ++i) {
        const double way = from + reach * i / 100;
        const double d = distance(surface::curve::at(ring.line, ring.ways, way).point, p);
        if (d < out.distance) {
            out.distance = d;
            out.way = std::fmod(way + all, all);
        }
    }
    return out;
}

} // namespace filum::surfpath
