#include "baselines/sun2019/order.hpp"

#include "sequence/outline.hpp"

#include <algorithm>
#include <tuple>

namespace filum::baselines::sun2019 {

using sequence::Index;
using sequence::Outline;

sequence::Order order(std::span<const polygon::Region> regions) {
    sequence::Order out;
    Outline last;
    for (std::size_t first = 0, end = 0; first < regions.size(); first = end) {
        while (end < regions.size() && regions[end].layer == regions[first].layer) ++end;
        struct PendingRegion {
            Index id;
            Outline outline;
        };
        std::vector<PendingRegion> left;
        for (std::size_t i = first; i < end; ++i)
            left.push_back({static_cast<Index>(i), sequence::outline(regions[i].loops)});
        while (!left.empty()) {
            const auto rank = [&](const PendingRegion& l) { // the lowest comes next
                const double away = out.empty() ? 0 : distance(last, l.outline);
                return std::tuple(away, -regions[l.id].area, l.id);
            };
            std::size_t next = 0;
            auto best = rank(left[0]);
            for (std::size_t i = 1; i < left.size(); ++i)
                if (const auto r = rank(left[i]); r < best) {
                    best = r;
                    next = i;
                }
            out.push_back(left[next].id);
            last = std::move(left[next].outline);
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(next));
        }
    }
    return out;
}

} // namespace filum::baselines::sun2019
