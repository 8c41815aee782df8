#include "fill/rings/level.hpp"

#include "fill/rings/ray.hpp"
#include "polygon/clip.hpp"
#include "polygon/simple.hpp"

namespace filum::fill::rings {

namespace {

class LevelLine {
  public:
    LevelLine(const Beading& beading, int lane, double tolerance)
        : b_(&beading), lane_(lane), tolerance_(tolerance), seen_(beading.axis.half_edges(), 0) {}

    Loops run() {
        for (std::uint32_t h = 0; h < seen_.size(); ++h)
            if (!seen_[h] && inside(b_->axis.from[h])) loop(h);
        return std::move(out_);
    }

  private:
    // Whether the line crosses the ray to node i.
    [[nodiscard]] bool inside(std::uint32_t i) const { return b_->depth(i, lane_) < b_->axis.radius[i]; }

    // Traces one loop, from ray to ray along the outline. Where the axis is below the level, it passes to the axis's
    // other side.
    void loop(std::uint32_t first) {
        const MedialAxis& axis = b_->axis;
        for (std::uint32_t h = first; !seen_[h];) {
            seen_[h] = 1;
            out_.points.push_back(on_ray(h));
            if (inside(axis.to(h))) {
                arc_to(h, on_ray(axis.next[h]));
                h = axis.next[h];
                continue;
            }
            const double t = share_at(*b_, h, lane_).value_or(0);
            const Vec2 tip = geom::lerp(axis.node[axis.from[h]], axis.node[axis.to(h)], t);
            arc_to(h, tip);
            out_.points.push_back(tip);
            const std::uint32_t after = axis.next[h ^ 1];
            arc_to(h ^ 1, on_ray(after));
            h = after;
        }
        out_.close();
    }
    [[nodiscard]] Vec2 on_ray(std::uint32_t h) const { return Ray(*b_, h, 0).point(lane_); }
    void arc_to(std::uint32_t h, Vec2 p) {
        each_on_arc(b_->axis, h, out_.points.back(), p, tolerance_, [&](Vec2 q) { out_.points.push_back(q); });
    }

    const Beading* b_;
    int lane_;
    double tolerance_;
    std::vector<char> seen_; // per half-edge
    Loops out_;
};

} // namespace

Loops beyond(const Beading& beading, int lane, double tolerance) {
    const Loops exact = LevelLine(beading, lane, tolerance).run();
    Loops fewer = polygon::simplify(exact, tolerance);
    if (polygon::is_simple(fewer)) return fewer;
    return polygon::unite(exact, polygon::Fill::positive);
}

} // namespace filum::fill::rings
