#include "surfpath/rings/ring.hpp"

#include "surface/curve/nearest.hpp"

#include <algorithm>

namespace filum::surfpath::rings {

namespace {

std::vector<Vec3> points_of(std::span<const Ring> rings) {
    std::vector<Vec3> out;
    for (const Ring& ring : rings)
        for (const Place& p : ring.line.places) out.push_back(p.point);
    return out;
}

} // namespace

RingTree::RingTree(std::span<const Ring> rings) : rings_(rings), tree_(points_of(rings)) {
    for (const Ring& ring : rings) end_.push_back((end_.empty() ? 0 : end_.back()) + ring.line.size());
}

RingPosition RingTree::nearest(const Vec3& p) const {
    if (tree_.points().empty()) return {};
    const auto found = tree_.nearest(p);
    const auto r = static_cast<std::size_t>(std::upper_bound(end_.begin(), end_.end(), found.index) - end_.begin());
    const std::size_t i = found.index - (r > 0 ? end_[r - 1] : 0);
    const auto at = surface::curve::nearest_beside(rings_[r].line, rings_[r].ways, p, i);
    return {r, at.way, at.distance};
}

} // namespace filum::surfpath::rings
