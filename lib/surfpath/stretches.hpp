// The stretches of a plan, by place: what of it lies near a point of the surface.
#pragma once

#include "geom/bvh.hpp"
#include "geom/segment.hpp"
#include "surfpath/plan.hpp"

namespace filum::surfpath {

struct Stretch {
    Vec3 a, b, normal;        // its ends; of the triangle that it lies in
    double way = 0;           // mm from the begin of all strokes, laid out one behind the other a mile apart
    bool hairpin = false;     // of a piece that is declared as one
    std::uint32_t stroke = 0; // of the plan
};

class Stretches {
  public:
    Stretches(const Surface& s, const Plan& plan);

    [[nodiscard]] std::span<const Stretch> all() const { return all_; }

    // Whether the box of any stretch meets this one.
    [[nodiscard]] bool any(const geom::Box3& box) const {
        bool out = false;
        tree_.visit(box, [&](std::uint32_t) { out = true; });
        return out;
    }

    // Calls f(stretch, mm off, way) for the nearest place of every stretch within reach that faces alike.
    template <class F>
    void near(const Vec3& p, const Vec3& normal, double reach, const F& f) const {
        tree_.visit(geom::grown({p, p}, reach), [&](std::uint32_t k) {
            const Stretch& l = all_[k];
            if (!(dot(normal, l.normal) > 0)) return;
            const double t = geom::nearest_parameter(l.a, l.b, p), off = distance(p, l.a + t * (l.b - l.a));
            if (off <= reach) f(l, off, l.way + t * distance(l.a, l.b));
        });
    }

  private:
    std::vector<Stretch> all_;
    geom::Bvh tree_;
};

// How often the path passes: places of it that are more than a width of way apart count each.  Sorts the ways.
std::size_t passes(std::vector<double>& ways, double width);

} // namespace filum::surfpath
