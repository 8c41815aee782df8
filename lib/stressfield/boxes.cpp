#include "stressfield/boxes.hpp"

#include <numeric>

namespace filum::stressfield {

namespace {

constexpr std::uint32_t kLeaf = 4;

double middle(const Box3& b, int axis) {
    if (axis == 0) return b.lo.x + b.hi.x;
    return axis == 1 ? b.lo.y + b.hi.y : b.lo.z + b.hi.z;
}

int widest(const Box3& b) {
    const Vec3 size = b.hi - b.lo;
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
}

} // namespace

BoxTree::BoxTree(const std::vector<Box3>& boxes) : order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    if (boxes.empty()) return;
    nodes_.reserve(boxes.size());
    build(boxes, 0, static_cast<std::uint32_t>(boxes.size()));
    boxes_.reserve(boxes.size());
    for (const auto i : order_) boxes_.push_back(boxes[i]);
}

std::uint32_t BoxTree::build(const std::vector<Box3>& boxes, std::uint32_t first, std::uint32_t count) {
    const auto self = static_cast<std::uint32_t>(nodes_.size());
    Node node{{}, first, count};
    Box3 middles;
    for (std::uint32_t k = first; k < first + count; ++k) {
        const Box3& b = boxes[order_[k]];
        node.box.add(b.lo), node.box.add(b.hi);
        middles.add(0.5 * (b.lo + b.hi));
    }
    nodes_.push_back(node);
    if (count <= kLeaf) return self;
    const int axis = widest(middles);
    const auto begin = order_.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        const double ma = middle(boxes[a], axis), mb = middle(boxes[b], axis);
        return ma < mb || (ma == mb && a < b);
    });
    build(boxes, first, count / 2);
    const std::uint32_t second = build(boxes, first + count / 2, count - count / 2);
    nodes_[self].first = second, nodes_[self].count = 0;
    return self;
}

} // namespace filum::stressfield
