#include "baselines/kipping2022/cloud.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace filum::baselines::kipping2022 {

namespace {

constexpr std::uint32_t kLeaf = 8;

double axis(const Vec3& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }

} // namespace

Cloud::Cloud(Points points) : points_(std::move(points)), order_(points_.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    nodes_.push_back({{}, {}, 0, static_cast<std::uint32_t>(order_.size())});
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) split(n);
}

// Finds the box of a node, and halves its points along the longest side.
void Cloud::split(std::uint32_t node) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Vec3 lo{far, far, far}, hi{-far, -far, -far};
    const std::uint32_t first = nodes_[node].first, count = nodes_[node].count;
    for (std::uint32_t i = first; i < first + count; ++i) {
        const Vec3& p = points_[order_[i]];
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }
    nodes_[node].lo = lo, nodes_[node].hi = hi;
    if (count <= kLeaf) return;
    const Vec3 size = hi - lo;
    const int k = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto begin = order_.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        const double va = axis(points_[a], k), vb = axis(points_[b], k);
        return va != vb ? va < vb : a < b;
    });
    nodes_[node].first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].count = 0;
    nodes_.push_back({{}, {}, first, count / 2});
    nodes_.push_back({{}, {}, first + count / 2, count - count / 2});
}

double Cloud::away(const Node& n, const Vec3& p) {
    const double x = std::max({0.0, n.lo.x - p.x, p.x - n.hi.x}), y = std::max({0.0, n.lo.y - p.y, p.y - n.hi.y}),
                 z = std::max({0.0, n.lo.z - p.z, p.z - n.hi.z});
    return std::sqrt(x * x + y * y + z * z);
}

Cloud::Found Cloud::nearest(const Vec3& p, double reach) const {
    Found best{surface::kNone, reach};
    std::uint32_t stack[64], depth = 0;
    if (!points_.empty()) stack[depth++] = 0;
    while (depth > 0) {
        const Node& n = nodes_[stack[--depth]];
        if (away(n, p) > best.distance) continue;
        for (std::uint32_t i = n.first; i < n.first + n.count; ++i) {
            const double d = distance(points_[order_[i]], p);
            if (d < best.distance || (d == best.distance && order_[i] < best.index)) best = {order_[i], d};
        }
        if (n.count > 0) continue;
        const bool second = away(nodes_[n.first + 1], p) < away(nodes_[n.first], p);
        stack[depth++] = n.first + (second ? 0 : 1);
        stack[depth++] = n.first + (second ? 1 : 0);
    }
    if (best.index == surface::kNone) return {};
    return best;
}

} // namespace filum::baselines::kipping2022
