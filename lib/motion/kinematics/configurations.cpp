#include "kinematics/configurations.hpp"

#include "geom/angle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::kinematics {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kUpright = 1e-9;    // rad: smaller tilts have no heading
constexpr double kRouteSlack = 1e-9; // rad, mm, beyond limits
constexpr double kInf = std::numeric_limits<double>::infinity();
// Cost of a break in rad of travel, by Lifting: more than the axes of any stroke travel.
constexpr double kBreak[] = {0, 1e7, 1.01e7, 1.1e7};
constexpr double kMostTurns = 4000;
constexpr std::uint16_t kNowhere = 0xffff, kLifted = 0x8000;

// The two configurations at one pose.
struct PoseStates {
    std::array<double, 2> turn{}, tilt{};
    std::array<bool, 2> able{};
    bool free = false; // the turn is that of the pose before
};

// Dynamic programming over the poses of a stroke.
class ConfigurationSearch {
  public:
    ConfigurationSearch(const Chain& c, std::span<const Pose> poses, const Joints& before, double lean,
                        const Limits& limits, std::span<const Lifting> lifting, bool bounded)
        : c_(c), poses_(poses), before_(before), lean_(lean), limits_(limits), lifting_(lifting), bounded_(bounded) {
        if (!bounded_) return;
        lowest_ = static_cast<int>(std::floor(limits.turn_min / kTurn)) - 1;
        turns_ = static_cast<int>(std::floor(limits.turn_max / kTurn)) + 2 - lowest_;
    }

    Configurations run() {
        Configurations out;
        const std::size_t states = 2 * static_cast<std::size_t>(turns_);
        std::vector<State> last{{0, std::clamp(before_.turn, limits_.turn_min, limits_.turn_max), before_.tilt}}, now;
        PoseStates stand{{last[0].turn, last[0].turn}, {}, {}, true};
        for (std::size_t i = 0; i < poses_.size(); ++i) {
            stand = stand_at(i, stand);
            now.assign(states, {});
            from_.resize((i + 1) * states, kNowhere);
            for (std::size_t s = 0; s < last.size(); ++s)
                if (last[s].cost < kInf) reach(i, stand, s, last[s], now);
            if (i == 0 && bounded_ && (lifting_.empty() || lifting_[0] == Lifting::air)) begin_anywhere(stand, now);
            lift(i, stand, now);
            if (std::none_of(now.begin(), now.end(), [](const State& s) { return s.cost < kInf; })) break;
            last.swap(now);
            stands_.push_back(stand);
        }
        out.stuck = stands_.size();
        if (out.stuck > 0) trace(last, out);
        return out;
    }

  private:
    struct State {
        double cost = kInf, turn = 0, tilt = 0;
    };

    [[nodiscard]] bool within(double turn) const {
        return !bounded_ || (turn >= limits_.turn_min - kRouteSlack && turn <= limits_.turn_max + kRouteSlack);
    }

    [[nodiscard]] PoseStates stand_at(std::size_t i, const PoseStates& before) const {
        const auto both = angles(c_, poses_[i]);
        const double level = std::hypot(poses_[i].axis.x, poses_[i].axis.y);
        PoseStates out;
        if (c_.carrier == Carrier::polar)
            out.free = distance(poses_[i].tip.xy(), c_.turn_point.xy()) < kOnAxis;
        else // any heading keeps the lean within its limit
            out.free = level <= kUpright || (bounded_ && poses_[i].axis.z > 0 && level <= std::sin(lean_));
        for (std::size_t k = 0; k < 2; ++k) {
            out.turn[k] = out.free ? before.turn[k] : both[k].turn;
            out.tilt[k] = level <= kUpright ? 0 : both[k].tilt;
            const bool tilts = out.tilt[k] >= limits_.tilt_min - lean_ - kRouteSlack &&
                               out.tilt[k] <= limits_.tilt_max + lean_ + kRouteSlack;
            out.able[k] =
                tilts && (c_.carrier != Carrier::polar ||
                          place(c_, poses_[i].tip, both[k].tilt, both[k].turn).xyz.x >= limits_.radius_min - 1e-6);
        }
        return out;
    }

