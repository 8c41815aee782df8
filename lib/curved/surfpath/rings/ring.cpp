#include "surfpath/rings/ring.hpp"

#include <algorithm>

namespace filum::surfpath::rings {

namespace {

constexpr double kSoughtBeside = 0.5; // mm on both sides of the nearest point
constexpr int kSoughtSteps = 100;     // steps on either side

// Refines a position by sampling the ring on both sides of it.
RingPosition refined(std::span<const Ring> rings, RingPosition out, const Vec3& p) {
    const Ring& ring = rings[out.line];
    const double all = ring.ways.back(), from = out.way;
    for (int i = -kSoughtSteps; i <= kSoughtSteps; ++i) {
        const double way = from + kSoughtBeside * i / kSoughtSteps;
        const double d = distance(surface::curve::at(ring.line, ring.ways, way).point, p);
        if (d < out.distance) {
            out.distance = d;
            out.way = std::fmod(way + all, all);
        }
    }
    return out;
}

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
    return refined(rings_, {r, rings_[r].ways[i], found.distance}, p);
}

} // namespace filum::surfpath::rings
