#include "fill/double_spiral.hpp"

#include <algorithm>
#include <cmath>

namespace filum::fill {

namespace {

// All in bead widths unless said otherwise.
constexpr double kChord = 1.5;              // half the chord that tells a ring's direction
constexpr double kFarLane = 1.6;            // neighbouring lanes are nearer
constexpr double kNearLane = 0.4;           // and not nearer than this
constexpr double kRungs = 0.75;             // between rungs
constexpr double kStep = 0.4;               // between the points of a bend
constexpr double kTip = 0.9;                // the two lanes squeezed out turn where they share this
constexpr double kCloseUp = 1.0;            // way along which the others close up behind the turn
constexpr int kSharing = 3;                 // lanes that close up
constexpr double kLeast = 0.3, kMost = 2.5; // advance of a lane from rung to rung, of the lane's that was asked for

// Unit, to the left of the ring at s; nothing where it bends too much to tell.
std::optional<Vec2> across(const RingGraph& graph, std::uint32_t ring, double s, double width) {
    const double half = std::min(kChord * width, graph.length(ring) / 8);
    const Vec2 chord = graph.at(ring, s + half) - graph.at(ring, s - half);
    const double l = geom::norm(chord);
    if (l < 1.6 * half) return std::nullopt;
    return (1 / l) * geom::left_of(chord);
}

// From s to t on a ring of length l, the shorter way: positive if forwards.
double advance(double s, double t, double l) {
    double d = std::fmod(t - s, l);
    if (d > l / 2) d -= l;
    if (d < -l / 2) d += l;
    return d;
}

double smooth(double x) { return x * x * (3 - 2 * x); }

double inverse_smooth(double y) {
    double lo = 0, hi = 1;
    for (int k = 0; k < 40; ++k) (smooth((lo + hi) / 2) < y ? lo : hi) = (lo + hi) / 2;
    return (lo + hi) / 2;
}

// Points on a strip by x, 0 at its first rung and 1 at its last, and lane u: a whole number on lane u, from 0; the
// outer edge of the first bead is at -1/2, the inner edge of the last at n - 1/2.
class Frame {
  public:
    Frame(const RingGraph& graph, const Strip& strip) : strip_(&strip) {
        const std::size_t n = strip.ring.size();
        for (const auto& rung : strip.rung) {
            const auto edge = [&](const Place& own, const Place& next) {
                const double half = graph.width(own.ring, own.s) / 2;
                return own.point + (half / geom::distance(own.point, next.point)) * (own.point - next.point);
            };
            outer_.push_back(edge(rung[0], rung[1]));
            inner_.push_back(edge(rung[n - 1], rung[n - 2]));
        }
    }
    [[nodiscard]] Vec2 at(double x, double u) const {
        const double last = static_cast<double>(strip_->rung.size() - 1);
        const double j = std::clamp(std::floor(x * last), 0.0, last - 1);
        const auto k = static_cast<std::size_t>(j);
        return geom::lerp(on(k, u), on(k + 1, u), x * last - j);
    }

  private:
    [[nodiscard]] Vec2 on(std::size_t rung, double u) const {
        const auto& r = strip_->rung[rung];
        const double last = static_cast<double>(r.size() - 1);
        if (u < 0) return geom::lerp(r[0].point, outer_[rung], -2 * u);
        if (u > last) return geom::lerp(r.back().point, inner_[rung], 2 * (u - last));
        const auto k = static_cast<std::size_t>(std::min(std::floor(u), last - 1));
        return geom::lerp(r[k].point, r[k + 1].point, u - static_cast<double>(k));
    }
    const Strip* strip_;
    std::vector<Vec2> outer_, inner_; // per rung: the beads' edges
};

// Where a bead lies among the lanes, and the space it fills there.
struct Cell {
    double u, half;
};

// How the lanes change over, told for the outer side: the inner side is the same, seen from the other end.
class Change {
  public:
    Change(int lanes, double close_up) : lanes_(lanes), close_up_(close_up) {}
    // Lane k at x, 0 <= k < lanes, as counted at the strip's begin.
    [[nodiscard]] Cell lane(int k, double x) const {
        if (k < 2) return squeezed(k, x);
        Cell c{k - 2 * smooth(x), 0.5};
        close_up(k - 2, x, 1, c);
        close_up(lanes_ - 1 - k, 1 - x, -1, c);
        return c;
    }
    // The two innermost lanes as counted at the strip's end: 0 is the innermost.
    [[nodiscard]] Cell from_end(int k, double x) const {
        const Cell c = squeezed(k, 1 - x);
        return {lanes_ - 1 - c.u, c.half};
    }
    [[nodiscard]] double tip() const { return tip_; }

