// The segments of a plan in a tree, to find those near a point of the surface.
#pragma once

#include "geom/bvh.hpp"
#include "geom/segment.hpp"
#include "surfpath/plan/plan.hpp"
#include "surfpath/rules/rules.hpp"

namespace filum::surfpath::plan {

struct PathSegment {
    Vec3 a, b, normal;        // its ends; the normal of its triangle
    double arc = 0;           // mm from the start of the first stroke; strokes are kStrokesApart apart
    bool hairpin = false;     // part of a marked hairpin
    std::uint32_t stroke = 0; // index in the plan
    double width = 0;         // mm; 0: the usual one
};

inline constexpr double kStrokesApart = 1e6; // mm of arc length

// The place of a segment that is nearest to a point.
struct NearestPlace {
    double off, t; // distance, mm; parameter along the segment, 0 to 1
};
inline NearestPlace nearest_place(const PathSegment& l, const Vec3& p) {
    const double t = geom::nearest_parameter(l.a, l.b, p);
    return {distance(p, l.a + t * (l.b - l.a)), t};
}
// Whether the segment is within `reach` mm of `p`. The same as nearest_place(l, p).off <= reach, without division and
// square root unless the decision is a matter of rounding.
inline bool within(const PathSegment& l, const Vec3& p, double reach) {
    const Vec3 d = l.b - l.a, from = p - l.a;
    const double l2 = norm2(d), along = dot(from, d);
    const bool foot = along > 0 && along < l2;
    const double all2 = foot ? norm2(from) * l2 : norm2(along > 0 ? p - l.b : from);
    const double off2 = foot ? all2 - along * along : all2, reach2 = reach * reach * (foot ? l2 : 1);
    if (std::abs(off2 - reach2) > rules::kRounding * (all2 + reach2)) return off2 < reach2;
    return nearest_place(l, p).off <= reach;
}
inline double arc(const PathSegment& l, double t) { return l.arc + t * distance(l.a, l.b); }

class PathSegments {
  public:
    PathSegments(const Surface& s, const Plan& plan);

    // Sets `out` to the segments that face the same way and whose boxes meet `box`: all within reach of points in it,
    // if it was grown by that reach.
    void in_box(const geom::Box3& box, const Vec3& normal, std::vector<const PathSegment*>& out) const;

    // Calls f(segment, mm) with the distance of every segment within `reach` of `p` that faces the same way.
    template <class F>
    void near(const Vec3& p, const Vec3& normal, double reach, const F& f) const {
        tree_.visit(geom::grown({p, p}, reach), [&](std::uint32_t k) {
            const PathSegment& l = all_[k];
            if (!(dot(normal, l.normal) > 0)) return;
            if (const NearestPlace at = nearest_place(l, p); at.off <= reach) f(l, at.off);
        });
    }

  private:
    std::vector<PathSegment> all_;
    geom::Bvh tree_;
};

// Number of passes of the path: arc lengths that differ by more than a width are different passes. Sorts `arcs`.
std::size_t passes(std::vector<double>& arcs, double width);

} // namespace filum::surfpath::plan
