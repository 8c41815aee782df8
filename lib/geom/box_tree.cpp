#include "geom/box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace filum::geom {

namespace {

constexpr std::uint32_t kLeaf = 4;

double axis(const Vec3& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }

void extend(Box3& box, const Box3& by) {
    box.lo = {std::min(box.lo.x, by.lo.x), std::min(box.lo.y, by.lo.y), std::min(box.lo.z, by.lo.z)};
    box.hi = {std::max(box.hi.x, by.hi.x), std::max(box.hi.y, by.hi.y), std::max(box.hi.z, by.hi.z)};
}

} // namespace

BoxTree::BoxTree(std::vector<Box3> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    if (order_.empty()) return;
    nodes_.push_back({{}, 0, static_cast<std::uint32_t>(order_.size())});
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) split(n);
}

// Finds the box of a node, and halves its boxes along the axis in which their middles lie farthest apart.
void BoxTree::split(std::uint32_t node) {
    const std::uint32_t first = nodes_[node].first, count = nodes_[node].count;
    const auto middle = [&](std::uint32_t i) { return 0.5 * (boxes_[i].lo + boxes_[i].hi); };
    Box3 all = boxes_[order_[first]], middles{middle(order_[first]), middle(order_[first])};
    for (std::uint32_t i = first + 1; i < first + count; ++i) {
        extend(all, boxes_[order_[i]]);
        extend(middles, {middle(order_[i]), middle(order_[i])});
    }
    nodes_[node].box = all;
    if (count <= kLeaf) return;
    const Vec3 size = middles.hi - middles.lo;
    const int k = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto begin = order_.begin() + first, half = begin + count / 2;
    std::nth_element(begin, half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        const double va = axis(middle(a), k), vb = axis(middle(b), k);
        return va != vb ? va < vb : a < b;
    });
    nodes_[node].first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].count = 0;
    nodes_.push_back({{}, first, count / 2});
    nodes_.push_back({{}, first + count / 2, count - count / 2});
}

} // namespace filum::geom
