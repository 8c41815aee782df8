#include "surface/curve/locate.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace filum::surface::curve {

namespace {

constexpr std::uint32_t kLeaf = 4;

double axis(const Vec3& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }

double outside(double lo, double hi, double v) { return std::max({0.0, lo - v, v - hi}); }

} // namespace

Locator::Locator(const Surface& surface) : surface_(surface), order_(surface.triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    std::vector<Vec3> middle;
    middle.reserve(order_.size());
    for (const auto& [a, b, c] : surface.triangles)
        middle.push_back(1.0 / 3 * (surface.vertices[a] + surface.vertices[b] + surface.vertices[c]));
    nodes_.push_back({{}, {}, 0, static_cast<std::uint32_t>(order_.size())});
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) split(n, middle);
}

// Finds the box of a node, and halves its triangles along the longest side of that of their middles.
void Locator::split(std::uint32_t node, std::span<const Vec3> middle) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Vec3 lo{far, far, far}, hi{-far, -far, -far}, mlo = lo, mhi = hi;
    const auto extend = [](Vec3& low, Vec3& high, const Vec3& v) {
        low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
        high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    };
    const std::uint32_t first = nodes_[node].first, count = nodes_[node].count;
    for (std::uint32_t i = first; i < first + count; ++i) {
        for (const auto v : surface_.triangles[order_[i]]) extend(lo, hi, surface_.vertices[v]);
        extend(mlo, mhi, middle[order_[i]]);
    }
    nodes_[node].lo = lo, nodes_[node].hi = hi;
    if (count <= kLeaf) return;
    const Vec3 size = mhi - mlo;
    const int k = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto begin = order_.begin() + first, half = begin + count / 2;
    std::nth_element(begin, half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        const double va = axis(middle[a], k), vb = axis(middle[b], k);
        return va != vb ? va < vb : a < b;
    });
    nodes_[node].first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].count = 0;
    nodes_.push_back({{}, {}, first, count / 2});
    nodes_.push_back({{}, {}, first + count / 2, count - count / 2});
}

void Locator::search(const Vec3& p, const Vec3* normal, double& least, Place& best) const {
    const auto away = [&](const Node& n) {
        const double x = outside(n.lo.x, n.hi.x, p.x), y = outside(n.lo.y, n.hi.y, p.y),
                     z = outside(n.lo.z, n.hi.z, p.z);
        return std::sqrt(x * x + y * y + z * z);
    };
    std::uint32_t stack[64], depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const Node& n = nodes_[stack[--depth]];
        if (away(n) > least) continue;
        for (std::uint32_t i = n.first; i < n.first + n.count; ++i) {
            const std::uint32_t t = order_[i];
            if (normal && !(dot(surface::normal(surface_, t), *normal) > 0)) continue;
            const Vec3 q = surface::nearest_in(surface_, t, p);
            const double d = distance(p, q);
            if (d < least || (d == least && t < best.triangle)) least = d, best = {t, q};
        }
        if (n.count > 0) continue;
        const bool second = away(nodes_[n.first + 1]) < away(nodes_[n.first]);
        stack[depth++] = n.first + (second ? 0 : 1);
        stack[depth++] = n.first + (second ? 1 : 0);
    }
}

Place Locator::nearest(const Vec3& p) const {
    Place best{kNone, {}};
    double least = std::numeric_limits<double>::infinity();
    search(p, nullptr, least, best);
    return best;
}

Place Locator::nearest(const Vec3& p, const Vec3& normal) const {
    Place best{kNone, {}};
    double least = std::numeric_limits<double>::infinity();
    search(p, &normal, least, best);
    return best;
}

} // namespace filum::surface::curve
