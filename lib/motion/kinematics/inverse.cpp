// Solves an arm's inverse kinematics from its geometry: each angle is one at which a rotated vector has a given
// component along another one (the subproblems of Paden 1986, unified).
#include "kinematics/arm.hpp"

#include "geom/angle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::kinematics {

namespace {

using geom::Frame;
using geom::Rotation;
using geom::Vec3;

constexpr double kFree = 1e-9; // components of unit vectors: below this an angle is free
constexpr double kEdge = 1e-9; // share by which rounding may put a frame out of reach
constexpr double kSame = 1e-6; // rad: solutions nearer than this are the same
constexpr int kPolish = 8;     // steps that refine closed forms, for axes that are slightly inexact
constexpr int kSeek = 60;      // steps of iteration from a start
constexpr std::uint32_t kSeeds = 64;

struct AnglePair {
    std::array<double, 2> value{};
    std::size_t count = 0;
    double beyond = 0; // what is missing, in units of a * b
};

// The angles t at which a . R(w, t) b = v; both are equal at the limit. `idle` if t does not matter.
AnglePair parts(const Vec3& a, const Vec3& w, const Vec3& b, double v, double idle) {
    const double steady = dot(a, w) * dot(w, b), c = dot(a, b) - steady, s = dot(a, cross(w, b));
    const double size = std::hypot(c, s), rest = v - steady;
    AnglePair out;
    if (size <= kFree * norm(a) * norm(b)) {
        if (std::abs(rest) > kFree * norm(a) * norm(b)) return {{}, 0, std::abs(rest)};
        return {{idle, idle}, 1, 0};
    }
    if (std::abs(rest) > size * (1 + kEdge)) return {{}, 0, std::abs(rest) - size};
    const double middle = std::atan2(s, c), half = std::acos(std::clamp(rest / size, -1.0, 1.0));
    return {{middle + half, middle - half}, half > 0 && half < std::numbers::pi ? 2U : 1U, 0};
}

// The angle that rotates `from` about `w` to the direction of `to`; `idle` if `from` is along w.
double to_angle(const Vec3& w, const Vec3& from, const Vec3& to, double idle) {
    const Vec3 a = from - dot(from, w) * w, b = to - dot(to, w) * w;
    if (norm(a) <= kFree * norm(from) || norm(b) <= kFree * norm(to)) return idle;
    return std::atan2(dot(w, cross(a, b)), dot(a, b));
}

class InverseSolver {
  public:
    InverseSolver(const Arm& arm, const Frame& flange, const Posture& near, Shortfall* lack)
        : arm_(arm), x_(arm.axes), to_(flange * geom::inverse(arm.flange)), flange_(flange), near_(near), lack_(lack) {}

    std::vector<Posture> find() {
        if (arm_.build == Build::general)
            seek();
        else
            shoulder();
        return std::move(out_);
    }

  private:
    [[nodiscard]] Rotation turn(std::size_t k, double t) const { return geom::about(x_[k].direction, t); }
    [[nodiscard]] Vec3 moved(std::size_t k, double t, const Vec3& p) const {
        return x_[k].point + geom::turned(p - x_[k].point, x_[k].direction, t);
    }

    // Records the deficit that is nearest to being reachable.
    void lacks(std::size_t axis, double length) {
        if (lack_ != nullptr && (!told_ || axis > lack_->axis || (axis == lack_->axis && length < lack_->length)))
            *lack_ = {axis, length};
        told_ = true;
    }

    // Axis 1: the centre keeps its component along axis 2.
    void shoulder() {
        const Vec3 w2 = x_[1].direction, centre = to_ * arm_.centre;
        const auto ways =
            parts(w2, -1.0 * x_[0].direction, centre - x_[0].point, dot(w2, arm_.centre - x_[0].point), -near_[0]);
        if (ways.count == 0) lacks(0, ways.beyond);
        for (std::size_t k = 0; k < ways.count; ++k) {
            q_[0] = ways.value[k];
            const Rotation back = turn(0, -q_[0]);
            rest_ = {back * to_.turn, x_[0].point + back * (to_.origin - x_[0].point)};
            if (arm_.build == Build::wrist) {
                elbow(rest_ * arm_.centre, arm_.centre);
            } else {
                swivel();
            }
        }
    }

