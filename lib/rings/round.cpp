#include "rings/round.hpp"

#include "geom/segment.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

namespace filum::rings {

namespace {

constexpr double kReach = 0.4;   // of the bead's width, along the line on each side
constexpr double kTurning = 1.0; // rad within one reach: the radius is smaller than that
constexpr int kSamples = 4;      // points per reach
constexpr double kWiden = 1.5;   // times the width, at most
constexpr double kGrid = 1e3;    // per mm
constexpr double kClose = 1e-6;  // mm: nearer points are one

BeadLine empty_like(const BeadLine& line) {
    BeadLine out;
    out.points.reserve(line.size()), out.width.reserve(line.size()), out.depth.reserve(line.size());
    return out;
}

// The closed line from the middle of its longest segment on, where it hardly turns.
BeadLine from_longest(const BeadLine& line) {
    const std::size_t n = line.size();
    std::size_t longest = 0;
    double most = -1;
    for (std::size_t i = 0; i < n; ++i)
        if (const double l = geom::distance(line.points[i], line.points[i + 1 == n ? 0 : i + 1]); l > most)
            most = l, longest = i;
    const std::size_t j = longest + 1 == n ? 0 : longest + 1;
    BeadLine out = empty_like(line);
    out.add(geom::lerp(line.points[longest], line.points[j], 0.5), std::lerp(line.width[longest], line.width[j], 0.5),
            std::lerp(line.depth[longest], line.depth[j], 0.5));
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = (j + k) % n;
        out.add(line.points[i], line.width[i], line.depth[i]);
    }
    return out;
}

// A closed line by arc length.
struct Course {
    const BeadLine* line;
    std::vector<double> s; // of each point, and of the first one again
    std::vector<Vec2> sum; // of what lies before each point, times mm
};

Course course_of(const BeadLine& line) {
    const std::size_t n = line.size();
    Course out{&line, {0}, {Vec2{}}};
    out.s.reserve(n + 1), out.sum.reserve(n + 1);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = line.points[i], b = line.points[i + 1 == n ? 0 : i + 1];
        const double l = geom::distance(a, b);
        out.s.push_back(out.s.back() + l);
        out.sum.push_back(out.sum.back() + l * geom::lerp(a, b, 0.5));
    }
    return out;
}

struct Place {
    std::size_t segment = 0;
    Vec2 point, sum;
    double width = 0, depth = 0;
};

// 0 <= s <= the line's length; `near`: a segment before it.
Place place(const Course& c, double s, std::size_t near) {
    const std::size_t n = c.line->size();
    std::size_t i = near;
    while (i + 1 < n && c.s[i + 1] < s) ++i;
    const std::size_t j = i + 1 == n ? 0 : i + 1;
    const double l = c.s[i + 1] - c.s[i], t = l > 0 ? std::clamp((s - c.s[i]) / l, 0.0, 1.0) : 0;
    const Vec2 p = geom::lerp(c.line->points[i], c.line->points[j], t);
    return {i, p, c.sum[i] + (t * l) * geom::lerp(c.line->points[i], p, 0.5),
            std::lerp(c.line->width[i], c.line->width[j], t), std::lerp(c.line->depth[i], c.line->depth[j], t)};
}

struct Corner {
    double s, reach;
};

// Vertices about which the line turns too tightly, ascending.
std::vector<Corner> corners(const Course& c) {
    const auto& p = c.line->points;
    const std::size_t n = p.size();
    std::vector<double> turn(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 u = p[i] - p[i == 0 ? n - 1 : i - 1], v = p[i + 1 == n ? 0 : i + 1] - p[i];
        turn[i] = std::abs(std::atan2(cross(u, v), dot(u, v)));
    }
    std::vector<Corner> out;
    for (std::size_t i = 0; i < n; ++i) {
        const double reach = std::min({kReach * c.line->width[i], c.s[i], c.s[n] - c.s[i]});
        double turned = turn[i];
        for (std::size_t k = i; k-- > 0 && c.s[i] - c.s[k] <= reach / 2;) turned += turn[k];
        for (std::size_t k = i + 1; k < n && c.s[k] - c.s[i] <= reach / 2; ++k) turned += turn[k];
        if (turned > kTurning && reach > 0) out.push_back({c.s[i], reach});
    }
    return out;
}

class Rounding {
  public:
    explicit Rounding(const BeadLine& line) : line_(from_longest(line)), course_(course_of(line_)) {}

    BeadLine run() {
        const auto all = corners(course_);
        out_ = empty_like(line_);
        const std::size_t n = line_.size();
        std::size_t next = 0; // vertex
        for (std::size_t k = 0; k < all.size();) {
            // corners whose surroundings overlap, with the reach that shrinks to nothing on both sides of them
            std::size_t end = k + 1;
            double last = all[k].s + 2 * all[k].reach, first = all[k].s - 2 * all[k].reach;
            for (; end < all.size() && all[end].s - 2 * all[end].reach < last; ++end) {
                first = std::min(first, all[end].s - 2 * all[end].reach);
                last = std::max(last, all[end].s + 2 * all[end].reach);
            }
            for (; next < n && course_.s[next] <= first; ++next)
                out_.add(line_.points[next], line_.width[next], line_.depth[next]);
            stretch({all.data() + k, end - k}, std::max(0.0, first), std::min(last, course_.s[n]));
            while (next < n && course_.s[next] < last) ++next;
            k = end;
        }
        for (; next < n; ++next) out_.add(line_.points[next], line_.width[next], line_.depth[next]);
        return std::move(out_);
    }

