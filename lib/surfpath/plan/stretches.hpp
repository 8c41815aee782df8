// The stretches of a plan, by place: what of it lies near a point of the surface.
#pragma once

#include "geom/bvh.hpp"
#include "geom/segment.hpp"
#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

struct Stretch {
    Vec3 a, b, normal;        // its ends; of the triangle that it lies in
    double way = 0;           // mm from the begin of all strokes, laid out one behind the other a mile apart
    bool hairpin = false;     // of a piece that is declared as one
    std::uint32_t stroke = 0; // of the plan
};

// Of the place of a stretch that is nearest to another.
struct Beside {
    double off, t; // mm; the part of the stretch that lies before it
};
inline Beside beside(const Stretch& l, const Vec3& p) {
    const double t = geom::nearest_parameter(l.a, l.b, p);
    return {distance(p, l.a + t * (l.b - l.a)), t};
}
// Whether a stretch comes as near to `p` as `reach`, mm: as beside() has it, which is asked only where that is a matter
// of rounding, as quotients and roots take long.
inline bool within(const Stretch& l, const Vec3& p, double reach) {
    constexpr double kRounding = 1e-9; // of what is subtracted from each other
    const Vec3 d = l.b - l.a, from = p - l.a;
    const double l2 = norm2(d), along = dot(from, d);
    const bool foot = along > 0 && along < l2;
    const double all2 = foot ? norm2(from) * l2 : norm2(along > 0 ? p - l.b : from);
    const double off2 = foot ? all2 - along * along : all2, reach2 = reach * reach * (foot ? l2 : 1);
    if (std::abs(off2 - reach2) > kRounding * (all2 + reach2)) return off2 < reach2;
    return beside(l, p).off <= reach;
}
inline double way(const Stretch& l, double t) { return l.way + t * distance(l.a, l.b); }

class Stretches {
  public:
    Stretches(const Surface& s, const Plan& plan);

    // Puts those into `out` that face alike and whose boxes meet this one: what lies near any place well within it.
    void about(const geom::Box3& box, const Vec3& normal, std::vector<const Stretch*>& out) const;

    // Calls f(stretch, mm off) for the nearest place of every stretch within reach that faces alike.
    template <class F>
    void near(const Vec3& p, const Vec3& normal, double reach, const F& f) const {
        tree_.visit(geom::grown({p, p}, reach), [&](std::uint32_t k) {
            const Stretch& l = all_[k];
            if (!(dot(normal, l.normal) > 0)) return;
            if (const Beside at = beside(l, p); at.off <= reach) f(l, at.off);
        });
    }

  private:
    std::vector<Stretch> all_;
    geom::Bvh tree_;
};

// How often the path passes: places of it that are more than a width of way apart count each.  Sorts the ways.
std::size_t passes(std::vector<double>& ways, double width);

} // namespace filum::surfpath::plan
