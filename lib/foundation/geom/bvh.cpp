#include "geom/bvh.hpp"

#include <algorithm>

namespace filum::geom {

namespace {

constexpr std::uint32_t kLeaf = 4; // most boxes of a leaf, which are tested one by one

} // namespace

Bvh::Bvh(const std::vector<Box3>& boxes) {
    if (boxes.empty()) return;
    std::vector<Middle> middles(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) middles[i] = {0.5 * (boxes[i].lo + boxes[i].hi), i};
    nodes_.push_back({{}, 0, static_cast<std::uint32_t>(boxes.size())});
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) split(n, middles);
    order_.reserve(boxes.size());
    boxes_.reserve(boxes.size());
    for (const Middle& m : middles) {
        order_.push_back(m.box);
        boxes_.push_back(boxes[m.box]);
    }
    for (auto n = nodes_.rbegin(); n != nodes_.rend(); ++n) { // children come after their parents
        for (std::uint32_t k = n->first; k < n->first + n->count; ++k) n->box.add(boxes_[k]);
        if (n->count > 0) continue;
        n->box.add(nodes_[n->first].box);
        n->box.add(nodes_[n->first + 1].box);
    }
}

// Halves a node whose boxes have the middles [first, first + count).
void Bvh::split(std::uint32_t node, std::vector<Middle>& middles) {
    const std::uint32_t first = nodes_[node].first, count = nodes_[node].count;
    if (count <= kLeaf) return;
    const auto begin = middles.begin() + first, end = begin + count;
    Box3 all;
    for (auto m = begin; m != end; ++m) all.add(m->at);
    const int axis = longest_axis(all.size());
    std::nth_element(begin, begin + count / 2, end, [axis](const Middle& a, const Middle& b) {
        const double x = coordinate(a.at, axis), y = coordinate(b.at, axis);
        return x != y ? x < y : a.box < b.box;
    });
    nodes_[node].first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].count = 0;
    nodes_.push_back({{}, first, count / 2});
    nodes_.push_back({{}, first + count / 2, count - count / 2});
}

} // namespace filum::geom