    // Axes 2 and 3 move `from`, its position at rest, to `to`.
    void elbow(const Vec3& to, const Vec3& from) {
        const Vec3 upper = x_[2].point - x_[1].point, fore = from - x_[2].point, way = to - x_[1].point;
        const auto ways =
            parts(upper, x_[2].direction, fore, (dot(way, way) - dot(upper, upper) - dot(fore, fore)) / 2, near_[2]);
        if (ways.count == 0) {
            const auto level = [&](const Vec3& v) { return norm(cross(v, x_[1].direction)); };
            const double a = level(upper), b = level(fore), wanted = level(way);
            lacks(2, std::max(wanted - (a + b), std::abs(a - b) - wanted));
        }
        for (std::size_t k = 0; k < ways.count; ++k) {
            q_[2] = ways.value[k];
            q_[1] = to_angle(x_[1].direction, moved(2, q_[2], from) - x_[1].point, way, near_[1]);
            if (arm_.build == Build::wrist) {
                hand();
            } else {
                q_[3] = to_angle_of_four();
                add();
            }
        }
    }

    // Solves a wrist whose axes meet.
    void hand() {
        const Rotation turned = geom::inverse(turn(1, q_[1]) * turn(2, q_[2])) * rest_.turn;
        const Vec3 w4 = x_[3].direction, w5 = x_[4].direction, w6 = x_[5].direction;
        const auto ways = parts(w4, w5, w6, dot(w4, turned * w6), near_[4]);
        if (ways.count == 0) lacks(4, 0);
        for (std::size_t k = 0; k < ways.count; ++k) {
            q_[4] = ways.value[k];
            q_[3] = to_angle(w4, geom::turned(w6, w5, q_[4]), turned * w6, near_[3]);
            const Rotation left = geom::inverse(turn(3, q_[3]) * turn(4, q_[4])) * turned;
            const Vec3 across = norm(cross(w5, w6)) > kFree ? w5 : x_[3].direction;
            q_[5] = to_angle(w6, across, left * across, near_[5]);
            add();
        }
    }

    // Solves axes 5 and 6 behind three parallel axes, which keep a vector's component along themselves.
    void swivel() {
        const Vec3 w2 = x_[1].direction, w5 = x_[4].direction, w6 = x_[5].direction;
        const auto ways = parts(w2, w5, w6, dot(w2, rest_.turn * w6), near_[4]);
        if (ways.count == 0) lacks(4, 0);
        for (std::size_t k = 0; k < ways.count; ++k) {
            q_[4] = ways.value[k];
            q_[5] = to_angle(w6, geom::inverse(rest_.turn) * w2, geom::turned(w2, w5, -q_[4]), near_[5]);
            const Rotation hand = turn(4, q_[4]) * turn(5, q_[5]);
            three_ = rest_.turn * geom::inverse(hand);
            // Undoes the effect of axes 5 and 6 on the point of axis 4.
            const Vec3 p = x_[3].point, back = moved(5, -q_[5], moved(4, -q_[4], p));
            elbow(rest_ * back, p);
        }
    }

    // The part of the rotation of three parallel axes that remains for the last of them.
    [[nodiscard]] double to_angle_of_four() const {
        const Vec3 u = cross(x_[1].direction, x_[4].direction);
        const Rotation left = geom::inverse(turn(1, q_[1]) * turn(2, q_[2])) * three_;
        return to_angle(x_[3].direction, u, left * u, near_[3]);
    }

    void add() {
        const auto exact = refined(arm_, flange_, q_, kPolish);
        if (exact) take(*exact);
    }

    void take(Posture q) {
        for (double& t : q) t = geom::wrapped(t);
        for (const Posture& other : out_)
            if (apart(unwrapped(q, other), other) < kSame) return;
        out_.push_back(q);
    }

    // Iterates from `near`, and from starts spread over the limits (Halton 1960).
    void seek() {
        if (const auto q = refined(arm_, flange_, near_, kSeek)) take(*q);
        for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
            Posture from{};
            for (std::size_t k = 0; k < kAxes; ++k) {
                constexpr std::array<std::uint32_t, kAxes> bases{2, 3, 5, 7, 11, 13};
                double share = 0, digit = 1;
                for (std::uint32_t n = seed; n > 0; n /= bases[k]) {
                    digit /= bases[k];
                    share += digit * (n % bases[k]);
                }
                const double low = std::max(x_[k].min, -std::numbers::pi), high = std::min(x_[k].max, std::numbers::pi);
                from[k] = low + share * (high - low);
            }
            if (const auto q = refined(arm_, flange_, from, kSeek)) take(*q);
        }
        if (out_.empty()) lacks(0, 0);
    }

    const Arm& arm_;
    const std::array<Axis, kAxes>& x_;
    const Frame to_, flange_; // motion of everything that is at rest; the intended frame of the flange
    const Posture& near_;
    Shortfall* lack_;
    bool told_ = false;
    Posture q_{};
    Frame rest_;     // of to_, behind axis 1
    Rotation three_; // of axes 2 to 4
    std::vector<Posture> out_;
};

} // namespace

std::vector<Posture> inverse(const Arm& arm, const Frame& flange, const Posture& near, Shortfall* lack) {
    return InverseSolver(arm, flange, near, lack).find();
}

} // namespace filum::kinematics
