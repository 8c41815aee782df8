// Thins and moves the beads beside a lane, so that the amount of material stays the same.
#include "geom/segment.hpp"
#include "geom/segment_grid.hpp"
#include "link3d/bead.hpp"
#include "toolpath/grid.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace filum::link3d {

namespace {

constexpr double kRoom = 0.3;          // bead widths that must be free beyond a bead that moves aside
constexpr double kSlope = 0.25;        // mm per mm; most that the shift of a bead may change along it
constexpr double kSelfDistance = 0.02; // bead widths; nearer lines are the bead itself

// The area that one place of the bead gives to the lane.
struct Share {
    std::uint32_t segment;
    double t, area;
    Vec2 away; // unit vector away from the lane
};

// The segments of a bead whose boxes come within `reach` of that of a lane, in a grid.
class BeadBeside {
  public:
    BeadBeside(const std::vector<Vec2>& bead, std::span<const Vec2> lane, double reach) : grid_({}, reach) {
        Box2 box;
        for (const Vec2 p : lane) box.add(p);
        box = {box.lo - Vec2{reach, reach}, box.hi + Vec2{reach, reach}};
        for (std::uint32_t i = 0; i + 1 < bead.size(); ++i) {
            Box2 own;
            own.add(bead[i]);
            own.add(bead[i + 1]);
            if (!meet(own, box)) continue;
            segments_.push_back({bead[i], bead[i + 1]});
            number_.push_back(i);
        }
        grid_ = geom::SegmentGrid(segments_, reach);
    }
    // Calls f(number, from, to) for every segment in reach of p, possibly several times.
    template <class F>
    void near(Vec2 p, double reach, F&& f) const {
        grid_.near(p - Vec2{reach, reach}, p + Vec2{reach, reach},
                   [&](std::uint32_t k) { f(number_[k], segments_[k].a, segments_[k].b); });
    }

  private:
    std::vector<geom::Segment> segments_;
    std::vector<std::uint32_t> number_; // of each segment, along the bead
    geom::SegmentGrid grid_;
};

// The nearest places of the bead to the left and to the right of point m of the lane, which runs along d.
void find_beside(const BeadBeside& bead, Vec2 m, Vec2 d, double reach, std::array<double, 2>& near,
                 std::array<Share, 2>& side) {
    bead.near(m, reach, [&](std::uint32_t s, Vec2 a, Vec2 b) {
        const double t = geom::nearest_parameter(a, b, m);
        const Vec2 q = geom::lerp(a, b, t) - m;
        const std::size_t which = geom::cross(d, q) > 0 ? 0 : 1;
        const double e = geom::norm(q);
        if (e > near[which] || e >= reach || (e == near[which] && s >= side[which].segment)) return;
        near[which] = e;
        side[which] = {s, t, 0, e > 0 ? (1 / e) * q : Vec2{}};
    });
}

// The places of the bead that make room for the lane, in the order of the bead.
std::vector<Share> shares(const Bead& bead, std::span<const Vec2> lane, double lane_width, double reach) {
    const BeadBeside beside(bead.points, lane, reach);
    std::vector<Share> out;
    for (std::size_t i = 0; i + 1 < lane.size(); ++i) {
        const Vec2 d = lane[i + 1] - lane[i];
        const double l = geom::norm(d);
        const auto pieces = static_cast<std::size_t>(std::ceil(l / (reach / 16)));
        for (std::size_t k = 0; k < pieces; ++k) {
            const Vec2 m =
                geom::lerp(lane[i], lane[i + 1], (static_cast<double>(k) + 0.5) / static_cast<double>(pieces));
            std::array<double, 2> near{reach, reach};
            std::array<Share, 2> side{};
            find_beside(beside, m, d, reach, near, side);
            const int found = static_cast<int>(near[0] < reach) + static_cast<int>(near[1] < reach);
            for (std::size_t w = 0; w < 2; ++w)
                if (near[w] < reach) {
                    side[w].area = lane_width * l / static_cast<double>(pieces) / found;
                    out.push_back(side[w]);
                }
        }
    }
    std::sort(out.begin(), out.end(), [](const Share& a, const Share& b) {
        return std::tie(a.segment, a.t, a.area) < std::tie(b.segment, b.t, b.area);
    });
    return out;
}

// A bead, split where it gives up material.
struct ThinnedBead {
    Bead bead;
    std::vector<double> take; // mm2 per point
    std::vector<Vec2> away;   // directions away from the lane, weighted by the area taken

