#include "rings/stack.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace filum::rings {

namespace {

constexpr std::uint32_t kNoHalf = 0xffffffff;
constexpr double kSameShare = 1e-9;
constexpr double kMostOfRing = 0.6;                  // that a window may take
constexpr double kFollow = 0.8;                      // of a neighbour's way: no lane moves in less
constexpr double kUnlike = 4;                        // times as long as its neighbour: no longer beside it
constexpr double kLeastTurn = 0.25, kMostTurn = 0.5; // of a lane: the width of lanes where they turn in a wedge
constexpr int kSteps = 4;                            // in which lanes move, at least
constexpr double kNarrowest = 1.0 / 16;              // widths, of a bead in a wedge

struct RingPass {
    std::uint32_t ring;
    Pass pass;
};

// The stretch of lane k along half-edge h: from the ray to its first node on, or, where it comes from the other side,
// to the ray to its last node; nothing if there is none.
std::optional<RingPass> pass_on(const StackGround& g, std::uint32_t h, int lane) {
    const Rings& rings = *g.rings;
    const auto pass = [&](double share0, double share1, std::uint32_t p, std::uint32_t q) {
        const std::uint32_t r = g.lengths->ring[p];
        const double from = g.lengths->along[p], to = g.lengths->along[q];
        return RingPass{r, {h, share0, share1, from, to < from ? to + g.lengths->length[r] : to}};
    };
    if (rings.lanes_on(h) >= lane) {
        const std::uint32_t e = rings.entry(h, lane);
        if (rings.ray_point[e] == kNoPoint || rings.end_share[e] == 0) return std::nullopt;
        return pass(0, rings.end_share[e], rings.ray_point[e], rings.end_point[e]);
    }
    if (rings.lanes_on(h ^ 1) < lane) return std::nullopt;
    const std::uint32_t e = rings.entry(h ^ 1, lane);
    if (rings.ray_point[e] == kNoPoint || rings.end_share[e] == 0) return std::nullopt;
    const std::uint32_t last = rings.ray_point[rings.entry(g.beading->axis.next[h], lane)];
    return pass(1 - rings.end_share[e], 1, rings.end_point[e], last);
}

// How far along its ring a lane is on a ray; nothing if it is not there.
std::optional<double> along(const StackGround& g, const StackLane& l, AxisPlace ray) {
    const auto on = l.across ? pass_on(g, ray.half ^ 1, l.lane) : pass_on(g, ray.half, l.lane);
    if (!on || on->ring != l.ring) return std::nullopt;
    const Pass& p = on->pass;
    const double t = l.across ? 1 - ray.share : ray.share;
    if (t < p.share0 - kSameShare || t > p.share1 + kSameShare) return std::nullopt;
    return std::lerp(p.s0, p.s1, p.share1 > p.share0 ? (t - p.share0) / (p.share1 - p.share0) : 0);
}

// The part of a ring between two rays, by the share of its length there.
struct Strip {
    BeadLine line;
    std::vector<double> share; // of each point, from 0 to 1

    struct At {
        Vec2 point, along;
        double width, depth;
    };
    [[nodiscard]] At at(double t) const {
        const auto i = std::clamp<std::ptrdiff_t>(std::upper_bound(share.begin(), share.end(), t) - share.begin() - 1, 0,
                                                  static_cast<std::ptrdiff_t>(share.size()) - 2);
        const auto k = static_cast<std::size_t>(i);
        const double span = share[k + 1] - share[k], u = span > 0 ? (t - share[k]) / span : 0;
        return {geom::lerp(line.points[k], line.points[k + 1], u), line.points[k + 1] - line.points[k],
                std::lerp(line.width[k], line.width[k + 1], u), std::lerp(line.depth[k], line.depth[k + 1], u)};
    }
};

class Making {
  public:
    Making(const StackGround& ground, const StackAt& at, AxisPlace from, AxisPlace to, const StackOptions& o)
        : g_(&ground), o_(&o) {
        // from the ring itself outwards on both sides, as far as lanes lie side by side
        const auto own = static_cast<std::ptrdiff_t>(at.own), n = static_cast<std::ptrdiff_t>(at.lanes.size());
        for (std::ptrdiff_t l = own; l >= 0 && add(at.lanes[static_cast<std::size_t>(l)], from, to); --l) {}
        std::reverse(lane_.begin(), lane_.end());
        for (std::ptrdiff_t l = own + 1; !lane_.empty() && l < n; ++l)
            if (!add(at.lanes[static_cast<std::size_t>(l)], from, to)) break;
        find_moves();
    }

