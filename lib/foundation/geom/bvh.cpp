#include "geom/bvh.hpp"

#include <algorithm>
#include <numeric>

namespace filum::geom {

namespace {

constexpr std::uint32_t kLeaf = 4; // most boxes of a leaf, which are tested one by one

} // namespace

Bvh::Bvh(const std::vector<Box3>& boxes) : order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    if (order_.empty()) return;
    nodes_.push_back({{}, 0, static_cast<std::uint32_t>(order_.size())});
    std::vector<Middle> room(order_.size());
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) split(boxes, n, room);
    boxes_.reserve(boxes.size());
    for (const std::uint32_t i : order_) boxes_.push_back(boxes[i]);
}

// Halves a node. `room` is scratch space for the middles, which sorting needs many times.
void Bvh::split(const std::vector<Box3>& boxes, std::uint32_t node, std::vector<Middle>& room) {
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
    for (std::uint32_t k = 0; k < count; ++k)
        room[k] = {coordinate(middle(order_[first + k]), axis), order_[first + k]};
    const auto begin = room.begin(), end = begin + count;
    std::nth_element(begin, begin + count / 2, end,
                     [](const Middle& a, const Middle& b) { return a.at != b.at ? a.at < b.at : a.box < b.box; });
    for (std::uint32_t k = 0; k < count; ++k) order_[first + k] = room[k].box;
    nodes_[node].first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].count = 0;
    nodes_.push_back({{}, first, count / 2});
    nodes_.push_back({{}, first + count / 2, count - count / 2});
}

} // namespace filum::geom
