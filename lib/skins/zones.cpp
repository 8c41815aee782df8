#include "skins/zones.hpp"

#include "parallel/parallel.hpp"
#include "polygon/clip.hpp"

namespace filum::skins {

using polygon::kBeadArc;
using polygon::Loops;

Zones::Zones(std::span<const Modifier> modifiers, std::size_t layers, double apart)
    : beyond_(modifiers.empty() ? 0 : layers), deep_(modifiers.size(), std::vector<Loops>(layers)) {
    parallel::for_chunks(beyond_.size(), 1, 0, [&](std::size_t i, std::size_t) {
        Loops taken; // by later modifiers
        for (std::size_t k = modifiers.size(); k-- > 0;) {
            if (i >= modifiers[k].where.size() || modifiers[k].where[i].empty()) continue;
            const Loops zone = polygon::simplify(modifiers[k].where[i], kBeadArc);
            deep_[k][i] = polygon::offset(polygon::subtract(zone, taken), -apart, kBeadArc);
            taken = polygon::unite(taken, zone);
        }
        beyond_[i] = polygon::offset(taken, apart, kBeadArc);
    });
}

Loops Zones::of(std::size_t setting, std::uint32_t layer, const Loops& area) const {
    if (setting > 0) return polygon::intersect(area, deep_[setting - 1][layer]);
    if (beyond_.empty() || beyond_[layer].empty()) return area;
    return polygon::subtract(area, beyond_[layer]);
}

} // namespace filum::skins
