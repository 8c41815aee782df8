#include "fill/rings/rings.hpp"
#include "fill/rings/ray.hpp"
#include "parallel/parallel.hpp"

#include <cmath>
#include <optional>
#include <utility>

namespace filum::fill::rings {

namespace {

// Rays that are walked at once, at least: some milliseconds of work.
constexpr std::size_t kRaysAtOnce = 1 << 16;

// Per half-edge: the number of lanes on the ray to its first node.
std::vector<int> lanes_on_rays(const Beading& beading) {
    std::vector<int> out;
    out.reserve(beading.axis.half_edges());
    for (const std::uint32_t i : beading.axis.from) {
        const double last = beading.profile[i].last;
        out.push_back(last < 0 ? 0 : static_cast<int>(last + 1 + 1e-9));
    }
    return out;
}

// Divides lanes 1 to `most` (0: all) into groups that meet at least kRaysAtOnce rays each. Returns the first lane of
// each group, and the one after the last.
std::vector<int> groups_of_lanes(const std::vector<int>& lanes, int most) {
    std::vector<std::size_t> rays; // per lane: the rays that it meets
    for (const int n : lanes) {
        const auto last = static_cast<std::size_t>(most > 0 ? std::min(n, most) : n);
        if (rays.size() <= last) rays.resize(last + 1);
        ++rays[last];
    }
    for (std::size_t k = rays.size(); k-- > 1;) rays[k - 1] += rays[k];
    std::vector<int> out{1};
    std::size_t met = 0;
    for (std::size_t k = 1; k < rays.size(); ++k) {
        met += rays[k];
        if (met < kRaysAtOnce && k + 1 < rays.size()) continue;
        out.push_back(static_cast<int>(k) + 1);
        met = 0;
    }
    return out;
}

// Traces the rings of some lanes.
class RingTracer {
  public:
    RingTracer(const Beading& beading, const std::vector<int>& lanes, double least_void, double tolerance,
               const RingWork& work)
        : b_(&beading), least_void_(least_void), tolerance_(tolerance), lanes_(&lanes), work_(&work) {}

    // Those of lanes `first` to `end` - 1.
    Rings run(int first, int end) {
        std::vector<std::uint32_t> live;
        for (std::uint32_t h = 0; h < axis().half_edges(); ++h)
            if (lanes_on(h) >= first) live.push_back(h);
        seen_.assign(axis().half_edges(), 0);
        for (lane_ = first; lane_ < end; ++lane_) {
            for (const std::uint32_t h : live)
                if (seen_[h] != lane_) ring(h);
            std::erase_if(live, [&](std::uint32_t h) { return lanes_on(h) <= lane_; });
        }
        return std::move(out_);
    }

  private:
    [[nodiscard]] const MedialAxis& axis() const { return b_->axis; }
    [[nodiscard]] int lanes_on(std::uint32_t h) const { return (*lanes_)[h]; }

    void ring(std::uint32_t h0) {
        ring_.points.clear();
        ring_.width.clear();
        for (std::uint32_t h = h0; seen_[h] != lane_;) {
            const std::uint32_t after = axis().next[h];
            seen_[h] = lane_;
            ray_point(h, 0, b_->end(axis().from[h], lane_));
            if (lanes_on(after) >= lane_) {
                narrow(h);
                if (about_vertex(h)) arc_to(h, Ray(*b_, after, 0).point(middle(axis().from[after])));
                h = after;
            } else {
                turn(h);
                h = axis().next[h ^ 1];
            }
        }
        if (ring_.points.size() >= 3 && (lane_ == 1 || is_large())) out_.add((*work_)(ring_), lane_);
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
    const std::vector<int>* lanes_;
    std::vector<int> seen_; // per half-edge: the last lane that has passed it
    const RingWork* work_;
    toolpath::Curve ring_{true, {}, {}}; // the current ring
    Rings out_;
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

Rings trace_rings(const Beading& beading, int most, double least_void, double tolerance, const RingWork& work) {
    const std::vector<int> lanes = lanes_on_rays(beading), group = groups_of_lanes(lanes, most);
    std::vector<Rings> part(group.size() - 1);
    parallel::for_chunks(part.size(), 1, 0, [&](std::size_t g, std::size_t) {
        part[g] = RingTracer(beading, lanes, least_void, tolerance, work).run(group[g], group[g + 1]);
    });
    if (part.size() == 1) return std::move(part.front());
    Rings out;
    for (Rings& p : part) out.add(std::exchange(p, {}));
    return out;
}

} // namespace filum::fill::rings
