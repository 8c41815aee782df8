#include "regions/farthest.hpp"

#include "geom/bvh.hpp"
#include "geom/segment.hpp"
#include "polygon/segments.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <queue>

namespace filum::regions {

namespace {

using geom::Vec2;
using geom::Vec3;
using polygon::Loops;

constexpr double kFar = std::numeric_limits<double>::infinity();

// An area, and the distances of points from its outline.
class OutlinedArea {
  public:
    explicit OutlinedArea(Loops loops)
        : loops_(std::move(loops)), edges_(polygon::segments(loops_)), tree_(boxes(edges_)) {}

    [[nodiscard]] bool contains(Vec2 p) const { return polygon::contains(loops_, p); }
    [[nodiscard]] double to_outline(Vec2 p) const {
        double best = kFar;
        tree_.near({p.x, p.y, 0}, kFar, [&](std::uint32_t i) {
            best = std::min(best, geom::point_segment_distance(edges_[i].a, edges_[i].b, p));
            return best;
        });
        return best;
    }

  private:
    static std::vector<geom::Box3> boxes(const std::vector<geom::Segment>& edges) {
        std::vector<geom::Box3> out(edges.size());
        for (std::size_t i = 0; i < edges.size(); ++i)
            for (const Vec2 p : {edges[i].a, edges[i].b}) out[i].add(Vec3{p.x, p.y, 0});
        return out;
    }

    Loops loops_;
    std::vector<geom::Segment> edges_;
    geom::Bvh tree_;
};

// A square that may hold the farthest point, which is at most `bound` mm away from the others.
struct Square {
    double bound;
    Vec2 middle;
    double half; // mm, half a side

    bool operator<(const Square& o) const { return bound < o.bound; }
};

} // namespace

std::optional<Farthest> farthest(const Loops& area, std::span<const polygon::Region> others, double least,
                                 double tolerance) {
    if (others.empty()) return Farthest{kFar, area.points.front()};
    Loops all;
    for (const polygon::Region& r : others) all.add(r.loops);
    const OutlinedArea inside(area), under(std::move(all));
    const auto reach = [&](Vec2 p) { return under.contains(p) ? 0 : under.to_outline(p); };
    Farthest best{least, {}};
    const auto offer = [&](Vec2 p, double far) {
        if (far > best.reach) best = {far, p};
    };
    for (const Vec2 p : area.points) offer(p, reach(p));
    std::priority_queue<Square> squares;
    const auto add = [&](Vec2 middle, double half) {
        const double diagonal = std::numbers::sqrt2 * half, far = reach(middle);
        if (far + diagonal <= best.reach + tolerance) return;
        if (inside.contains(middle))
            offer(middle, far);
        else if (inside.to_outline(middle) > diagonal)
            return;
        squares.push({far + diagonal, middle, half});
    };
    const geom::Box2 box = polygon::bounds(area);
    add(geom::lerp(box.lo, box.hi, 0.5), std::max(box.hi.x - box.lo.x, box.hi.y - box.lo.y) / 2);
    while (!squares.empty() && squares.top().bound > best.reach + tolerance) {
        const Square s = squares.top();
        squares.pop();
        for (const Vec2 corner : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{1, 1}})
            add(s.middle + (s.half / 2) * corner, s.half / 2);
    }
    if (best.reach <= least) return std::nullopt;
    return best;
}

} // namespace filum::regions
