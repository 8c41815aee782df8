#include "skins/zones.hpp"

#include "parallel/parallel.hpp"
#include "polygon/clip.hpp"

#include <algorithm>

namespace filum::skins {

using polygon::kBeadArc;
using polygon::Loops;

Zones::Kind Zones::kind(const Options& o) { return {o.walls, inner_width(o), solid_width(o), infill_width(o)}; }

Zones::Zones(const Options& part, std::span<const Modifier> modifiers, std::size_t layers)
    : outer_(part.bead_width), kinds_{kind(part)}, kind_of_{0}, beyond_(modifiers.empty() ? 0 : layers),
      deep_(modifiers.size(), std::vector<Loops>(layers)) {
    for (const Modifier& m : modifiers) {
        const auto same = std::ranges::find(kinds_, kind(m.how));
        kind_of_.push_back(static_cast<std::size_t>(same - kinds_.begin()));
        if (same == kinds_.end()) kinds_.push_back(kind(m.how));
    }
    inside_.assign(kinds_.size(), std::vector<Loops>(layers));
    parallel::for_chunks(beyond_.size(), 1, 0, [&](std::size_t i, std::size_t) {
        Loops taken, apart; // areas of later modifiers; areas of modifiers of the part's kind
        for (std::size_t k = modifiers.size(); k-- > 0;) {
            if (i >= modifiers[k].where.size() || modifiers[k].where[i].empty()) continue;
            const std::size_t kind = kind_of_[k + 1];
            const Loops zone = polygon::simplify(modifiers[k].where[i], kBeadArc);
            const Loops own = polygon::subtract(zone, taken);
            deep_[k][i] = kind == 0 ? polygon::offset(own, -part.bead_width, kBeadArc) : own;
            if (kind == 0) apart = polygon::unite(apart, own);
            if (kind > 0) inside_[kind][i] = polygon::unite(inside_[kind][i], own);
            taken = polygon::unite(taken, zone);
        }
        beyond_[i] = polygon::offset(apart, part.bead_width, kBeadArc);
        for (std::size_t kind = 1; kind < kinds_.size(); ++kind)
            beyond_[i] = polygon::unite(beyond_[i], inside_[kind][i]);
    });
}

bool Zones::widths_differ() const {
    return std::ranges::any_of(kinds_, [&](const Kind& k) { return has_own_width(k); });
}

RegionZones Zones::cut(const polygon::Region& region) const {
    RegionZones out;
    out.walls = static_cast<std::uint32_t>(kinds_[0].walls);
    const bool own = region.width > 0; // its beads have one width throughout
    if (kinds_.size() == 1 && (own || !has_own_width(kinds_[0]))) return out;
    const Loops outline = polygon::simplify(region.loops, kBeadArc);
    const auto put = [&](std::size_t kind, const Loops& where) {
        if (polygon::opened(where, kinds_[kind].width / 2, kBeadArc).empty()) return;
        polygon::Area zone{polygon::AreaKind::zone, where, 0, 0, {}};
        zone.walls = static_cast<std::uint32_t>(kinds_[kind].walls);
        zone.width = own ? region.width : kinds_[kind].width;
        zone.solid = own ? 0 : kinds_[kind].solid == zone.width ? 0 : kinds_[kind].solid;
        out.zones.push_back(std::move(zone));
        out.kind.push_back(kind);
    };
    Loops others;
    for (std::size_t kind = 1; kind < kinds_.size(); ++kind) {
        const Loops& inside = inside_[kind][region.layer];
        if (inside.empty()) continue;
        if (own && kinds_[kind].width != kinds_[0].width && kinds_[kind].width != region.width)
            out.idle_width.add(polygon::intersect(outline, inside));
        put(kind, polygon::intersect(outline, inside));
        others = polygon::unite(others, inside);
    }
    if (out.zones.empty() && (own || !has_own_width(kinds_[0]))) return out;
    put(0, polygon::subtract(outline, others));
    if (out.zones.empty()) return out;
    const double outer = own ? region.width : outer_;
    const bool apart = std::ranges::any_of(out.zones, [&](const auto& z) { return z.width != outer; });
    out.mixed = apart || std::ranges::any_of(out.zones, [](const auto& z) { return z.solid > 0; });
    out.walls = apart ? 1 : std::ranges::min_element(out.zones, {}, &polygon::Area::walls)->walls;
    for (std::size_t k = out.zones.size(); k-- > 0;) {
        polygon::Area& zone = out.zones[k];
        zone.walls -= out.walls;
        if (zone.walls > 0 || zone.width != outer || zone.solid > 0) continue;
        out.zones.erase(out.zones.begin() + static_cast<std::ptrdiff_t>(k));
        out.kind.erase(out.kind.begin() + static_cast<std::ptrdiff_t>(k));
    }
    return out;
}

Loops Zones::of(std::size_t setting, const polygon::Region& region, const RegionZones& cut, const Loops& area) const {
    Loops out = area;
    if (setting > 0)
        out = polygon::intersect(out, deep_[setting - 1][region.layer]);
    else if (!beyond_.empty() && !beyond_[region.layer].empty())
        out = polygon::subtract(out, beyond_[region.layer]);
    for (std::size_t k = 0; k < cut.zones.size() && !out.empty(); ++k)
        if (const polygon::Area& zone = cut.zones[k]; cut.kind[k] == kind_of_[setting])
            out = polygon::intersect(out, polygon::offset(zone.loops, -(zone.walls * zone.width), kBeadArc));
    return out;
}

} // namespace filum::skins