    [[nodiscard]] std::size_t size() const { return lane_.size(); }

    // rad, of the outermost and the inmost lane.
    [[nodiscard]] double turning() const { return (turning(lane_.front()) + turning(lane_.back())) / 2; }

    [[nodiscard]] Splice splice() const {
        const auto n = static_cast<std::uint32_t>(lane_.size());
        Splice out;
        for (std::size_t l = 0; l < n; ++l) out.windows.push_back(window(l));
        out.links.push_back({left_rim(0), left_rim(1), outer_turn()});
        for (std::uint32_t l = 2; l < n; ++l) out.links.push_back({left_rim(l), right_rim(l - 2), shift(l)});
        out.links.push_back({right_rim(n - 2), right_rim(n - 1), inner_turn()});
        return out;
    }

  private:
    struct Lane {
        StackLane lane;
        double s0 = 0, length = 0; // along its ring, between the rays
        Strip strip;
        double moving = 1; // share of that within which it moves
    };
    [[nodiscard]] double count() const { return static_cast<double>(lane_.size()); }

    bool add(const StackLane& l, AxisPlace from, AxisPlace to) {
        auto a = along(*g_, l, from), b = along(*g_, l, to);
        if (!a || !b) return false;
        if (l.across) std::swap(a, b);
        const double whole = g_->lengths->length[l.ring], s0 = *a - std::floor(*a / whole) * whole;
        double gone = *b - s0;
        gone -= std::floor(gone / whole) * whole;
        if (gone <= 0 || gone > kMostOfRing * whole || !o_->free(l.ring, s0, s0 + gone)) return false;
        if (!lane_.empty() && std::max(gone, lane_.back().length) > kUnlike * std::min(gone, lane_.back().length))
            return false;
        Lane out{l, s0, gone, {}, std::min(1.0, o_->length / gone)};
        append(*g_->rings, *g_->lengths, l.ring, s0, s0 + gone, out.strip.line);
        auto& [points, width, depth] = out.strip.line;
        if (l.across) {
            std::reverse(points.begin(), points.end());
            std::reverse(width.begin(), width.end());
            std::reverse(depth.begin(), depth.end());
        }
        double s = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i > 0) s += geom::distance(points[i - 1], points[i]);
            out.strip.share.push_back(s);
        }
        if (s <= 0) return false;
        for (double& x : out.strip.share) x /= s;
        lane_.push_back(std::move(out));
        return true;
    }

    // Neighbours begin to move one after the other, never farther apart than keeps them side by side.
    void find_moves() {
        for (std::size_t k = 1; k < lane_.size(); ++k)
            lane_[k].moving = std::max(lane_[k].moving, kFollow * lane_[k - 1].moving);
        for (std::size_t k = lane_.size(); k-- > 1;)
            lane_[k - 1].moving = std::max(lane_[k - 1].moving, kFollow * lane_[k].moving);
    }

    [[nodiscard]] static double turning(const Lane& lane) {
        const auto& p = lane.strip.line.points;
        double sum = 0;
        for (std::size_t i = 1; i + 1 < p.size(); ++i)
            sum += std::abs(std::atan2(cross(p[i] - p[i - 1], p[i + 1] - p[i]), dot(p[i] - p[i - 1], p[i + 1] - p[i])));
        return sum;
    }

    // The lanes that move are 2 and on; those before and behind go along.
    [[nodiscard]] std::size_t mover(std::size_t l) const {
        return std::clamp<std::size_t>(l, std::min<std::size_t>(2, lane_.size() - 1), lane_.size() - 1);
    }
    [[nodiscard]] double begins(std::size_t l) const { return 0.5 - lane_[mover(l)].moving / 2; }
    [[nodiscard]] double ends(std::size_t l) const { return 0.5 + lane_[mover(l)].moving / 2; }
    // How far lane l has moved at the share t of the way between the rays, 0 to 1.
    [[nodiscard]] double moved(std::size_t l, double t) const {
        return std::clamp((t - begins(l)) / lane_[mover(l)].moving, 0.0, 1.0);
    }

    [[nodiscard]] Window window(std::size_t l) const {
        const Lane& lane = lane_[l];
        double t0 = begins(l), t1 = ends(l + 2);
        if (lane.lane.across) t0 = 1 - std::exchange(t1, 1 - t0);
        const double whole = g_->lengths->length[lane.lane.ring], a = lane.s0 + t0 * lane.length;
        const double turns = std::floor(a / whole) * whole;
        return {lane.lane.ring, a - turns, lane.s0 + t1 * lane.length - turns};
    }

    // The place between rings at the share t: x = l is ring l's middle, in between (and beyond) it is linear.
    [[nodiscard]] Strip::At at(double x, double t) const {
        const auto l = static_cast<std::size_t>(std::clamp(std::floor(x), 0.0, count() - 2));
        const double u = x - static_cast<double>(l), v = std::clamp(u, 0.0, 1.0);
        const auto a = lane_[l].strip.at(t), b = lane_[l + 1].strip.at(t);
        return {geom::lerp(a.point, b.point, u), (1 - v) * a.along + v * b.along, std::lerp(a.width, b.width, v),
                std::lerp(a.depth, b.depth, v)};
    }

    // Shares between t0 and t1, both included, at which a path over rings lo to hi gets points.
    [[nodiscard]] std::vector<double> shares(double t0, double t1, std::size_t lo, std::size_t hi) const {
        std::vector<double> out;
        for (int k = 0; k <= kSteps; ++k) out.push_back(std::lerp(t0, t1, static_cast<double>(k) / kSteps));
        for (std::size_t l = lo; l <= hi; ++l)
            for (const double t : lane_[l].strip.share)
                if (t > t0 && t < t1) out.push_back(t);
        std::sort(out.begin(), out.end());
        out.erase(std::unique(out.begin(), out.end()), out.end());
        return out;
    }

    // The path through x(t), `share` of a lane thick there; as wide as that is across it.
    template <class X, class Share>
    [[nodiscard]] BeadLine path(const std::vector<double>& shares, const X& x, const Share& share) const {
        std::vector<Strip::At> at_share;
        for (const double t : shares) at_share.push_back(at(x(t), t));
        BeadLine out;
        for (std::size_t i = 0; i < shares.size(); ++i) {
            const Strip::At& a = at_share[i];
            const Vec2 way = at_share[std::min(i + 1, shares.size() - 1)].point - at_share[i == 0 ? 0 : i - 1].point;
            const double l = geom::norm(way) * geom::norm(a.along), cosine = l > 0 ? std::abs(dot(way, a.along)) / l : 1;
            out.add(a.point, std::max(share(shares[i]) * a.width * cosine, kNarrowest * g_->beading->width), a.depth);
        }
        return out;
    }

    // Lane l moving two lanes outwards, without its ends.
    [[nodiscard]] BeadLine shift(std::size_t l) const {
        const auto x = [&](double t) { return static_cast<double>(l) - 2 * moved(l, t); };
        const auto thick = [&](double t) {
            return 1 - (moved(l + 1 < lane_.size() ? l + 1 : l, t) - moved(l > 2 ? l - 1 : l, t));
        };
        const BeadLine all = path(shares(begins(l), ends(l), l - 2, l), x, thick);
        BeadLine out;
        for (std::size_t i = 1; i + 1 < all.size(); ++i) out.add(all.points[i], all.width[i], all.depth[i]);
        return out;
    }

    // What is left of a lane where two that share a wedge turn back.
    [[nodiscard]] double left(std::size_t l) const {
        const double area = lane_[l].moving * lane_[l].length * g_->beading->width;
        return std::clamp(std::sqrt(o_->least_void / area), kLeastTurn, kMostTurn);
    }
    // Two lanes that share the wedge at the first ray, there and back.
    [[nodiscard]] BeadLine outer_turn() const {
        const auto m = [&](double t) { return moved(2, t); };
        const auto thin = [&](double t) { return 1 - m(t); };
        const double t0 = begins(2), t1 = std::lerp(t0, ends(2), 1 - left(0));
        const auto at = shares(t0, t1, 0, 1);
        const BeadLine there = path(at, [&](double t) { return -m(t) / 2; }, thin);
        const BeadLine back = path(at, [&](double t) { return 1 - 1.5 * m(t); }, thin);
        BeadLine out;
        for (std::size_t i = 1; i < there.size(); ++i) out.add(there.points[i], there.width[i], there.depth[i]);
        for (std::size_t i = back.size(); i-- > 1;) out.add(back.points[i], back.width[i], back.depth[i]);
        return out;
    }
    // The same at the last ray.
    [[nodiscard]] BeadLine inner_turn() const {
        const std::size_t last = lane_.size() - 1;
        const auto m = [&](double t) { return moved(last, t); };
        const double n = count(), t1 = ends(last), t0 = std::lerp(begins(last), t1, left(last));
        const auto at = shares(t0, t1, last - 1, last);
        const BeadLine there = path(at, [&](double t) { return n - 0.5 - 1.5 * m(t); }, m);
        const BeadLine back = path(at, [&](double t) { return n - 0.5 - 0.5 * m(t); }, m);
        BeadLine out;
        for (std::size_t i = there.size() - 1; i-- > 0;) out.add(there.points[i], there.width[i], there.depth[i]);
        for (std::size_t i = 0; i + 1 < back.size(); ++i) out.add(back.points[i], back.width[i], back.depth[i]);
        return out;
    }

    [[nodiscard]] Rim left_rim(std::uint32_t l) const { return {l, lane_[l].lane.across}; }
    [[nodiscard]] Rim right_rim(std::uint32_t l) const { return {l, !lane_[l].lane.across}; }

    const StackGround* g_;
    const StackOptions* o_;
    std::vector<Lane> lane_;
};

} // namespace

