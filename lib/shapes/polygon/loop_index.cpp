#include "polygon/loop_index.hpp"

#include <algorithm>
#include <utility>

namespace filum::polygon {

namespace {

geom::Box3 flat(const Box2& box) { return {{box.lo.x, box.lo.y, 0}, {box.hi.x, box.hi.y, 0}}; }

std::vector<geom::Box3> boxes(const Loops& loops) {
    std::vector<geom::Box3> out;
    out.reserve(loops.size());
    for (std::size_t i = 0; i < loops.size(); ++i) out.push_back(flat(bounds(loops[i])));
    return out;
}

} // namespace

LoopIndex::LoopIndex(Loops loops) : loops_(std::move(loops)), boxes_(boxes(loops_)) {}

Loops LoopIndex::near(const Box2& box) const {
    std::vector<std::uint32_t> found;
    boxes_.visit(flat(box), [&](std::uint32_t i) { found.push_back(i); });
    if (found.size() == loops_.size()) return loops_;
    std::sort(found.begin(), found.end());
    Loops out;
    for (const std::uint32_t i : found) out.add(loops_[i]);
    return out;
}

} // namespace filum::polygon
