#include "regions/farthest.hpp"

#include "geom/bvh.hpp"
#include "geom/segment.hpp"
#include "polygon/inside_test.hpp"
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

// The edge of an outline that is nearest to some point.
struct NearestEdge {
    geom::Segment edge;
    double distance = kFar; // mm
};

// An area with trees for its edges.
class OutlinedArea {
  public:
    explicit OutlinedArea(const Loops& loops)
        : inside_(loops), edges_(polygon::segments(loops)), tree_(boxes(edges_)) {}

    [[nodiscard]] bool contains(Vec2 p) const { return inside_(p); }
    [[nodiscard]] NearestEdge nearest(Vec2 p) const {
        NearestEdge best;
        tree_.near({p.x, p.y, 0}, kFar, [&](std::uint32_t i) {
            const double far = geom::point_segment_distance(edges_[i].a, edges_[i].b, p);
            if (far < best.distance) best = {edges_[i], far};
            return best.distance;
        });
        return best;
    }
    // Calls visit(a, b) for the part of each edge that lies in the box.
    template <class Visit>
    void each_edge_in(const geom::Box2& box, const Visit& visit) const {
        tree_.visit({{box.lo.x, box.lo.y, 0}, {box.hi.x, box.hi.y, 0}}, [&](std::uint32_t i) {
            const Vec2 a = edges_[i].a, d = edges_[i].b - a;
            double from = 0, to = 1;
            const auto clip = [&](double start, double step, double lo, double hi) {
                if (step == 0) {
                    if (start < lo || start > hi) to = -1;
                    return;
                }
                const double t = (lo - start) / step, u = (hi - start) / step;
                from = std::max(from, std::min(t, u));
                to = std::min(to, std::max(t, u));
            };
            clip(a.x, d.x, box.lo.x, box.hi.x);
            clip(a.y, d.y, box.lo.y, box.hi.y);
            if (from <= to) visit(a + from * d, a + to * d);
        });
    }

  private:
    static std::vector<geom::Box3> boxes(const std::vector<geom::Segment>& edges) {
        std::vector<geom::Box3> out(edges.size());
        for (std::size_t i = 0; i < edges.size(); ++i)
            for (const Vec2 p : {edges[i].a, edges[i].b}) out[i].add(Vec3{p.x, p.y, 0});
        return out;
    }

    polygon::InsideTest inside_;
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

constexpr Vec2 kCorners[] = {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}};

// At most how far the points of `area` in the square are from `edge`; negative if there are none. The distance from a
// segment is convex, so it is greatest at a corner of the area's part: a corner of the square, or an end of an edge's
// part in it. Along a rim that is everywhere as far away this is the distance itself, so no square need be divided.
double farthest_from(const geom::Segment& edge, const OutlinedArea& area, Vec2 middle, double half) {
    double most = -1;
    const auto offer = [&](Vec2 p) { most = std::max(most, geom::point_segment_distance(edge.a, edge.b, p)); };
    for (const Vec2 corner : kCorners)
        if (const Vec2 p = middle + half * corner; area.contains(p)) offer(p);
    area.each_edge_in({middle - Vec2{half, half}, middle + Vec2{half, half}}, [&](Vec2 a, Vec2 b) {
        offer(a);
        offer(b);
    });
    return most;
}

} // namespace

std::optional<Farthest> farthest(const Loops& area, std::span<const polygon::Region> others, double least,
                                 double tolerance) {
    if (others.empty()) return Farthest{kFar, area.points.front()};
    Loops all;
    for (const polygon::Region& r : others) all.add(r.loops);
    const OutlinedArea inside(area), under(all);
    Farthest best{least, {}};
    const auto offer = [&](Vec2 p, double far) {
        if (far > best.reach) best = {far, p};
    };
    for (const Vec2 p : area.points)
        if (!under.contains(p)) offer(p, under.nearest(p).distance);
    std::priority_queue<Square> squares;
    const auto add = [&](Vec2 middle, double half) {
        const double diagonal = std::numbers::sqrt2 * half;
        const bool over = under.contains(middle);
        const NearestEdge nearest = over ? NearestEdge{{}, 0} : under.nearest(middle);
        double bound = nearest.distance + diagonal;
        if (bound <= best.reach + tolerance) return;
        if (inside.contains(middle)) offer(middle, nearest.distance);
        if (!over) bound = std::min(bound, farthest_from(nearest.edge, inside, middle, half));
        if (bound > best.reach + tolerance) squares.push({bound, middle, half});
    };
    const geom::Box2 box = polygon::bounds(area);
    add(geom::lerp(box.lo, box.hi, 0.5), std::max(box.hi.x - box.lo.x, box.hi.y - box.lo.y) / 2);
    while (!squares.empty() && squares.top().bound > best.reach + tolerance) {
        const Square s = squares.top();
        squares.pop();
        for (const Vec2 corner : kCorners) add(s.middle + (s.half / 2) * corner, s.half / 2);
    }
    if (best.reach <= least) return std::nullopt;
    return best;
}

} // namespace filum::regions