StackGround stack_ground(const Beading& beading, const Rings& rings, const RingLengths& lengths) {
    std::vector<std::uint32_t> half(rings.points.size(), kNoHalf);
    for (std::uint32_t h = 0; h < beading.axis.half_edges(); ++h)
        for (std::uint32_t e = rings.ray_start[h]; e < rings.ray_start[h + 1]; ++e)
            if (rings.ray_point[e] != kNoPoint) half[rings.ray_point[e]] = h;
    StackGround out{&beading, &rings, &lengths, std::vector<std::vector<Pass>>(rings.size())};
    for (std::uint32_t r = 0; r < rings.size(); ++r)
        for (std::uint32_t p = rings.start[r]; p < rings.start[r + 1]; ++p) {
            if (half[p] == kNoHalf) continue;
            for (const std::uint32_t h : {half[p], half[p] ^ 1}) { // where it turns back, there and back
                const auto on = pass_on(out, h, rings.lane[r]);
                if (on && on->ring == r && on->pass.s1 > on->pass.s0) out.passes[r].push_back(on->pass);
                if (!on || on->pass.share1 == 1) break;
            }
        }
    return out;
}

std::optional<AxisPlace> ray_at(const StackGround& g, std::uint32_t ring, double s) {
    const auto& passes = g.passes[ring];
    if (passes.empty()) return std::nullopt;
    const double whole = g.lengths->length[ring];
    s -= std::floor(s / whole) * whole;
    const auto after = std::upper_bound(passes.begin(), passes.end(), s, [](double v, const Pass& p) { return v < p.s0; });
    if (after == passes.begin()) s += whole;
    const Pass& p = after == passes.begin() ? passes.back() : *(after - 1);
    return AxisPlace{p.half, std::lerp(p.share0, p.share1, std::clamp((s - p.s0) / (p.s1 - p.s0), 0.0, 1.0))};
}

