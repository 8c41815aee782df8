#include "metrics/surface/tight.hpp"

#include "surface/curve/turns.hpp"

#include <algorithm>
#include <limits>

namespace filum::metrics::surface {

TightLength tight(const Fibres& fibres, std::span<const std::vector<Vec3>> normals, double radius, double spacing) {
    namespace curve = filum::surface::curve;
    const double reach = curve::turn_reach(radius, spacing);
    TightLength out;
    out.least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < fibres.all.size(); ++k) {
        const Fibre& c = fibres.all[k];
        out.least = std::min(out.least, curve::least_radius(c.points, normals[k], reach));
        for (const auto& t : curve::tight_turns(c.points, normals[k], radius, reach)) {
            std::size_t stretch = 0;
            if (t.radius <= out.least) out.tightest = point_at(c, t.at, stretch);
            ++out.count;
            out.length += t.to - t.from;
        }
    }
    return out;
}

} // namespace filum::metrics::surface