  private:
    // Lanes 0 and 1 share what lane 2 leaves of the strip's outer side.
    [[nodiscard]] static Cell squeezed(int k, double x) {
        const double room = 2 - 2 * smooth(x);
        return {-0.5 + room * (2 * k + 1) / 4, room / 4};
    }
    // Behind the tip the first lanes share the room that is left.
    void close_up(int k, double x, double sign, Cell& c) const {
        const int sharing = std::min(kSharing, lanes_ - 2);
        if (k >= sharing || x <= tip_) return;
        const double room = 2 - 2 * smooth(x), more = room / sharing;
        const double share = smooth(std::min(1.0, (x - tip_) / close_up_));
        c.u += sign * share * ((k + 0.5) * more - room);
        c.half += share * more / 2;
    }
    int lanes_;
    double close_up_; // of the strip's length
    double tip_ = inverse_smooth(1 - kTip / 2);
};

// A bead through the frame's lane cell(x) at each x.
template <class CellAt>
BeadLine bead(const Frame& frame, const std::vector<double>& xs, CellAt&& cell) {
    BeadLine out;
    for (const double x : xs) {
        const Cell c = cell(x);
        out.add(frame.at(x, c.u), geom::distance(frame.at(x, c.u - c.half), frame.at(x, c.u + c.half)));
    }
    for (std::size_t i = 0; i < xs.size(); ++i) { // a bead that runs aslant is narrower than its rung is long
        const Cell c = cell(xs[i]);
        const Vec2 rung = frame.at(xs[i], c.u + c.half) - frame.at(xs[i], c.u - c.half);
        const Vec2 along = out.points[std::min(i + 1, xs.size() - 1)] - out.points[i == 0 ? 0 : i - 1];
        const double l = geom::norm(rung) * geom::norm(along);
        if (l > 0) out.width[i] *= std::abs(geom::cross(rung, along)) / l;
    }
    return out;
}

std::vector<double> between(double from, double to, double step) {
    const int n = std::max(1, static_cast<int>(std::ceil((to - from) / step)));
    std::vector<double> out;
    for (int k = 0; k <= n; ++k) out.push_back(from + (to - from) * k / n);
    return out;
}

// Two lanes that turn back into each other.
BeadLine turn(const BeadLine& out, BeadLine back) {
    std::reverse(back.points.begin(), back.points.end()), std::reverse(back.width.begin(), back.width.end());
    BeadLine all = out;
    all.points.insert(all.points.end(), back.points.begin(), back.points.end());
    all.width.insert(all.width.end(), back.width.begin(), back.width.end());
    return all;
}

} // namespace

Lanes lanes_across(const RingGraph& graph, std::uint32_t ring, double s, double width,
                   const std::function<bool(std::uint32_t)>& use) {
    Lanes out;
    const auto normal = across(graph, ring, s, width);
    if (!normal) return out;
    const Place own{ring, s, graph.at(ring, s), 0};
    out.place = {own};
    for (const double side : {-1.0, 1.0}) {
        if (side > 0) std::reverse(out.place.begin(), out.place.end()), out.own = out.place.size() - 1;
        while (true) {
            const auto hit =
                graph.first_hit(out.place.back().point, side * *normal, kNearLane * width / 2, kFarLane * width);
            if (!hit || hit->distance < kNearLane * width || !use(hit->ring)) break;
            out.place.push_back(*hit);
        }
    }
    return out;
}

std::optional<Strip> strip_along(const RingGraph& graph, const Lanes& lanes, double length, double width,
                                 const std::function<bool(const Window&)>& free) {
    const Place own = lanes.place[lanes.own];
    std::size_t lo = 0, hi = lanes.place.size(); // lanes that are left
    const int n = std::max(4, static_cast<int>(std::ceil(length / (kRungs * width))));
    std::vector<std::vector<Place>> rung;
    for (int j = 0; j <= n && hi - lo >= 3; ++j) {
        const double s = own.s + (static_cast<double>(j) / n - 0.5) * length;
        const auto normal = across(graph, own.ring, s, width);
        if (!normal) return std::nullopt;
        auto& r = rung.emplace_back(lanes.place.size());
        r[lanes.own] = {own.ring, s, graph.at(own.ring, s), 0};
        // whether lane k is where it should be, seen from the lane before
        const auto follows = [&](std::size_t k, std::size_t before, double side) {
            const auto hit = graph.first_hit(r[before].point, side * *normal, kNearLane * width / 2, kFarLane * width);
            if (!hit || hit->ring != lanes.place[k].ring || hit->distance < kNearLane * width) return false;
            r[k] = *hit;
            if (j == 0) return true;
            const double l = graph.length(hit->ring),
                         a = advance(rung[static_cast<std::size_t>(j) - 1][k].s, hit->s, l);
            const bool turned = j > 1 && a * advance(rung[0][k].s, rung[1][k].s, l) < 0;
            return !turned && std::abs(a) > kLeast * length / n && std::abs(a) < kMost * length / n;
        };
        for (std::size_t k = lanes.own; k-- > lo;)
            if (!follows(k, k + 1, -1)) lo = k + 1;
        for (std::size_t k = lanes.own + 1; k < hi; ++k)
            if (!follows(k, k - 1, 1)) hi = k;
    }
    const auto take = [&] {
        Strip strip;
        for (std::size_t k = lo; k < hi; ++k) strip.ring.push_back(lanes.place[k].ring);
        for (const auto& r : rung)
            strip.rung.emplace_back(r.begin() + static_cast<std::ptrdiff_t>(lo),
                                    r.begin() + static_cast<std::ptrdiff_t>(hi));
        return strip;
    };
    if (hi - lo < 3) return std::nullopt;
    const auto windows = windows_of(graph, take());
    const std::size_t first = lo;
    for (std::size_t k = lanes.own + 1; k-- > lo;)
        if (!free(windows[k - first])) lo = k + 1;
    for (std::size_t k = lanes.own; k < hi; ++k)
        if (!free(windows[k - first])) hi = k;
    if (hi < lo + 3) return std::nullopt;
    return take();
}

std::vector<Window> windows_of(const RingGraph& graph, const Strip& strip) {
    std::vector<Window> out;
    for (std::size_t k = 0; k < strip.ring.size(); ++k) {
        double length = 0; // signed
        for (std::size_t j = 0; j + 1 < strip.rung.size(); ++j)
            length += advance(strip.rung[j][k].s, strip.rung[j + 1][k].s, graph.length(strip.ring[k]));
        const double s = length > 0 ? strip.rung.front()[k].s : strip.rung.back()[k].s;
        out.push_back({strip.ring[k], s, s + std::abs(length)});
    }
    return out;
}

Splice double_spiral(const RingGraph& graph, const Strip& strip, double width) {
    const auto n = static_cast<std::uint32_t>(strip.ring.size());
    const Frame frame(graph, strip);
    double length = 0; // of the middle lane
    for (std::size_t j = 0; j + 1 < strip.rung.size(); ++j)
        length += geom::distance(strip.rung[j][n / 2].point, strip.rung[j + 1][n / 2].point);
    const Change change(static_cast<int>(n), std::min(0.4, kCloseUp * width / length));
    const double step = kStep * width / length, tip = change.tip();

    Splice out{windows_of(graph, strip), {}};
    // the rim of lane k at the strip's begin or end
    const auto rim = [&](std::uint32_t k, bool end) {
        const bool forwards = out.windows[k].s0 == strip.rung.front()[k].s;
        return Rim{k, end == forwards};
    };
    const auto lane = [&](int k) { return [&change, k](double x) { return change.lane(k, x); }; };
    const auto last = [&](int k) { return [&change, k](double x) { return change.from_end(k, x); }; };
    const auto inner_part = [](BeadLine b, bool first, bool end) {
        if (end) b.points.pop_back(), b.width.pop_back();
        if (first) b.points.erase(b.points.begin()), b.width.erase(b.width.begin());
        return b;
    };
    const auto squeezed = between(0, tip, step), growing = between(1 - tip, 1, step);
    out.links.push_back({rim(0, false), rim(1, false),
                         inner_part(turn(bead(frame, squeezed, lane(0)), bead(frame, squeezed, lane(1))), true, true)});
    auto reversed = growing;
    std::reverse(reversed.begin(), reversed.end());
    out.links.push_back({rim(n - 1, true), rim(n - 2, true),
                         inner_part(turn(bead(frame, reversed, last(0)), bead(frame, reversed, last(1))), true, true)});
    std::vector<double> all = between(0, 1 - tip, step);
    for (const auto& part : {between(1 - tip, tip, step), between(tip, 1, step)})
        all.insert(all.end(), part.begin() + 1, part.end());
    for (std::uint32_t k = 2; k < n; ++k)
        out.links.push_back(
            {rim(k, false), rim(k - 2, true), inner_part(bead(frame, all, lane(static_cast<int>(k))), true, true)});
    return out;
}

} // namespace filum::fill