    void push(Vec2 p, double w) {
        bead.points.push_back(p);
        bead.width.push_back(w);
        take.push_back(0);
        away.emplace_back();
    }
    void share(std::size_t i, const Share& s, double part) {
        take[i] += part * s.area;
        away[i] = away[i] + part * s.area * s.away;
    }
    // mm of the bead that belong to the point: half of both segments
    [[nodiscard]] double mass(std::size_t i) const {
        const auto& p = bead.points;
        return ((i > 0 ? geom::distance(p[i - 1], p[i]) : 0) +
                (i + 1 < p.size() ? geom::distance(p[i], p[i + 1]) : 0)) /
               2;
    }
};

ThinnedBead split_at_shares(const Bead& bead, const std::vector<Share>& cuts, double step) {
    ThinnedBead out;
    const auto width = [&](std::size_t i) { return bead.width.size() == 1 ? bead.width[0] : bead.width[i]; };
    out.push(bead.points[0], width(0));
    auto next = cuts.begin();
    for (std::size_t i = 0; i + 1 < bead.points.size(); ++i) {
        const double l = geom::distance(bead.points[i], bead.points[i + 1]);
        const bool hit = next != cuts.end() && next->segment == i;
        const auto pieces = hit ? std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(l / step))) : 1;
        for (std::size_t k = 1; k <= pieces; ++k) {
            const double t = static_cast<double>(k) / static_cast<double>(pieces);
            out.push(k == pieces ? bead.points[i + 1] : geom::lerp(bead.points[i], bead.points[i + 1], t),
                     width(i) + t * (width(i + 1) - width(i)));
        }
        for (; next != cuts.end() && next->segment == i; ++next) {
            const double at = next->t * static_cast<double>(pieces);
            const auto k = std::min(static_cast<std::size_t>(at), pieces - 1);
            const std::size_t a = out.take.size() - 1 - pieces + k;
            out.share(a, *next, 1 - (at - static_cast<double>(k)));
            out.share(a + 1, *next, at - static_cast<double>(k));
        }
    }
    return out;
}

// Limits what each point gives, so that no width falls below `least` times its value. The rest moves on along the bead,
// then back.
void settle(ThinnedBead& t, double least) {
    double carry = 0;
    const auto give = [&](std::size_t i) {
        const double can = std::max(0.0, (1 - least) * t.bead.width[i] * t.mass(i));
        carry += t.take[i];
        t.take[i] = std::min(can, carry);
        carry -= t.take[i];
    };
    for (std::size_t i = 0; i < t.take.size(); ++i) give(i);
    for (std::size_t i = t.take.size(); i-- > 0;) give(i);
}

// Moves points back to `from` where the bead would cross itself.
void stay_apart(const std::vector<Vec2>& from, double cell, std::vector<Vec2>& to) {
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& [s, t] : toolpath::crossing_pairs({{false, to, {1}}}, cell))
            for (const std::uint32_t i : {s, s + 1, t, t + 1}) {
                changed = changed || to[i] != from[i];
                to[i] = from[i];
            }
    }
}

// The moved points of the bead: each moves away from the lane by half of `less`, its loss of width in mm, so that the
// far edge stays in place. Points stay where `lines` leave no room, or where the bead would fold or cross itself. The
// ends and a point at `fixed` stay too.
std::vector<Vec2> aside(const ThinnedBead& t, const std::vector<double>& less, double reach, const SegmentCells& lines,
                        std::optional<Vec2> fixed) {
    const auto& from = t.bead.points;
    const std::size_t n = from.size();
    std::vector<Vec2> to(n); // of length 1
    std::vector<double> by(n, 0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double l = geom::norm(t.away[i]);
        if (l == 0 || less[i] == 0 || (fixed && geom::distance(*fixed, from[i]) <= kSamePoint)) continue;
        to[i] = (1 / l) * t.away[i];
        if (is_free(lines, from[i], from[i] + (less[i] + kRoom * reach) * to[i], kSamePoint, kSelfDistance * reach, 0))
            by[i] = less[i] / 2;
    }
    const auto slope = [&](std::size_t i, std::size_t beside) {
        by[i] = std::min(by[i], by[beside] + kSlope * geom::distance(from[i], from[beside]));
    };
    for (std::size_t i = 1; i < n; ++i) slope(i, i - 1);
    for (std::size_t i = n - 1; i-- > 0;) slope(i, i + 1);
    std::vector<Vec2> out = from;
    for (std::size_t i = 0; i < n; ++i) out[i] = from[i] + by[i] * to[i];
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i + 1 < n; ++i) {
            const Vec2 was = from[i + 1] - from[i], is = out[i + 1] - out[i];
            if (is == was || geom::dot(was, is) >= 0.8 * geom::dot(was, was)) continue;
            out[i] = from[i];
            out[i + 1] = from[i + 1];
            changed = true;
        }
    }
    stay_apart(from, reach, out);
    return out;
}

} // namespace

double thin_beside(Bead& bead, std::span<const Vec2> lane, double lane_width, double reach, double least,
                   const SegmentCells& lines, std::optional<Vec2> fixed) {
    ThinnedBead t = split_at_shares(bead, shares(bead, lane, lane_width, reach), reach / 2);
    settle(t, least);
    const std::size_t n = t.take.size();
    std::vector<double> less(n, 0), mass(n);
    for (std::size_t i = 0; i < n; ++i)
        if ((mass[i] = t.mass(i)) > 0) less[i] = t.take[i] / mass[i];
    t.bead.points = aside(t, less, reach, lines, fixed);
    for (std::size_t i = 0; i < n; ++i)
        if (const double now = t.mass(i); now > 0) t.bead.width[i] = (t.bead.width[i] - less[i]) * mass[i] / now;
    bead = std::move(t.bead);
    return std::accumulate(t.take.begin(), t.take.end(), 0.0);
}

} // namespace filum::link3d
