#include "kinematics/follow.hpp"

#include "geom/angle.hpp"
#include "kinematics/passing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace filum::kinematics {

namespace {

using geom::Frame;
using geom::kDegree;

constexpr double kSpinStep = 15 * kDegree;
constexpr int kSpins = 24;
constexpr double kKnot = 20;        // mm between knots, at which the rate of the spin may change
constexpr double kSwing = 100;      // mm: a rotation counts as the way of a point this far from the axis
constexpr double kMostKnots = 1000; // most knots of a stroke
constexpr std::size_t kLooks = 4;   // sample stands between two knots during the search
constexpr double kNearLimit = 5 * kDegree;
constexpr double kSlow = 10;      // weight of a second beyond the given time
constexpr double kUneasy = 1;     // s: cost of a sample near a limit or a singularity
constexpr double kSpinCost = 0.5; // s per rad of change
constexpr double kSameWay = 1e-3; // rad
constexpr int kWindings = 2;      // whole turns of the last axis, either way, at the start of a stroke

// Follows the whole stroke with a given spin per stand, from a posture at the first one.
FollowResult followed(const ArmSetup& c, std::span<const TimedFrame> stands, const Posture& first,
                      std::vector<double> spin) {
    const Follower follower(c);
    FollowResult out;
    const auto take = [&](const JointMove& p, std::size_t i) {
        if (p.nearest.angle < out.nearest.angle) {
            out.nearest = p.nearest;
            out.nearest_at = i;
        }
        if (p.room < out.room) {
            out.room = p.room;
            out.room_axis = p.room_axis;
            out.room_at = i;
        }
        out.hindrance = p.hindrance;
        out.hindrance.stand = i;
    };
    JointMove start;
    follower.look(first, start);
    take(start, 0);
    if (start.room < 0) {
        out.hindrance = {FollowFailure::limit, 0, start.room_axis, -start.room};
        return out;
    }
    out.postures.push_back(first);
    out.needed.push_back(0);
    out.axis.push_back(0);
    Frame at = spun(stands[0].tip, spin[0]);
    for (std::size_t i = 1; i < stands.size(); ++i) {
        const Frame to = spun(stands[i].tip, spin[i]);
        const JointMove p = follower.pass(at, out.postures.back(), to);
        take(p, i);
        if (p.hindrance.trouble != FollowFailure::none) return out;
        out.postures.push_back(p.to);
        out.needed.push_back(p.needed);
        out.axis.push_back(static_cast<std::uint8_t>(p.axis));
        at = to;
    }
    out.spin = std::move(spin);
    return out;
}

bool easy(const ArmSetup& c, std::span<const TimedFrame> stands, const FollowResult& f) {
    if (f.hindrance.trouble != FollowFailure::none || f.nearest.angle < c.singular) return false;
    for (std::size_t i = 1; i < stands.size(); ++i)
        if (f.needed[i] > stands[i].seconds) return false;
    return true;
}

// Postures at the first stand if it may be reached in any way: the last axis, which winds with the spin, at each whole
// turn nearby that it allows, the others at the turn nearest to their present angle.
std::vector<Posture> begins(const ArmSetup& c, const Follower& follower, const Frame& tip, const Posture& before,
                            Shortfall* lack) {
    constexpr double whole = 2 * std::numbers::pi;
    std::vector<Posture> out;
    for (const Posture& way : follower.ways(tip, before, lack)) {
        Posture q = unwrapped(way, before);
        bool can = true;
        for (std::size_t k = 0; k < kAxes; ++k) {
            const Axis& a = c.arm.axes[k];
            if (q[k] > a.max) q[k] -= whole * std::ceil((q[k] - a.max) / whole);
            if (q[k] < a.min) q[k] += whole * std::ceil((a.min - q[k]) / whole);
            can = can && q[k] <= a.max;
        }
        if (!can) continue;
        const Axis& last = c.arm.axes.back();
        const double stands = q.back();
        for (int turns = -kWindings; turns <= kWindings; ++turns) {
            q.back() = stands + turns * whole;
            if (q.back() >= last.min && q.back() <= last.max) out.push_back(q);
        }
    }
    return out;
}

bool same_arm(const Arm& arm, const Posture& a, const Posture& b) {
    const Configuration x = configuration(arm, a), y = configuration(arm, b);
    return x.behind == y.behind && x.bent_down == y.bent_down;
}

double turning_time(const Arm& arm, const Posture& a, const Posture& b) {
    double most = 0;
    for (std::size_t k = 0; k < kAxes; ++k) most = std::max(most, std::abs(a[k] - b[k]) / arm.axes[k].speed);
    return most;
}

double angle_between(const Frame& a, const Frame& b) {
    const auto v = geom::rotation_vector(b.turn * geom::inverse(a.turn));
    return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

// Searches spins and configurations over the knots of a stroke.
class SpinSearch {
  public:
    // `keeps`: shoulder and elbow keep their configuration.
    SpinSearch(const ArmSetup& c, std::span<const TimedFrame> stands, const StartPosture& before, bool keeps)
        : c_(c), stands_(stands), before_(before), keeps_(keeps), follower_(c) {
        set_knots();
    }

    // The last stand that any candidate reached, if all are hindered; only sampled stands are known.
    [[nodiscard]] std::size_t reached() const { return reached_; }

    // The best result; hindered if there is none.
    FollowResult run() {
        begin();
        for (std::size_t k = 1; k < knots_.size() && !states_.back().empty(); ++k) step(k);
        if (states_.back().empty()) {
            FollowResult out;
            out.hindrance = farthest_;
            return out;
        }
        const auto& last = states_.back();
        const auto best = std::ranges::min_element(last, {}, &State::cost);
        std::vector<const State*> way(knots_.size());
        way.back() = &*best;
        for (std::size_t k = knots_.size() - 1; k > 0; --k) way[k - 1] = &states_[k - 1][way[k]->from];
        std::vector<double> spin(stands_.size(), way[0]->spin);
        for (std::size_t k = 1; k < knots_.size(); ++k)
            for (std::size_t i = knots_[k - 1] + 1; i <= knots_[k]; ++i)
                spin[i] = way[k - 1]->spin + share(k, i) * (way[k]->spin - way[k - 1]->spin);
        return followed(c_, stands_, way[0]->posture, std::move(spin));
    }

  private:
    struct State {
        Posture posture{};
        double spin = 0, cost = 0;
        std::size_t from = 0;
    };

    void set_knots() {
        along_.assign(stands_.size(), 0);
        for (std::size_t i = 1; i < stands_.size(); ++i) {
            const double turned = angle_between(stands_[i - 1].tip, stands_[i].tip);
            along_[i] = along_[i - 1] + distance(stands_[i - 1].tip.origin, stands_[i].tip.origin) + kSwing * turned;
            most_spin_ += turned;
        }
        const double step = std::max(kKnot, along_.back() / kMostKnots);
        knots_ = {0};
        for (std::size_t i = 1; i < stands_.size(); ++i)
            if (i + 1 == stands_.size() || along_[i] - along_[knots_.back()] >= step) knots_.push_back(i);
    }

    // Share of the way from knot k - 1 to knot k at stand i.
    [[nodiscard]] double share(std::size_t k, std::size_t i) const {
        const double from = along_[knots_[k - 1]], way = along_[knots_[k]] - from;
        return way > 0 ? (along_[i] - from) / way : 1;
    }

    void begin() {
        states_.emplace_back();
        if (!before_.joint) {
            states_.back().push_back({before_.posture, before_.spin, 0, 0});
            return;
        }
        const int spins = c_.round ? kSpins : 1;
        for (int s = 0; s < spins; ++s) {
            const double turn = (s % 2 == 0 ? s / 2 : -(s + 1) / 2) * kSpinStep, spin = before_.spin + turn;
            Shortfall lack;
            for (const Posture& q : begins(c_, follower_, spun(stands_[0].tip, spin), before_.posture, &lack)) {
                if (keeps_ && !same_arm(c_.arm, q, before_.posture)) continue;
                JointMove p;
                follower_.look(q, p);
                states_.back().push_back(
                    {q, spin, turning_time(c_.arm, before_.posture, q) + kSpinCost * std::abs(turn) + uneasy(p), 0});
            }
            if (s == 0 && states_.back().empty()) refused(lack);
        }
    }

    // Records why no posture is possible at the first stand.
    void refused(const Shortfall& lack) {
        const auto ways = follower_.ways(spun(stands_[0].tip, before_.spin), before_.posture, nullptr);
        farthest_ = {FollowFailure::reach, 0, lack.axis, lack.length};
        double least = std::numeric_limits<double>::infinity();
        for (const Posture& q : ways) {
            JointMove p;
            follower_.look(q, p);
            if (-p.room < least) {
                least = -p.room;
                farthest_ = {FollowFailure::limit, 0, p.room_axis, -p.room};
            }
        }
    }

    [[nodiscard]] double uneasy(const JointMove& p) const {
        const double limit = std::max(0.0, 1 - p.room / kNearLimit);
        const double singular = c_.singular > 0 ? std::max(0.0, 1 - p.nearest.angle / c_.singular) : 0;
        return kUneasy * (limit + singular);
    }

    void step(std::size_t k) {
        states_.emplace_back();
        const auto& from = states_[k - 1];
        const int aside = c_.round ? 1 : 0;
        for (std::size_t s = 0; s < from.size(); ++s)
            for (int turn = -aside; turn <= aside; ++turn) {
                State to{from[s].posture, from[s].spin + turn * kSpinStep, from[s].cost, s};
                if (std::abs(to.spin - before_.spin) <= most_spin_ && edge(k, from[s], to)) keep(to);
            }
    }

    // Goes from knot k - 1 to k through a few stands; returns false if that is impossible.
    bool edge(std::size_t k, const State& from, State& to) {
        const std::size_t a = knots_[k - 1], b = knots_[k], n = std::min(kLooks, b - a);
        to.cost += kSpinCost * std::abs(to.spin - from.spin);
        Frame at = spun(stands_[a].tip, from.spin);
        std::size_t last = a;
        for (std::size_t look = 1; look <= n; ++look) {
            const std::size_t i = a + (b - a) * look / n;
            const Frame next = spun(stands_[i].tip, from.spin + share(k, i) * (to.spin - from.spin));
            const JointMove p = follower_.pass(at, to.posture, next);
            if (p.hindrance.trouble != FollowFailure::none) {
                if (farthest_.trouble == FollowFailure::none || i > farthest_.stand) {
                    farthest_ = p.hindrance;
                    farthest_.stand = i;
                    reached_ = last;
                }
                return false;
            }
            double given = 0;
            for (std::size_t j = last + 1; j <= i; ++j) given += stands_[j].seconds;
            to.cost += p.needed + kSlow * std::max(0.0, p.needed - given) + uneasy(p);
            to.posture = p.to;
            at = next;
            last = i;
        }
        return true;
    }

    // Adds a state of the last knot; of states with the same configuration the cheaper one stays.
    void keep(const State& s) {
        for (State& other : states_.back())
            if (apart(other.posture, s.posture) < kSameWay) {
                if (s.cost < other.cost) other = s;
                return;
            }
        states_.back().push_back(s);
    }

    const ArmSetup& c_;
    const std::span<const TimedFrame> stands_;
    const StartPosture& before_;
    const bool keeps_;
    const Follower follower_;
    // rad from the initial spin: a turn, and the rotation of the stands themselves
    double most_spin_ = 2 * std::numbers::pi;
    std::vector<double> along_;      // mm, per stand
    std::vector<std::size_t> knots_; // indices of stands
    std::vector<std::vector<State>> states_;
    Hindrance farthest_;
    std::size_t reached_ = 0;
};

} // namespace

void FollowResult::forget(std::size_t n) {
    const auto cut = [n](auto& v) {
        v.erase(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(std::min(n, v.size())));
    };
    cut(postures);
    cut(spin);
    cut(needed);
    cut(axis);
    for (std::size_t* at : {&hindrance.stand, &nearest_at, &room_at}) *at -= std::min(n, *at);
}

FollowResult follow(const ArmSetup& c, std::span<const TimedFrame> stands, const StartPosture& before) {
    if (stands.empty()) return {};
    FollowResult best;
    best.hindrance = {FollowFailure::reach, 0, 0, 0};
    // As it is, without a change of spin.
    std::vector<Posture> firsts{before.posture};
    if (before.joint) {
        firsts = begins(c, Follower(c), spun(stands[0].tip, before.spin), before.posture, nullptr);
        std::erase_if(firsts, [&](const Posture& q) { return !same_arm(c.arm, q, before.posture); });
    }
    if (!firsts.empty()) {
        const auto time = [&](const Posture& q) { return turning_time(c.arm, before.posture, q); };
        const Posture first = *std::ranges::min_element(firsts, {}, time);
        best = followed(c, stands, first, std::vector<double>(stands.size(), before.spin));
        if (easy(c, stands, best) || (!c.round && !before.joint)) return best;
    }
    for (const bool keeps : {true, false}) {
        if (!keeps && (!before.joint || best.hindrance.trouble == FollowFailure::none)) break;
        SpinSearch search(c, stands, before, keeps);
        FollowResult found = search.run();
        const bool farther = best.hindrance.trouble != FollowFailure::none && search.reached() > best.hindrance.stand;
        if (found.hindrance.trouble == FollowFailure::none || farther || (firsts.empty() && best.hindrance.stand == 0))
            best = std::move(found);
    }
    return best;
}

} // namespace filum::kinematics
