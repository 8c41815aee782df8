#include "regions/regions.hpp"

#include "regions/inradius.hpp"
#include "regions/outlines.hpp"
#include "regions/overlaps.hpp"

#include <utility>

namespace filum::regions {

std::vector<polygon::Region> regions(const polygon::Layer& layer, const Options& options, Notes& notes) {
    const std::size_t said = notes.size();
    const double thin = hairline(options);
    auto parts = outlines(layer.contours, options.tolerance, thin, notes, static_cast<int>(layer.index));
    std::vector<polygon::Region> out;
    std::vector<std::int64_t> id(parts.part.size(), -1);
    std::vector<std::size_t> part_of;
    for (std::size_t i = 0; i < parts.part.size(); ++i) {
        polygon::Region r;
        r.loops = std::move(parts.part[i]);
        r.area = polygon::signed_area(r.loops);
        r.inradius = inradius_bound(r.loops, options.bead_width / 2, thin / 2);
        if (r.inradius <= 0) {
            const auto at = r.loops.points.front();
            notes.push_back({NoteCode::sliver_dropped, r.area, 1, -1, at.x, at.y});
            continue;
        }
        r.id = static_cast<std::uint32_t>(out.size());
        r.layer = layer.index;
        r.z = layer.z;
        r.height = layer.height;
        r.box = polygon::bounds(r.loops[0]);
        id[i] = r.id;
        part_of.push_back(i);
        out.push_back(std::move(r));
    }
    for (std::size_t k = 0; k < out.size(); ++k) {
        int around = parts.parent[part_of[k]]; // becomes the nearest surrounding part that was kept
        while (around >= 0 && id[static_cast<std::size_t>(around)] < 0)
            around = parts.parent[static_cast<std::size_t>(around)];
        out[k].parent = around < 0 ? -1 : id[static_cast<std::size_t>(around)];
    }
    for (std::size_t k = said; k < notes.size(); ++k) notes[k].layer = layer.index;
    return out;
}

void lay_on(std::span<polygon::Region> upper, const Ground& below, const Options& options, Air& air) {
    const double thin = hairline(options);
    const auto covered = overlap(upper, below.regions, options.bead_width, thin);
    if (!below.bed) hang(upper, below.regions, covered, {options.bead_width, thin}, air);
}

} // namespace filum::regions
