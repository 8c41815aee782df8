#include "regions/regions.hpp"

#include "polygon/clip.hpp"

namespace filum::regions {

std::vector<polygon::Region> regions(const polygon::Layer& layer, const std::vector<polygon::Region>& below,
                                     std::uint32_t first_id, const Options& options, Notes&) {
    std::vector<polygon::Region> out;
    auto parts = polygon::split(polygon::simplify(layer.contours, 0.001));
    for (std::size_t i = 0; i < parts.part.size(); ++i) {
        polygon::Region r;
        r.id = first_id + static_cast<std::uint32_t>(i);
        r.layer = layer.index;
        r.z = layer.z;
        r.height = layer.height;
        r.loops = std::move(parts.part[i]);
        r.area = polygon::signed_area(r.loops);
        if (r.area <= 0) continue;
        r.parent = parts.parent[i] < 0 ? -1 : first_id + parts.parent[i];
        r.unsupported = r.area;
        for (const auto& b : below) {
            const auto common = polygon::intersect(r.loops, b.loops);
            const double area = polygon::signed_area(common);
            if (area <= 0) continue;
            const bool wide = !polygon::offset(common, -options.bead_width / 2).empty();
            r.below.push_back({b.id, area, wide ? options.bead_width / 2 : 0});
            r.unsupported = std::max(0.0, r.unsupported - area);
        }
        out.push_back(std::move(r));
    }
    return out;
}

} // namespace filum::regions