  private:
    void stretch(std::span<const Corner> about, double first, double last) {
        std::vector<double> at;
        for (const Corner& c : about)
            for (int k = -kSamples; k <= kSamples; ++k) at.push_back(c.s + c.reach * k / kSamples);
        const auto from = std::lower_bound(course_.s.begin(), course_.s.end(), first);
        for (auto it = from; it != course_.s.end() && *it < last; ++it) at.push_back(*it);
        std::sort(at.begin(), at.end());
        const double whole = course_.s.back();
        double before = -1;
        auto near = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, from - course_.s.begin() - 1));
        for (const double s : at) {
            if (s <= first || s >= last || s - before < kClose) continue;
            double reach = 0;
            for (const Corner& c : about) reach = std::max(reach, std::min(c.reach, 2 * c.reach - std::abs(s - c.s)));
            reach = std::min({reach, s, whole - s});
            if (reach < kClose) continue;
            add_mean(s, reach, near);
            before = s;
        }
    }

    void add_mean(double s, double reach, std::size_t& near) {
        while (near > 0 && course_.s[near] > s - reach) --near;
        const Place a = place(course_, s - reach, near), b = place(course_, s + reach, a.segment);
        near = a.segment;
        const Place own = place(course_, s, a.segment);
        const Vec2 p = (1 / (2 * reach)) * (b.sum - a.sum);
        const double slower = 2 * reach / std::max(kClose, geom::distance(a.point, b.point));
        double moved = reach; // to the line that it has been moved away from
        for (std::size_t i = a.segment; i <= b.segment; ++i)
            moved = std::min(moved, geom::point_segment_distance(line_.points[i], line_.points[(i + 1) % line_.size()], p));
        const bool inwards = cross(own.point - a.point, b.point - own.point) >= 0; // solid is on the left
        const double depth = inwards ? own.depth + moved : own.depth - moved;
        const double most = own.depth < own.width ? 2 * depth : kWiden * own.width;
        out_.add(p, std::max(own.width, std::min(own.width * std::min(slower, kWiden), most)), depth);
    }

    BeadLine line_;
    Course course_;
    BeadLine out_;
};

Vec2 snapped(Vec2 p) { return {std::round(p.x * kGrid) / kGrid, std::round(p.y * kGrid) / kGrid}; }

// Divides what a machine lays with one width into pieces whose edges are off by at most `tolerance`.
void add_divided(BeadLine& out, Vec2 p, double width, double depth, double tolerance) {
    const int n = std::max(1, static_cast<int>(std::ceil(std::abs(width - out.width.back()) / (4 * tolerance))));
    const Vec2 q = out.points.back();
    const double w = out.width.back(), d = out.depth.back();
    for (int k = 1; k <= n; ++k) {
        const double t = static_cast<double>(k) / n;
        const Vec2 r = k == n ? p : snapped(geom::lerp(q, p, t));
        if (k < n && (r == out.points.back() || r == p)) continue;
        out.add(r, std::lerp(w, width, t), std::lerp(d, depth, t));
    }
}

} // namespace

BeadLine rounded(const BeadLine& line) { return line.size() < 3 ? line : Rounding(line).run(); }

static const double wt = getenv("WT") ? atof(getenv("WT")) : 0.01;
BeadLine thinned(const BeadLine& line, double tolerance) {
    const std::size_t n = line.size();
    BeadLine out = empty_like(line);
    if (n < 3) return line;
    out.add(snapped(line.points[0]), line.width[0], line.depth[0]);
    const auto within = [&](std::size_t a, std::size_t b) { // all points between lie on the chord
        const Vec2 p = line.points[a], q = line.points[b % n];
        const double l2 = geom::norm2(q - p);
        for (std::size_t i = a + 1; i < b; ++i) {
            const double off = std::min(tolerance, line.width[i] / 8);
            const double t = l2 > 0 ? std::clamp(dot(line.points[i] - p, q - p) / l2, 0.0, 1.0) : 0;
            if (geom::norm2(geom::lerp(p, q, t) - line.points[i]) > off * off) return false;
            if (std::abs(line.width[i] - std::lerp(line.width[a], line.width[b % n], t)) > 2 * wt) return false;
        }
        return true;
    };
    for (std::size_t a = 0; a < n;) {
        std::size_t b = a + 1;
        while (b < n && within(a, b + 1)) ++b;
        const Vec2 p = snapped(line.points[b % n]);
        if (b < n && p != out.points.back()) add_divided(out, p, line.width[b], line.depth[b], wt);
        a = b;
    }
    while (out.size() > 3 && out.points.back() == out.points.front())
        out.points.pop_back(), out.width.pop_back(), out.depth.pop_back();
    return out;
}

} // namespace filum::rings
