#include "geom/capsule_tree.hpp"

#include "geom/segment.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

namespace filum::geom {

namespace {

constexpr std::size_t kRun = 4;    // segments per leaf
constexpr double kRounding = 1e-9; // mm; more than the rounding of a turned point

// A box with sides along x and left_of(x). It holds some segments.
struct TurnedBox {
    Vec2 x{1, 0};
    Vec2 doubled; // sum of the segments' directions at twice their angles, by length
    Box2 box;     // in the coordinates along x and left_of(x)

    void add(Vec2 p) { box.add({dot(p, x), dot(p, left_of(x))}); }
    [[nodiscard]] Vec2 point(Vec2 at) const { return at.x * x + at.y * left_of(x); }

    // Turns x, of an empty box, to the mean of the directions.
    void turn() {
        const double l = norm(doubled);
        if (!(l > 0)) return;
        const Vec2 u = (1 / l) * doubled; // the angle is halved
        const double c = std::sqrt(std::max(0.0, (1 + u.x) / 2)), s = std::sqrt(std::max(0.0, (1 - u.x) / 2));
        x = {c, u.y < 0 ? -s : s};
    }
};

TurnedBox box_of(std::span<const CapsuleTree::Segment> segments) {
    TurnedBox out;
    for (const auto& [a, b] : segments) {
        const Vec2 d = b - a;
        if (const double l = norm(d); l > 0)
            out.doubled = out.doubled + (1 / l) * Vec2{d.x * d.x - d.y * d.y, 2 * d.x * d.y};
    }
    out.turn();
    for (const auto& [a, b] : segments) {
        out.add(a);
        out.add(b);
    }
    return out;
}

TurnedBox joined(const TurnedBox& a, const TurnedBox& b) {
    TurnedBox out;
    out.doubled = a.doubled + b.doubled;
    out.turn();
    for (const TurnedBox* t : {&a, &b})
        if (!t->box.empty())
            for (const Vec2 corner :
                 {t->box.lo, t->box.hi, Vec2{t->box.lo.x, t->box.hi.y}, Vec2{t->box.hi.x, t->box.lo.y}})
                out.add(t->point(corner));
    return out;
}

// Along the longer side of the box, through its middle.
Capsule capsule(const TurnedBox& t) {
    if (t.box.empty()) return {};
    const Vec2 middle = 0.5 * (t.box.lo + t.box.hi), half = 0.5 * (t.box.hi - t.box.lo);
    const Vec2 along = half.x >= half.y ? Vec2{half.x, 0} : Vec2{0, half.y};
    return {t.point(middle - along), t.point(middle + along), std::min(half.x, half.y) + kRounding};
}

} // namespace

double distance(const Capsule& c, Vec2 p) {
    if (c.radius < 0) return std::numeric_limits<double>::infinity();
    return point_segment_distance(c.from, c.to, p) - c.radius;
}

bool may_meet(const Capsule& c, const Box2& box) {
    if (c.radius < 0) return false;
    if (std::max(c.from.x, c.to.x) + c.radius < box.lo.x || std::min(c.from.x, c.to.x) - c.radius > box.hi.x ||
        std::max(c.from.y, c.to.y) + c.radius < box.lo.y || std::min(c.from.y, c.to.y) - c.radius > box.hi.y)
        return false;
    const Vec2 way = c.to - c.from, half = 0.5 * (box.hi - box.lo), middle = 0.5 * (box.lo + box.hi);
    return std::abs(cross(way, middle - c.from)) <=
           std::abs(way.y) * half.x + std::abs(way.x) * half.y + c.radius * norm(way);
}

CapsuleTree::CapsuleTree(const std::vector<Segment>& segments)
    : segments_(segments.size()), leaves_(std::bit_ceil(std::max<std::size_t>(1, (segments.size() + kRun - 1) / kRun))),
      capsules_(2 * leaves_ - 1) {
    const std::span<const Segment> all(segments);
    std::vector<TurnedBox> level(leaves_);
    for (std::size_t i = 0; i < leaves_; ++i) {
        const Run r = run(leaves_ - 1 + i);
        level[i] = box_of(all.subspan(r.first, r.last - r.first));
        capsules_[leaves_ - 1 + i] = capsule(level[i]);
    }
    while (level.size() > 1) {
        for (std::size_t i = 0; i < level.size() / 2; ++i) level[i] = joined(level[2 * i], level[2 * i + 1]);
        level.resize(level.size() / 2);
        for (std::size_t i = 0; i < level.size(); ++i) capsules_[level.size() - 1 + i] = capsule(level[i]);
    }
}

void CapsuleTree::shift(Vec2 way) {
    for (Capsule& c : capsules_) c = {c.from + way, c.to + way, c.radius};
}

CapsuleTree::Run CapsuleTree::run(std::size_t leaf) const {
    const std::size_t first = (leaf - (leaves_ - 1)) * kRun;
    return {std::min(segments_, first), std::min(segments_, first + kRun)};
}

} // namespace filum::geom
