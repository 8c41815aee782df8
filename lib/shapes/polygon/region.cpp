#include "polygon/region.hpp"

namespace filum::polygon {

std::vector<Loops> materials(std::span<const Region> regions, std::optional<RegionClass> only) {
    std::vector<Loops> out;
    for (const Region& r : regions) {
        if (r.layer >= out.size()) out.resize(r.layer + 1);
        if (only && r.is != *only) continue;
        for (std::int64_t k = r.rests_on() + 1; k <= r.layer; ++k) out[static_cast<std::size_t>(k)].add(r.loops);
    }
    return out;
}

} // namespace filum::polygon
