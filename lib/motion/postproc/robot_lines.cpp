#include "postproc/robot_lines.hpp"

#include "base/error.hpp"
#include "geom/angle.hpp"
#include "postproc/digits.hpp"

#include <cmath>
#include <span>

namespace filum::postproc {

namespace {

using geom::kDegree;
using kinematics::kAxes;
using machine::Dialect;

constexpr double kJointShare = 0.2;      // share of the axes' speed that a joint move uses
constexpr double kLeastChange = 1e-6;    // mm/s, mm: least difference that needs a new line
constexpr double kUrAcceleration = 1;    // rad/s2, of joint moves
constexpr int kVectorDecimals = 7;       // of quaternions and rotation vectors
constexpr double kExtruderOrient = 1000; // degrees/s, of turning external axes: too high to limit a move

class Lines {
  public:
    Lines(std::string& out, const machine::Profile& profile, const char* end) : out_(out), p_(profile), end_(end) {}

    void krl(const RobotLine& l, ModalState& modal) {
        if (!l.joint) {
            says("$VEL.CP=", l.feed, modal.feed, 1000, 6);
            if (l.blend > 0) says("$APO.CDIS=", l.blend, modal.blend, 1, 3);
        }
        const int d = p_.format.xyz_decimals;
        const auto angles = geom::euler_zyx(l.tip.turn);
        const char* names[] = {",A ", ",B ", ",C "};
        out_ += l.joint ? "PTP {X " : "LIN {X ";
        number(l.tip.origin.x, d);
        out_ += ",Y ";
        number(l.tip.origin.y, d);
        out_ += ",Z ";
        number(l.tip.origin.z, d);
        for (std::size_t k = 0; k < 3; ++k) {
            out_ += names[k];
            number(angles[k] / kDegree, p_.axes.angle_decimals);
        }
        if (l.joint && l.posture != nullptr && p_.robot.arm)
            out_ += ",S " + std::to_string(krl_status(*p_.robot.arm, *l.posture)) + ",T " +
                    std::to_string(krl_turn(*l.posture));
        if (l.extruder) {
            out_ += ",E1 ";
            number(*l.extruder, p_.format.e_decimals);
        }
        out_ += l.blend > 0 && !l.joint ? "} C_DIS" : "}";
        out_ += end_;
    }

    void rapid(const RobotLine& l) {
        const double xyz[] = {l.tip.origin.x, l.tip.origin.y, l.tip.origin.z};
        if (l.joint && l.posture != nullptr) {
            out_ += "MoveAbsJ [[";
            degrees(*l.posture);
            out_ += "],[";
        } else {
            out_ += l.joint ? "MoveJ [[" : l.trigger.empty() ? "MoveL [[" : "TriggL [[";
            list(xyz, p_.format.xyz_decimals);
            out_ += "],[";
            list(geom::quaternion(l.tip.turn), kVectorDecimals);
            out_ += "],[0,0,0,0],[";
        }
        if (l.extruder)
            number(*l.extruder, p_.format.e_decimals);
        else
            out_ += "9E9";
        out_ += ",9E9,9E9,9E9,9E9,9E9]],[";
        number(l.feed, 3);
        out_ += ',';
        number(p_.axes.tilt_speed / kDegree, 3);
        out_ += ',';
        number(l.extruder_speed, 3);
        out_ += ',';
        number(kExtruderOrient, 0);
        out_ += "],";
        if (!l.trigger.empty() && !l.joint) out_ += l.trigger + ',';
        zone(l);
        out_ += ",tFilum\\WObj:=wFilum;";
        out_ += end_;
    }

    void urscript(const RobotLine& l) {
        if (l.joint && l.posture != nullptr) {
            double slowest = p_.robot.arm->axes[0].speed;
            for (const auto& axis : p_.robot.arm->axes) slowest = std::min(slowest, axis.speed);
            out_ += "movej([";
            list(*l.posture, kVectorDecimals);
            out_ += "],a=";
            number(kUrAcceleration, 4);
            out_ += ",v=";
            number(kJointShare * slowest, 4);
            out_ += ')';
            out_ += end_;
            return;
        }
        const double xyz[] = {l.tip.origin.x / 1000, l.tip.origin.y / 1000, l.tip.origin.z / 1000};
        out_ += l.joint ? "movej(" : "movel(";
        out_ += "pose_trans(filum_part,p[";
        list(xyz, p_.format.xyz_decimals + 3);
        out_ += ',';
        list(geom::rotation_vector(l.tip.turn), kVectorDecimals);
        out_ += "])";
        if (l.joint) {
            out_ += ",a=";
            number(kUrAcceleration, 4);
            out_ += ",v=";
            number(kJointShare, 4);
        } else if (l.seconds > 0) {
            out_ += ",t=";
            number(l.seconds, 4);
        } else {
            out_ += ",a=";
            number(p_.motion.acceleration / 1000, 4);
            out_ += ",v=";
            number(l.feed / 1000, 6);
            out_ += ",r=";
            number(l.blend / 1000, 6);
        }
        out_ += ')';
        out_ += end_;
    }

  private:
    void number(double value, int decimals) {
        append_units(out_, std::llround(value * std::pow(10.0, decimals)), decimals);
    }

    void list(std::span<const double> values, int decimals) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (i > 0) out_ += ',';
            number(values[i], decimals);
        }
    }

    void degrees(const kinematics::Posture& q) {
        std::array<double, kAxes> v{};
        for (std::size_t k = 0; k < kAxes; ++k) v[k] = q[k] / kDegree;
        list(v, p_.axes.angle_decimals);
    }

    void says(const char* what, double value, double& modal, double per, int decimals) {
        if (std::abs(value - modal) <= kLeastChange) return;
        out_ += what;
        number(value / per, decimals);
        out_ += end_;
        modal = value;
    }

    void zone(const RobotLine& l) {
        const double b = l.blend;
        if (!(b > 0) || l.joint) {
            out_ += "fine";
            return;
        }
        // pzone_tcp, pzone_ori, pzone_eax, mm; zone_ori, degrees; zone_leax, mm; zone_reax, degrees
        const double zone[] = {b, 1.5 * b, 1.5 * b, 0.15 * b, 1.5 * b, 0.15 * b};
        out_ += "[FALSE,";
        list(zone, 3);
        out_ += ']';
    }

    std::string& out_;
    const machine::Profile& p_;
    const char* end_;
};

} // namespace

int krl_status(const kinematics::Arm& arm, const kinematics::Posture& q) {
    const auto c = kinematics::configuration(arm, q);
    return (c.behind ? 1 : 0) + (c.bent_down ? 0 : 2) + (c.flipped ? 4 : 0);
}

int krl_turn(const kinematics::Posture& q) {
    int out = 0;
    for (std::size_t k = 0; k < kAxes; ++k) out |= q[k] < 0 ? 1 << k : 0;
    return out;
}

void append_robot_line(std::string& out, const RobotLine& line, const machine::Profile& profile, const char* end,
                       ModalState& modal) {
    Lines lines(out, profile, end);
    switch (profile.format.dialect) {
    case Dialect::krl:
        return lines.krl(line, modal);
    case Dialect::rapid:
        return lines.rapid(line);
    case Dialect::urscript:
        return lines.urscript(line);
    case Dialect::gcode:
        break;
    }
    throw Error(Exit::failure, "internal error: G-code is no robot's language");
}

} // namespace filum::postproc
