#include "kinematics/arm.hpp"

#include "geom/angle.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::kinematics {

namespace {

using geom::Frame;
using geom::Vec3;

constexpr double kParallelSine = 1e-6, kMeeting = 1e-3; // of axes that count as parallel, rad, or as meeting, mm

bool parallel(const Axis& a, const Axis& b) { return norm(cross(a.direction, b.direction)) < kParallelSine; }

// The point where two lines meet; none if they are parallel or skew.
std::optional<Vec3> meeting(const Axis& a, const Axis& b) {
    const Vec3 n = cross(a.direction, b.direction), d = b.point - a.point;
    const double size = dot(n, n);
    if (size < kParallelSine * kParallelSine || std::abs(dot(d, n)) > kMeeting * std::sqrt(size)) return std::nullopt;
    return a.point + dot(cross(d, b.direction), n) / size * a.direction;
}

void classify(Arm& arm) {
    const auto& x = arm.axes;
    const auto last = meeting(x[4], x[5]);
    if (!last || !parallel(x[1], x[2]) || parallel(x[0], x[1])) return;
    const auto before = meeting(x[3], x[4]);
    if (before && distance(*before, *last) < kMeeting) {
        arm.build = Build::wrist;
    } else if (parallel(x[1], x[3]) && !parallel(x[1], x[4])) {
        arm.build = Build::parallel;
    } else {
        return;
    }
    arm.centre = *last;
}

// The transformation of a row of the table along x and about x.
Frame link(const DhRow& row) { return {geom::about({1, 0, 0}, row.alpha), {row.a, 0, row.d}}; }

Eigen::Matrix<double, 6, 6> jacobian(const Arm& arm, const Posture& q) {
    Eigen::Matrix<double, 6, 6> out;
    const Vec3 tip = forward(arm, q).origin;
    Frame before;
    for (std::size_t k = 0; k < kAxes; ++k) {
        const Axis& a = arm.axes[k];
        const Vec3 w = before.turn * a.direction, v = cross(w, tip - before * a.point);
        const auto c = static_cast<Eigen::Index>(k);
        out.col(c) << w.x, w.y, w.z, v.x / arm.reach, v.y / arm.reach, v.z / arm.reach;
        const geom::Rotation r = geom::about(a.direction, q[k]);
        before = before * Frame{r, a.point - r * a.point};
    }
    return out;
}

// The motion from the arm's actual frame to the wanted one: rotation in rad, translation in units of the reach.
Eigen::Matrix<double, 6, 1> error(const Arm& arm, const Frame& is, const Frame& wanted) {
    const auto turn = geom::rotation_vector(wanted.turn * geom::inverse(is.turn));
    const Vec3 d = 1 / arm.reach * (wanted.origin - is.origin);
    return {turn[0], turn[1], turn[2], d.x, d.y, d.z};
}

// Quantities whose signs distinguish configurations; each is 0 where two of these coincide. Sines, or shares of the
// reach.
struct ConfigurationSigns {
    double shoulder = 0, elbow = 0, wrist = 0;
};

ConfigurationSigns signs(const Arm& arm, const Posture& q) {
    const auto& x = arm.axes;
    const auto turned_by = [&](std::size_t k, const Vec3& v) { return geom::turned(v, x[k].direction, q[k]); };
    const bool meets = arm.build == Build::wrist;
    Vec3 centre = arm.centre; // as seen from axis 1
    for (std::size_t k = meets ? 3 : 4; k-- > 1;) centre = x[k].point + turned_by(k, centre - x[k].point);
    const Vec3 ahead = cross(x[1].direction, x[0].direction);
    ConfigurationSigns out;
    out.shoulder = dot(centre - x[0].point, ahead) / (norm(ahead) * arm.reach);
    const auto level = [&](const Vec3& v) { return v - dot(v, x[1].direction) * x[1].direction; };
    const Vec3 upper = level(x[2].point - x[1].point);
    const Vec3 fore = level(turned_by(2, (meets ? arm.centre : x[3].point) - x[2].point));
    out.elbow = dot(x[1].direction, cross(upper, fore)) / (norm(upper) * norm(fore));
    // Axis 6 as rotated by axis 5, whose angle is positive or negative.
    const Vec3 hand = turned_by(4, x[5].direction), last = meets ? x[3].direction : x[1].direction;
    out.wrist = dot(x[4].direction, cross(last, hand));
    return out;
}

} // namespace