    // The turn of a state, with bounds.
    [[nodiscard]] double turn_of(const PoseStates& stand, std::size_t s) const {
        return stand.turn[s % 2] + kTurn * (static_cast<int>(s / 2) + lowest_);
    }

    [[nodiscard]] std::size_t index(std::size_t k, double turn, const PoseStates& stand) const {
        if (!bounded_) return k;
        return k + 2 * static_cast<std::size_t>(std::lround((turn - stand.turn[k]) / kTurn) - lowest_);
    }

    // Whether the tool axis stays near the intended ones on the way to pose i.
    [[nodiscard]] bool passes(std::size_t i, const State& from, double turn, double tilt) const {
        if (std::abs(turn - from.turn) < kTurn / 8 || (i == 0 && lifting_.empty())) return true;
        if (!lifting_.empty() && lifting_[i] == Lifting::air && (i == 0 || lifting_[i - 1] == Lifting::air))
            return true;
        const Vec3 a = i > 0 ? poses_[i - 1].axis : tool_axis(c_, before_.tilt, before_.turn), b = poses_[i].axis;
        const Vec3 half = a + b;
        if (norm(half) == 0) return false;
        const Vec3 axis = tool_axis(c_, (from.tilt + tilt) / 2, (from.turn + turn) / 2);
        return angle(axis, half) <= lean_ + angle(a, b) + kUpright;
    }

    // Whether the radius of a polar machine can change its sign on the way to pose i: only on the turn axis, or in the
    // air. Elsewhere the tip would leave its line, because the turn axis turns by half a turn.
    [[nodiscard]] bool changes_radius(std::size_t i, const PoseStates& stand) const {
        if (c_.carrier != Carrier::polar || i == 0 || stand.free || stands_.back().free) return true;
        return !lifting_.empty() && lifting_[i] == Lifting::air && lifting_[i - 1] == Lifting::air;
    }

    void reach(std::size_t i, const PoseStates& stand, std::size_t s, const State& from, std::vector<State>& now) {
        for (std::size_t k = 0; k < 2; ++k) {
            if (!stand.able[k] || (stand.free && i > 0 && k != s % 2)) continue;
            if (k != s % 2 && !changes_radius(i, stand)) continue;
            const double turn = stand.free ? from.turn : geom::unwrapped(stand.turn[k], from.turn);
            if (!within(turn) || !passes(i, from, turn, stand.tilt[k])) continue;
            relax(i, index(k, turn, stand),
                  {from.cost + std::abs(turn - from.turn) + std::abs(stand.tilt[k] - from.tilt), turn, stand.tilt[k]},
                  static_cast<std::uint16_t>(s), now);
        }
    }

    // The tool comes from the air, so it can start with any whole turn.
    void begin_anywhere(const PoseStates& stand, std::vector<State>& now) {
        for (std::size_t s = 0; s < now.size(); ++s) {
            const double turn = turn_of(stand, s), tilt = stand.tilt[s % 2];
            if (stand.able[s % 2] && within(turn))
                relax(0, s, {std::abs(turn - before_.turn) + std::abs(tilt - before_.tilt), turn, tilt}, 0, now);
        }
    }

    void relax(std::size_t i, std::size_t s, const State& state, std::uint16_t from, std::vector<State>& now) {
        if (!(state.cost < now[s].cost)) return;
        now[s] = state;
        from_[i * now.size() + s] = from;
    }

