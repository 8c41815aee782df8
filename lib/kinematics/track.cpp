#include "kinematics/track.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::kinematics {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kUpright = 1e-9; // rad: tilts below have no heading at all

// `angle` plus the whole turns that bring it next to `to`.
double beside(double angle, double to) { return angle + kTurn * std::round((to - angle) / kTurn); }

struct Way {
    double cost = 0, turn = 0, tilt = 0;
    int from = 0; // way of the pose before
};

// The least travel of both rotary axes over all poses with a heading; others repeat their predecessor's.
std::vector<std::array<Way, 2>> programme(const Chain& c, std::span<const Pose> poses, const Joints& before) {
    std::vector<std::array<Way, 2>> all(poses.size());
    std::array<Way, 2> last{Way{0, before.turn, before.tilt, 0}, Way{0, before.turn, before.tilt, 1}};
    bool begun = false;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const bool heading = std::hypot(poses[i].axis.x, poses[i].axis.y) > kUpright;
        const auto ways = inverse(c, poses[i]);
        for (int k = 0; k < 2; ++k) {
            Way best{std::numeric_limits<double>::infinity(), 0, 0, 0};
            for (int from = 0; from < 2; ++from) {
                const Way& w = last[static_cast<std::size_t>(from)];
                const Joints& j = ways[static_cast<std::size_t>(k)];
                const double turn = heading ? beside(j.turn, w.turn) : w.turn, tilt = heading ? j.tilt : 0;
                if (!heading && begun && from != k) continue;
                const double cost = w.cost + std::abs(turn - w.turn) + std::abs(tilt - w.tilt);
                if (cost < best.cost) best = {cost, turn, tilt, from};
            }
            all[i][static_cast<std::size_t>(k)] = best;
        }
        last = all[i];
        begun = begun || heading;
    }
    return all;
}

std::vector<double> turns(const std::vector<std::array<Way, 2>>& all) {
    std::vector<double> out(all.size());
    auto k = static_cast<std::size_t>(all.back()[1].cost < all.back()[0].cost ? 1 : 0);
    for (std::size_t i = all.size(); i-- > 0;) {
        out[i] = all[i][k].turn;
        k = static_cast<std::size_t>(all[i][k].from);
    }
    return out;
}

// How far the turn may be off at a pose, rad.
double play(const Pose& p, double tolerance) {
    const double tilt = angle(p.axis, {0, 0, 1});
    if (!(tolerance > 0)) return 0;
    if (tilt <= tolerance) return std::numeric_limits<double>::infinity();
    return tolerance / std::sin(std::min(tilt, 1.5)) * std::clamp((8 * tolerance - tilt) / (4 * tolerance), 0.0, 1.0);
}

// The shortest line over `at` (ascending) that stays within [low, high] at each; its ends are given by low = high
// there, or free.  (Taut string, by the funnel of both hulls.)
std::vector<double> taut(std::span<const double> at, std::span<const double> low, std::span<const double> high,
                         double begin) {
    const std::size_t n = at.size();
    std::vector<double> out(n);
    std::size_t i = 0;
    double y = std::clamp(begin, low[0], high[0]);
    out[0] = y;
    while (i + 1 < n) {
        // The slopes under which all from i + 1 to j are seen.
        double least = -std::numeric_limits<double>::infinity(), most = -least;
        std::size_t at_least = i + 1, at_most = i + 1, j = i + 1;
        double slope = 0;
        std::size_t end = n;
        for (; j < n; ++j) {
            const double d = std::max(at[j] - at[i], 1e-12), lo = (low[j] - y) / d, hi = (high[j] - y) / d;
            if (lo > most) {
                slope = most, end = at_most;
                break;
            }
            if (hi < least) {
                slope = least, end = at_least;
                break;
            }
            if (lo >= least) least = lo, at_least = j;
            if (hi <= most) most = hi, at_most = j;
        }
        if (end == n)
            slope = std::clamp(0.0, least, most), end = slope == 0 ? n - 1 : slope == least ? at_least : at_most;
        const double from = at[i], start = y;
        for (++i;; ++i) {
            out[i] = std::clamp(start + slope * (at[i] - from), low[i], high[i]);
            if (i >= end) break;
        }
        y = out[i];
    }
    return out;
}

void loosen(std::span<const Pose> poses, double tolerance, double before, std::vector<double>& turn) {
    const std::size_t n = poses.size();
    std::vector<double> at(n, 0), low(n), high(n);
    bool any = false;
    for (std::size_t i = 0; i < n; ++i) {
        if (i > 0) at[i] = at[i - 1] + std::max(geom::distance(poses[i - 1].tip, poses[i].tip), 1e-9);
        const double p = play(poses[i], tolerance);
        any = any || p > 0;
        low[i] = turn[i] - p, high[i] = turn[i] + p;
    }
    if (any) turn = taut(at, low, high, before);
}

// Whole turns that bring the track into its limits, if any do.
double unwound(const std::vector<double>& turn, const Limits& limits) {
    const auto [lo, hi] = std::minmax_element(turn.begin(), turn.end());
    if (*lo < limits.turn_min) return kTurn * std::ceil((limits.turn_min - *lo) / kTurn);
    if (*hi > limits.turn_max) return -kTurn * std::ceil((*hi - limits.turn_max) / kTurn);
    return 0;
}

} // namespace

Track track(const Chain& chain, std::span<const Pose> poses, const Joints& before, double tolerance,
            const Limits& limits) {
    Track out;
    if (poses.empty()) return out;
    auto turn = turns(programme(chain, poses, before));
    loosen(poses, tolerance, before.turn, turn);
    const double shift = unwound(turn, limits);
    out.stuck = poses.size();
    out.joints.reserve(poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const double t = turn[i] + shift, tilt = best_tilt(chain, poses[i].axis, t);
        out.joints.push_back(place(chain, poses[i].tip, tilt, t));
        const double off = angle(forward(chain, out.joints.back()).axis, poses[i].axis);
        if (off > out.off) out.off = off, out.off_at = i;
        const bool turned_out = t < limits.turn_min || t > limits.turn_max;
        if (out.stuck == poses.size() && (turned_out || tilt < limits.tilt_min || tilt > limits.tilt_max)) {
            out.stuck = i;
            out.why = turned_out ? "the turn axis would leave its limits" : "the tilt axis would leave its limits";
        }
    }
    return out;
}

} // namespace filum::kinematics