Arm arm(const std::array<Axis, kAxes>& axes, const Frame& flange) {
    Arm out;
    out.axes = axes;
    out.flange = flange;
    for (Axis& a : out.axes) a.direction = 1 / norm(a.direction) * a.direction;
    classify(out);
    const Vec3 middle = out.build == Build::general ? out.axes[3].point : out.centre;
    out.reach =
        distance(axes[1].point, axes[2].point) + distance(axes[2].point, middle) + distance(middle, flange.origin);
    if (out.build != Build::general) out.ahead = signs(out, {}).shoulder < 0 ? -1 : 1;
    return out;
}

// The frame of row k is behind axis k, which is its z axis; so the transformation before it gives the axis.
Arm arm(const std::array<DhRow, kAxes>& rows, const std::array<Axis, kAxes>& limits, const Frame& flange) {
    std::array<Axis, kAxes> axes = limits;
    Frame at;
    for (std::size_t k = 0; k < kAxes; ++k) {
        axes[k].direction = rows[k].sign * at.turn.z;
        axes[k].point = at.origin;
        at = at * Frame{geom::about({0, 0, 1}, rows[k].theta), {}} * link(rows[k]);
    }
    return arm(axes, at * flange);
}

Frame forward(const Arm& arm, const Posture& q) {
    Frame out = arm.flange;
    for (std::size_t k = kAxes; k-- > 0;) {
        const Axis& a = arm.axes[k];
        const geom::Rotation r = geom::about(a.direction, q[k]);
        out = {r * out.turn, a.point + r * (out.origin - a.point)};
    }
    return out;
}

Nearness nearness(const Arm& arm, const Posture& q) {
    if (arm.build == Build::general) {
        const Eigen::JacobiSVD<Eigen::Matrix<double, 6, 6>> svd(jacobian(arm, q));
        return {Singular::wrist, std::asin(std::min(1.0, svd.singularValues()(5)))};
    }
    const ConfigurationSigns s = signs(arm, q);
    const auto angle = [](double sine) { return std::asin(std::min(1.0, std::abs(sine))); };
    Nearness out{Singular::shoulder, angle(s.shoulder)};
    if (angle(s.elbow) < out.angle) out = {Singular::elbow, angle(s.elbow)};
    if (angle(s.wrist) < out.angle) out = {Singular::wrist, angle(s.wrist)};
    return out;
}

Configuration configuration(const Arm& arm, const Posture& q) {
    if (arm.build == Build::general) return {};
    const ConfigurationSigns s = signs(arm, q);
    return {s.shoulder * arm.ahead < 0, s.elbow < 0, s.wrist < 0};
}

std::optional<Posture> refined(const Arm& arm, const Frame& flange, const Posture& from, int steps) {
    constexpr double place = 1e-7, turn = 1e-9, damp = 1e-8; // mm, rad, of squares
    Posture q = from;
    for (int step = 0;; ++step) {
        const auto e = error(arm, forward(arm, q), flange);
        if (e.tail<3>().norm() * arm.reach < place && e.head<3>().norm() < turn) return q;
        if (step == steps) return std::nullopt;
        const auto j = jacobian(arm, q);
        const Eigen::Matrix<double, 6, 6> normal = j * j.transpose() + damp * Eigen::Matrix<double, 6, 6>::Identity();
        Eigen::Matrix<double, 6, 1> by = j.transpose() * normal.ldlt().solve(e);
        constexpr double most = 0.5; // rad per step
        const double largest = by.cwiseAbs().maxCoeff();
        if (largest > most) by *= most / largest;
        for (std::size_t k = 0; k < kAxes; ++k) q[k] += by(static_cast<Eigen::Index>(k));
    }
}

Posture unwrapped(const Posture& posture, const Posture& near) {
    Posture out;
    for (std::size_t k = 0; k < kAxes; ++k) out[k] = geom::unwrapped(posture[k], near[k]);
    return out;
}

double apart(const Posture& a, const Posture& b) {
    double most = 0;
    for (std::size_t k = 0; k < kAxes; ++k) most = std::max(most, std::abs(a[k] - b[k]));
    return most;
}

} // namespace filum::kinematics