    // Extends the cheapest state at pose i to all other states there by lifting.
    void lift(std::size_t i, const PoseStates& stand, std::vector<State>& now) {
        if (lifting_.empty()) return;
        const auto best = static_cast<std::size_t>(
            std::min_element(now.begin(), now.end(), [](auto& a, auto& b) { return a.cost < b.cost; }) - now.begin());
        const State from = now[best];
        if (!(from.cost < kInf)) return;
        for (std::size_t s = 0; s < now.size(); ++s) {
            const std::size_t k = s % 2;
            const double turn = bounded_ ? turn_of(stand, s) : geom::unwrapped(stand.turn[k], from.turn);
            if (s == best || !stand.able[k] || !within(turn)) continue;
            const double travel = std::abs(turn - from.turn) + std::abs(from.tilt) + std::abs(stand.tilt[k]);
            relax(i, s, {from.cost + kBreak[static_cast<std::size_t>(lifting_[i])] + travel, turn, stand.tilt[k]},
                  static_cast<std::uint16_t>(best | kLifted), now);
        }
    }

    void trace(const std::vector<State>& last, Configurations& out) const {
        auto s = static_cast<std::size_t>(
            std::min_element(last.begin(), last.end(), [](auto& a, auto& b) { return a.cost < b.cost; }) -
            last.begin());
        const std::size_t states = 2 * static_cast<std::size_t>(turns_);
        for (std::size_t i = stands_.size(); i-- > 0;) {
            for (std::uint16_t from = kLifted; (from & kLifted) != 0;) {
                from = from_[i * states + s];
                const double turn = bounded_ ? turn_of(stands_[i], s) : 0;
                out.stops.push_back({i, static_cast<int>(s % 2), turn, (from & kLifted) != 0});
                s = from & ~kLifted;
            }
        }
        std::reverse(out.stops.begin(), out.stops.end());
        if (bounded_) return;
        double turn = before_.turn;
        for (Stop& stop : out.stops) {
            const PoseStates& at = stands_[stop.pose];
            if (!at.free || stop.lifted)
                turn = geom::unwrapped(at.turn[static_cast<std::size_t>(stop.configuration)], turn);
            stop.turn = turn;
        }
    }

    const Chain& c_;
    std::span<const Pose> poses_;
    Joints before_;
    double lean_;
    Limits limits_;
    std::span<const Lifting> lifting_;
    bool bounded_;
    int lowest_ = 0, turns_ = 1; // whole turns that are counted
    std::vector<PoseStates> stands_;
    std::vector<std::uint16_t> from_; // per pose and state: the state before; kLifted: at the same pose
};

// Adds whole turns that bring the stops into the limits; returns whether that succeeds and the tool `may` turn.
bool shift(std::vector<Stop>& stops, const Limits& limits, bool may) {
    const auto [lo, hi] =
        std::minmax_element(stops.begin(), stops.end(), [](auto& a, auto& b) { return a.turn < b.turn; });
    double by = 0;
    if (lo->turn < limits.turn_min) by = kTurn * std::ceil((limits.turn_min - lo->turn) / kTurn);
    if (hi->turn > limits.turn_max) by = -kTurn * std::ceil((hi->turn - limits.turn_max) / kTurn);
    if ((by != 0 && !may) || lo->turn + by < limits.turn_min || hi->turn + by > limits.turn_max) return false;
    for (Stop& s : stops) s.turn += by;
    return true;
}

} // namespace

Configurations configurations(const Chain& chain, std::span<const Pose> poses, const Joints& before, double lean,
                              const Limits& limits, std::span<const Lifting> lifting) {
    Configurations out = ConfigurationSearch(chain, poses, before, lean, limits, lifting, false).run();
    const bool may = lifting.empty() || lifting[0] == Lifting::air;
    if (out.stops.empty() || (out.stuck == poses.size() && shift(out.stops, limits, may))) return out;
    if (!(limits.turn_max - limits.turn_min < kMostTurns * kTurn)) return out;
    return ConfigurationSearch(chain, poses, before, lean, limits, lifting, true).run();
}

} // namespace filum::kinematics
