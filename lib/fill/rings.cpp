#include "fill/rings.hpp"

#include "polygon/clip.hpp"

namespace filum::fill {

Rings nested_rings(const Loops& first, double spacing, double min_length, double tolerance) {
    Rings out;
    Loops now = first;
    for (int level = 0; !now.empty(); ++level) {
        for (std::size_t i = 0; i < now.size(); ++i) {
            if (level > 0 && polygon::perimeter(now[i]) < min_length) continue;
            out.loops.add(now[i]);
            out.level.push_back(level);
        }
        now = polygon::simplify(polygon::offset(now, -spacing, tolerance), tolerance);
    }
    return out;
}

} // namespace filum::fill
