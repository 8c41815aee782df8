#include "polygon/region.hpp"

namespace filum::polygon {

std::vector<Loops> materials(std::span<const Region> regions, std::optional<RegionClass> only) {
    std::vector<Loops> out;
    for (const Region& r : regions) {
        if (r.layer >= out.size()) out.resize(r.layer + 1);
        if (!only || r.is == *only) out[r.layer].add(r.loops);
    }
    return out;
}

} // namespace filum::polygon
