#include "geom/nearest_points.hpp"

#include <algorithm>
#include <numeric>

namespace filum::geom {

namespace {

constexpr std::uint32_t kLeafPoints = 8;

int longest_axis(Vec2 size) { return size.x >= size.y ? 0 : 1; }
double coordinate(Vec2 p, int axis) { return axis == 0 ? p.x : p.y; }

// Squared distance from the box to p; 0 inside.
double off(const Box2& b, Vec2 p) { return distance2(b, p); }
double off(const Box3& b, Vec3 p) {
    return norm2(Vec3{std::max({0.0, b.lo.x - p.x, p.x - b.hi.x}), std::max({0.0, b.lo.y - p.y, p.y - b.hi.y}),
                      std::max({0.0, b.lo.z - p.z, p.z - b.hi.z})});
}

} // namespace

template <class V>
NearestPoints<V>::NearestPoints(std::vector<V> points)
    : points_(std::move(points)), order_(points_.size()), leaf_(points_.size()), present_(points_.size(), 0) {
    if (points_.empty()) return;
    std::iota(order_.begin(), order_.end(), 0U);
    nodes_.push_back({{}, 0, static_cast<std::uint32_t>(points_.size())});
    for (std::uint32_t k = 0; k < nodes_.size(); ++k) split(k);
}

// Halves a node across its longest side, or makes it a leaf.
template <class V>
void NearestPoints<V>::split(std::uint32_t node) {
    Node n = nodes_[node];
    for (std::uint32_t k = n.first; k < n.last; ++k) n.box.add(points_[order_[k]]);
    if (n.last - n.first <= kLeafPoints) {
        for (std::uint32_t k = n.first; k < n.last; ++k) leaf_[order_[k]] = node;
        nodes_[node] = n;
        return;
    }
    const int axis = longest_axis(n.box.hi - n.box.lo);
    const std::uint32_t middle = n.first + (n.last - n.first) / 2;
    std::nth_element(order_.begin() + n.first, order_.begin() + middle, order_.begin() + n.last,
                     [&](std::uint32_t a, std::uint32_t b) {
                         const double p = coordinate(points_[a], axis), q = coordinate(points_[b], axis);
                         return p < q || (p == q && a < b);
                     });
    n.below = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node] = n;
    nodes_.push_back({{}, n.first, middle, 0, node});
    nodes_.push_back({{}, middle, n.last, 0, node});
}

template <class V>
void NearestPoints<V>::count(std::uint32_t i, std::uint32_t change) {
    for (std::uint32_t n = leaf_[i];; n = nodes_[n].above) {
        nodes_[n].present += change;
        if (n == 0) return;
    }
}

template <class V>
void NearestPoints<V>::insert(std::uint32_t i) {
    present_[i] = 1;
    count(i, 1);
}

template <class V>
void NearestPoints<V>::remove(std::uint32_t i) {
    present_[i] = 0;
    count(i, ~0U); // adds -1
}

template <class V>
std::optional<std::uint32_t> NearestPoints<V>::nearest(V p) const {
    if (empty()) return std::nullopt;
    double best = std::numeric_limits<double>::infinity();
    std::uint32_t found = 0;
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
        const Node& n = nodes_[open.back()];
        open.pop_back();
        if (n.present == 0 || off(n.box, p) > best) continue;
        if (n.below == 0) {
            for (std::uint32_t k = n.first; k < n.last; ++k) {
                const std::uint32_t i = order_[k];
                if (present_[i] == 0) continue;
                const double d = norm2(points_[i] - p);
                if (d < best || (d == best && i < found)) {
                    best = d;
                    found = i;
                }
            }
            continue;
        }
        const bool left = off(nodes_[n.below].box, p) <= off(nodes_[n.below + 1].box, p);
        open.push_back(n.below + (left ? 1 : 0));
        open.push_back(n.below + (left ? 0 : 1)); // the nearer child is visited first
    }
    return found;
}

template class NearestPoints<Vec2>;
template class NearestPoints<Vec3>;

} // namespace filum::geom
