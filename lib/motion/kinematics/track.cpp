#include "kinematics/track.hpp"

#include "geom/angle.hpp"

#include <algorithm>
#include <cmath>

namespace filum::kinematics {

namespace {

constexpr double kTrackSlack = 1e-8; // rad beyond limits: slightly more than configurations() allows
constexpr double kTaut = 0.95;       // share of the tolerance used at poses; the rest is for the way between them

// Tolerance of the turn at a pose, rad.
double play(const Pose& p, double allowed) {
    const double tolerance = kTaut * allowed;
    const double tilt = angle(p.axis, {0, 0, 1});
    if (!(tolerance > 0)) return 0;
    if (tilt <= tolerance) return std::numeric_limits<double>::infinity();
    return tolerance / std::sin(std::min(tilt, 1.5)) * std::clamp((8 * tolerance - tilt) / (4 * tolerance), 0.0, 1.0);
}

// The shortest line over `at` (ascending) within [low, high] everywhere; its ends are fixed by low = high there, or
// free. (Taut string, by the funnel of both hulls.)
std::vector<double> taut(std::span<const double> at, std::span<const double> low, std::span<const double> high,
                         double begin) {
    const std::size_t n = at.size();
    std::vector<double> out(n);
    std::size_t i = 0;
    double y = std::clamp(begin, low[0], high[0]);
    out[0] = y;
    while (i + 1 < n) {
        // The range of slopes at which all from i + 1 to j are visible.
        double least = -std::numeric_limits<double>::infinity(), most = -least;
        std::size_t at_least = i + 1, at_most = i + 1, j = i + 1;
        double slope = 0;
        std::size_t end = n;
        for (; j < n; ++j) {
            const double d = std::max(at[j] - at[i], 1e-12), lo = (low[j] - y) / d, hi = (high[j] - y) / d;
            if (lo > most) {
                slope = most;
                end = at_most;
                break;
            }
            if (hi < least) {
                slope = least;
                end = at_least;
                break;
            }
            if (lo >= least) {
                least = lo;
                at_least = j;
            }
            if (hi <= most) {
                most = hi;
                at_most = j;
            }
        }
        if (end == n) {
            slope = std::clamp(0.0, least, most);
            end = slope == 0 ? n - 1 : slope == least ? at_least : at_most;
        }
        const double from = at[i], start = y;
        for (++i;; ++i) {
            out[i] = std::clamp(start + slope * (at[i] - from), low[i], high[i]);
            if (i >= end) break;
        }
        y = out[i];
    }
    return out;
}

void loosen(std::span<const Pose> poses, double tolerance, double before, const Limits& limits,
            std::span<double> turn) {
    const std::size_t n = poses.size();
    std::vector<double> at(n, 0), low(n), high(n);
    bool any = false;
    for (std::size_t i = 0; i < n; ++i) {
        if (i > 0) at[i] = at[i - 1] + std::max(geom::distance(poses[i - 1].tip, poses[i].tip), 1e-9);
        const double p = play(poses[i], tolerance);
        any = any || p > 0;
        low[i] = std::min(std::max(turn[i] - p, limits.turn_min), turn[i]);
        high[i] = std::max(std::min(turn[i] + p, limits.turn_max), turn[i]);
    }
    if (any) std::ranges::copy(taut(at, low, high, before), turn.begin());
}

// On the axis of a polar machine the tip stays while the turn axis rotates to the direction in which the way
// continues.
void spin_on_axis(std::span<const Pose> poses, const Chain& c, std::span<double> turn) {
    for (std::size_t i = turn.size() - 1; i-- > 1;)
        if (distance(poses[i].tip, poses[i - 1].tip) == 0 && distance(poses[i].tip.xy(), c.turn_point.xy()) < kOnAxis)
            turn[i] = turn[i + 1];
}

// The tilt, limited if it exceeds a limit by the tolerance at most.
double clipped(double tilt, double tolerance, const Limits& l) {
    if (tilt < l.tilt_min && tilt >= l.tilt_min - tolerance - kTrackSlack) return l.tilt_min;
    if (tilt > l.tilt_max && tilt <= l.tilt_max + tolerance + kTrackSlack) return l.tilt_max;
    return tilt;
}

} // namespace

Track track(const Chain& chain, std::span<const Pose> poses, const Joints& before, double tolerance,
            const Limits& limits, std::span<const Lifting> lifting) {
    Track out;
    if (poses.empty()) return out;
    const Configurations found = configurations(chain, poses, before, tolerance, limits, lifting);
    out.stuck = found.stuck;
    if (found.stuck < poses.size()) {
        const auto both = inverse(chain, poses[found.stuck]);
        const auto tilts = [&](const Joints& j) {
            return j.tilt >= limits.tilt_min - tolerance && j.tilt <= limits.tilt_max + tolerance;
        };
        out.why = tilts(both[0]) || tilts(both[1]) ? "the turn axis would leave its limits"
                                                   : "the tilt axis would leave its limits";
        return out;
    }
    std::vector<double> turn;
    for (std::size_t i = 0; i < found.stops.size();) {
        const std::size_t first = found.stops[i].pose;
        turn.assign(1, found.stops[i].turn);
        for (++i; i < found.stops.size() && !found.stops[i].lifted; ++i) turn.push_back(found.stops[i].turn);
        const auto part = poses.subspan(first, turn.size());
        if (chain.carrier == Carrier::polar)
            spin_on_axis(part, chain, turn);
        else
            loosen(part, tolerance, first == 0 ? geom::unwrapped(before.turn, turn[0]) : turn[0], limits, turn);
        TrackStretch piece{first, {}};
        piece.joints.reserve(turn.size());
        for (std::size_t k = 0; k < turn.size(); ++k) {
            const double wanted = best_tilt(chain, part[k].axis, turn[k]), tilt = clipped(wanted, tolerance, limits);
            piece.joints.push_back(place(chain, part[k].tip, tilt, turn[k]));
            const double off = angle(tool_axis(chain, tilt, turn[k]), part[k].axis);
            if (off > out.off) {
                out.off = off;
                out.off_at = first + k;
            }
            if (std::abs(wanted - tilt) > out.clipped) {
                out.clipped = std::abs(wanted - tilt);
                out.clipped_at = first + k;
            }
            const bool turned_out = turn[k] < limits.turn_min - kTrackSlack || turn[k] > limits.turn_max + kTrackSlack;
            if (out.stuck == poses.size() &&
                (turned_out || tilt < limits.tilt_min - kTrackSlack || tilt > limits.tilt_max + kTrackSlack)) {
                out.stuck = first + k;
                out.why = turned_out ? "the turn axis would leave its limits" : "the tilt axis would leave its limits";
            }
        }
        out.pieces.push_back(std::move(piece));
    }
    return out;
}

} // namespace filum::kinematics
