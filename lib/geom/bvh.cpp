#include "geom/bvh.hpp"

#include <algorithm>
#include <numeric>

namespace filum::geom {

namespace {

constexpr std::uint32_t kLeaf = 4; // boxes, few enough to look at one by one

} // namespace

Bvh::Bvh(const std::vector<Box3>& boxes) : order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    if (order_.empty()) return;
    nodes_.push_back({{}, 0, static_cast<std::uint32_t>(order_.size())});
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) split(boxes, n);
    boxes_.reserve(boxes.size());
    for (const std::uint32_t i : order_) boxes_.push_back(boxes[i]);
}

void Bvh::split(const std::vector<Box3>& boxes, std::uint32_t node) {
    const std::uint32_t first = nodes_[node].first, count = nodes_[node].count;
    const auto middle = [&](std::uint32_t i) { return 0.5 * (boxes[i].lo + boxes[i].hi); };
    Box3 all, middles;
    for (std::uint32_t k = first; k < first + count; ++k) {
        all.add(boxes[order_[k]]);
        middles.add(middle(order_[k]));
    }
    nodes_[node].box = all;
    if (count <= kLeaf) return;
    const int axis = longest_axis(middles.size());
    const auto begin = order_.begin() + first, half = begin + count / 2;
    std::nth_element(begin, half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        const double ma = coordinate(middle(a), axis), mb = coordinate(middle(b), axis);
        return ma != mb ? ma < mb : a < b;
    });
    nodes_[node].first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].count = 0;
    nodes_.push_back({{}, first, count / 2});
    nodes_.push_back({{}, first + count / 2, count - count / 2});
}

} // namespace filum::geom