StackAt lanes_at(const StackGround& g, std::uint32_t ring, AxisPlace ray) {
    const int lane = g.rings->lane[ring];
    StackAt out;
    const auto add = [&](AxisPlace at, int k, bool across) {
        const auto on = pass_on(g, at.half, k);
        if (!on || at.share < on->pass.share0 - kSameShare || at.share > on->pass.share1 + kSameShare) return false;
        out.lanes.push_back({on->ring, k, across});
        return true;
    };
    for (int k = 1; k <= lane; ++k)
        if (!add(ray, k, false)) return {};
    out.own = out.lanes.size() - 1;
    const AxisPlace far{ray.half ^ 1, 1 - ray.share};
    for (const AxisPlace& at : {ray, far})
        if (add(at, lane + 1, false)) {
            out.lanes.pop_back(); // not the inmost
            return out;
        }
    for (int k = lane; k >= 1 && add(far, k, true);) --k;
    return out;
}

std::optional<StackSplice> stack_splice(const StackGround& ground, const StackAt& at, AxisPlace from, AxisPlace to,
                                        const StackOptions& options) {
    const Making making(ground, at, from, to, options);
    if (making.size() < 2) return std::nullopt;
    return StackSplice{making.splice(), making.turning()};
}

} // namespace filum::rings
