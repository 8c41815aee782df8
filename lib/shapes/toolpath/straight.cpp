#include "toolpath/reach.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace filum::toolpath {

namespace {

constexpr int kTries = 4; // attempts to reach farther with less deviation; the deviation never exceeds the tolerance
constexpr double kNearly = 1.05, kLess = 0.9;

// The directions from a place in which a straight move meets all of some discs.
class Wedge {
  public:
    // Restricts it to directions that meet the disc around `d` (from the place); false, without a change, if there are
    // none.
    bool take(Vec2 d, double radius) {
        const double away = geom::norm(d);
        if (away <= radius) return true;
        const double s = radius / away, c = std::sqrt(1 - s * s);
        const Vec2 u = (1 / away) * d, l{u.x * c - u.y * s, u.x * s + u.y * c}, r{u.x * c + u.y * s, u.y * c - u.x * s};
        if (!any_) {
            any_ = true;
            left_ = l;
            right_ = r;
            return true;
        }
        if (dot(u, left_) + dot(u, right_) <= 0 || geom::cross(left_, r) > 0 || geom::cross(right_, l) < 0)
            return false;
        if (geom::cross(left_, l) < 0) left_ = l;
        if (geom::cross(right_, r) > 0) right_ = r;
        return true;
    }
    [[nodiscard]] bool holds(Vec2 d) const {
        return !any_ ||
               (geom::cross(right_, d) >= 0 && geom::cross(left_, d) <= 0 && dot(left_, d) + dot(right_, d) > 0);
    }

  private:
    bool any_ = false;
    Vec2 left_, right_; // unit
};

// An upper bound of the Fréchet distance between the line and the straight move between both points; nothing if it
// exceeds `most`.
std::optional<double> distance_of(const Line& line, std::uint32_t from, std::uint32_t to, double most) {
    const Vec2 begin = line.points[from].xy(), way = line.points[to].xy() - begin;
    const double length = norm(way), most2 = most * most;
    const Vec2 u = length > 0 ? (1 / length) * way : Vec2{1, 0};
    // Along the move: the least possible position, and whether each point is opposite to the nearest remaining
    // position.
    double least = 0, reached = 0, worst2 = 0;
    for (std::uint32_t k = from + 1; k < to; ++k) {
        const Vec2 p = line.points[k].xy() - begin;
        const double s = dot(p, u), off = geom::cross(u, p), off2 = off * off;
        if (off2 > most2) return std::nullopt;
        const double half = std::sqrt(most2 - off2);
        least = std::max(s - half, least);
        if (least > std::min(s + half, length)) return std::nullopt;
        reached = std::min(std::max(s, reached), length);
        worst2 = std::max(worst2, off2 + (s - reached) * (s - reached));
    }
    return std::min(most, std::sqrt(worst2));
}

std::uint32_t reach_within(const Line& line, std::uint32_t from, std::uint32_t last, const Tolerance& t, double& off) {
    const double most = t.path * (1 - 1e-9); // leaves room for rounding
    const Vec2 begin = line.points[from].xy();
    Wedge wedge;
    Section section(line, from, t.section);
    std::uint32_t best = from + 1;
    for (std::uint32_t k = from + 1; k <= last && wedge.take(line.points[k].xy() - begin, most); ++k) {
        section.take(k);
        if (!section.any()) break;
        if (section.suits() && wedge.holds(line.points[k].xy() - begin)) best = k;
    }
    for (; best > from + 1; best = from + 1 + (best - from - 1) / 2) {
        const auto d = distance_of(line, from, best, t.path);
        // The same volume on a shorter chord is thicker.
        const double given = line.at[best] - line.at[from];
        if (!d || given > (1 + t.section) * geom::distance(begin, line.points[best].xy())) continue;
        off = *d;
        break;
    }
    return best;
}

} // namespace

std::uint32_t straight_reach(const Line& line, std::uint32_t from, std::uint32_t last, const Tolerance& t,
                             double& off) {
    Tolerance now = t;
    std::uint32_t to = from + 1;
    for (int k = 0; k < kTries; ++k) {
        off = 0;
        to = reach_within(line, from, last, now, off);
        // rounding moves ends by as much as the grid, so a chord may always deviate by that
        const double may =
            std::max(t.path * full_share(line, from, line.at[to] - line.at[from]), std::min(t.path, t.grid));
        if (off <= may * kNearly) break;
        // On a circle the length is proportional to the root of the deviation, and `may` falls with the length; so
        // off / may is proportional to the deviation to the power 3/2.
        now.path = std::min(std::pow(may / off, 2.0 / 3), kLess) * now.path;
    }
    return to;
}

} // namespace filum::toolpath
