#include "regions/farthest.hpp"

#include "geom/bvh.hpp"
#include "geom/segment.hpp"
#include "polygon/clip.hpp"
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
    // The edge nearest to p, or any edge that is no farther than `enough` mm.
    [[nodiscard]] NearestEdge nearest(Vec2 p, double enough) const {
        NearestEdge best;
        tree_.near({p.x, p.y, 0}, kFar, [&](std::uint32_t i) {
            if (best.distance <= enough) return -1.0;
            const double far = geom::point_segment_distance(edges_[i].a, edges_[i].b, p);
            if (far < best.distance) best = {edges_[i], far};
            return best.distance <= enough ? -1.0 : best.distance;
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

// Finds the farthest point of areas. A test against the edges comes before the test whether a point lies over the
// others, because it rules out most points.
class Search {
  public:
    Search(const Loops& others, double least, double tolerance) : under_(others), tolerance_(tolerance) {
        best_.reach = least;
    }

    void add_vertices(const Loops& area) {
        for (const Vec2 p : area.points) {
            const double far = under_.nearest(p, best_.reach).distance;
            if (far > best_.reach && !under_.contains(p)) offer(p, far);
        }
    }
    void add_squares(const Loops& area) {
        area_.emplace(area);
        const geom::Box2 box = polygon::bounds(area);
        add_square(geom::lerp(box.lo, box.hi, 0.5), std::max(box.hi.x - box.lo.x, box.hi.y - box.lo.y) / 2);
        while (!squares_.empty()) {
            const Square s = squares_.top();
            squares_.pop();
            if (s.bound <= best_.reach + tolerance_) continue;
            for (const Vec2 corner : kCorners) add_square(s.middle + (s.half / 2) * corner, s.half / 2);
        }
    }
    [[nodiscard]] const Farthest& best() const { return best_; }

  private:
    void offer(Vec2 p, double far) {
        if (far > best_.reach) best_ = {far, p};
    }
    void add_square(Vec2 middle, double half) {
        const double diagonal = std::numbers::sqrt2 * half, enough = best_.reach + tolerance_;
        NearestEdge nearest = under_.nearest(middle, enough - diagonal);
        if (nearest.distance + diagonal <= enough) return;
        const bool over = under_.contains(middle);
        if (over) nearest.distance = 0;
        double bound = nearest.distance + diagonal;
        if (bound <= enough) return;
        if (area_->contains(middle)) offer(middle, nearest.distance);
        if (!over) bound = std::min(bound, farthest_from(nearest.edge, *area_, middle, half));
        if (bound > best_.reach + tolerance_) squares_.push({bound, middle, half});
    }

    OutlinedArea under_;
    double tolerance_; // mm
    std::optional<OutlinedArea> area_;
    Farthest best_;
    std::priority_queue<Square> squares_;
};

// The parts of `areas` farther than `far` mm from `others`; a little more where the outline of others has corners.
Loops parts_beyond(const Loops& areas, const Loops& others, double far, double arc) {
    geom::Box2 box = polygon::bounds(areas);
    box.lo = box.lo - Vec2{2 * far, 2 * far};
    box.hi = box.hi + Vec2{2 * far, 2 * far};
    return polygon::subtract(areas, polygon::offset(polygon::within_box(others, box), far - arc, arc));
}

} // namespace

std::optional<Farthest> farthest(const Loops& area, std::span<const polygon::Region> others, double least,
                                 double tolerance) {
    if (area.empty()) return std::nullopt;
    if (others.empty()) return Farthest{kFar, area.points.front()};
    Loops all;
    for (const polygon::Region& r : others) all.add(r.loops);
    Search search(all, least, tolerance);
    search.add_vertices(area);
    const double most = search.best().reach + tolerance; // mm; places nearer than that do not count
    geom::Box2 both = polygon::bounds(area);
    for (const Vec2 p : all.points) both.add(p);
    if (most < geom::distance(both.lo, both.hi)) // else no place of the area is so far
        for (const Loops& part : polygon::split(parts_beyond(area, all, most, tolerance / 4)).part)
            search.add_squares(part);
    if (search.best().reach <= least) return std::nullopt;
    return search.best();
}

} // namespace filum::regions
