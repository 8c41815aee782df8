#include "fill/rings/rings.hpp"
#include "fill/rings/ray.hpp"

#include <cmath>
#include <optional>

namespace filum::fill::rings {

namespace {

class RingTracer {
  public:
    RingTracer(const Beading& beading, double least_void, double tolerance, const RingSink& sink)
        : b_(&beading), least_void_(least_void), tolerance_(tolerance), sink_(&sink) {
        lanes_.reserve(axis().half_edges());
        for (const std::uint32_t i : axis().from) {
            const double last = beading.profile[i].last;
            lanes_.push_back(last < 0 ? 0 : static_cast<int>(last + 1 + 1e-9));
        }
    }

    void run(int most) {
        std::vector<std::uint32_t> live;
        for (std::uint32_t h = 0; h < axis().half_edges(); ++h)
            if (lanes_[h] > 0) live.push_back(h);
        seen_.assign(axis().half_edges(), 0);
        for (lane_ = 1; !live.empty() && (most <= 0 || lane_ <= most); ++lane_) {
            for (const std::uint32_t h : live)
                if (seen_[h] != lane_) ring(h);
            std::erase_if(live, [&](std::uint32_t h) { return lanes_[h] <= lane_; });
        }
    }

  private:
    [[nodiscard]] const MedialAxis& axis() const { return b_->axis; }

    void ring(std::uint32_t h0) {
        ring_.points.clear();
        ring_.width.clear();
        for (std::uint32_t h = h0; seen_[h] != lane_;) {
            const std::uint32_t after = axis().next[h];
            seen_[h] = lane_;
            ray_point(h, 0, b_->end(axis().from[h], lane_));
            if (lanes_[after] >= lane_) {
                narrow(h);
                if (about_vertex(h)) arc_to(h, Ray(*b_, after, 0).point(middle(axis().from[after])));
                h = after;
            } else {
                turn(h);
                h = axis().next[h ^ 1];
            }
        }
        if (ring_.points.size() >= 3 && (lane_ == 1 || is_large())) (*sink_)(ring_, lane_);
    }

    // Whether the current ring covers the smallest void that counts.
    [[nodiscard]] bool is_large() const {
        double area = 0; // mm2
        const std::size_t n = ring_.points.size();
        for (std::size_t i = 0; i < n && area < least_void_; ++i)
            area += ring_.width[i] * geom::distance(ring_.points[i], ring_.points[i + 1 == n ? 0 : i + 1]);
        return area >= least_void_;
    }

    // Lane coordinate of the middle of the strip on the ray to node i.
    [[nodiscard]] double middle(std::uint32_t i) const { return (lane_ - 1 + b_->end(i, lane_)) / 2; }

    void put(Vec2 p, double width) { ring_.add(p, std::max(width, kNarrowest * b_->width)); }

    // Adds the point on the ray with parameter `t` of h; the strip ends at lane coordinate `end` there.
    void ray_point(std::uint32_t h, double t, double end) {
        const Ray ray(*b_, h, t);
        put(ray.point((lane_ - 1 + end) / 2), ray.depth(end) - ray.depth(lane_ - 1));
    }

    // The parameter of h at which the axis has lane coordinate f; none if it does not.
    [[nodiscard]] std::optional<double> share_at(std::uint32_t h, double f) const { return rings::share_at(*b_, h, f); }

    // In an acute corner the strip narrows from the ray where the axis is `reach` before the strip's end; adds a point
    // there.
    bool narrow(std::uint32_t h) {
        const double reach = b_->reach[h / 2];
        if (b_->wall[h / 2] || reach >= 0.5) return false;
        const double end =
            std::min<double>(lane_, std::min(b_->profile[axis().from[h]].top, b_->profile[axis().to(h)].top));
        const auto t = end > lane_ - 1 + 2 * reach ? share_at(h, end - reach) : std::nullopt;
        if (t) ray_point(h, *t, end);
        return t.has_value();
    }

    // Turns around the end of the lane: from the ray to h's first node to the one on the other side.
    void turn(std::uint32_t h) {
        const std::uint32_t i = axis().from[h], j = axis().to(h), back = h ^ 1, after = axis().next[back];
        const double ri = axis().radius[i], rj = axis().radius[j], reach = b_->reach[h / 2], end = b_->end(i, lane_);
        if (b_->wall[h / 2]) {
            if (lane_ > 1 || b_->tip[h / 2] == 0 || ri <= rj) return; // straight across the wall
            const double t = std::clamp((ri - b_->tip[h / 2]) / (ri - rj), 0.0, 1.0);
            ray_point(h, t, end);
            ray_point(back, 1 - t, end);
            return;
        }
        narrow(h);
        const double f = std::min(lane_ - 1 + reach, middle(i)); // no deeper than on the rays beside the corner
        double t = 0;
        if (ri > b_->depth(i, f)) {
            const auto share = share_at(h, f);
            if (!share) return;
            t = *share;
        }
        const Vec2 tip = geom::lerp(axis().node[i], axis().node[j], t);
        arc_to(h, tip);
        put(tip, 2 * (std::lerp(ri, rj, t) - Ray(*b_, h, t).depth(lane_ - 1)));
        narrow(back);
        arc_to(back, Ray(*b_, after, 0).point(middle(i)));
    }

    [[nodiscard]] bool about_vertex(std::uint32_t h) const { return axis().last_foot(h) == axis().foot[h]; }

    // If h belongs to a vertex of the outline: adds points on the arc around it, from the last point to p.
    void arc_to(std::uint32_t h, Vec2 p) {
        const double w = ring_.width.back();
        each_on_arc(axis(), h, ring_.points.back(), p, tolerance_, [&](Vec2 q) { put(q, w); });
    }

    const Beading* b_;
    double least_void_, tolerance_;
    int lane_ = 0;
    std::vector<int> lanes_; // per half-edge: number of lanes on the ray to its first node
    std::vector<int> seen_;  // per half-edge: the last lane that has passed it
    const RingSink* sink_;
    toolpath::Curve ring_{true, {}, {}}; // the current ring
};

} // namespace

void Rings::add(const Rings& more) {
    const auto base = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), more.points.begin(), more.points.end());
    width.insert(width.end(), more.width.begin(), more.width.end());
    lane.insert(lane.end(), more.lane.begin(), more.lane.end());
    for (std::size_t i = 1; i < more.start.size(); ++i) start.push_back(base + more.start[i]);
}

void Rings::add(const toolpath::Curve& ring, int of_lane) {
    points.insert(points.end(), ring.points.begin(), ring.points.end());
    width.insert(width.end(), ring.width.begin(), ring.width.end());
    start.push_back(static_cast<std::uint32_t>(points.size()));
    lane.push_back(of_lane);
}

void trace_rings(const Beading& beading, int most, double least_void, double tolerance, const RingSink& sink) {
    RingTracer(beading, least_void, tolerance, sink).run(most);
}

} // namespace filum::fill::rings
