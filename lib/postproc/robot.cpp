#include "postproc/robot.hpp"

#include "geom/angle.hpp"
#include "postproc/digits.hpp"

#include <algorithm>
#include <cmath>

namespace filum::postproc {

namespace {

using machine::Dialect;

using geom::kDegree;
constexpr double kAxisSpeed = 5000; // mm/s: the extruder keeps up with the path

} // namespace

Orientation orientation(const Vec3& axis, const Vec3& heading) {
    const Vec3 z = -1.0 * axis;
    Vec3 x = heading - dot(heading, z) * z;
    x = 1 / norm(x) * x;
    return {x, cross(z, x), z};
}

std::array<double, 3> euler_zyx(const Orientation& o) {
    const double level = std::hypot(o.x.x, o.x.y);
    const double b = std::atan2(-o.x.z, level);
    if (level < 1e-9) return {std::atan2(-o.y.x, o.y.y), b, 0}; // only the sum of A and C counts
    return {std::atan2(o.x.y, o.x.x), b, std::atan2(o.y.z, o.z.z)};
}

// By the largest of the four parts, so that no difference cancels (Shepperd 1978).
std::array<double, 4> quaternion(const Orientation& o) {
    const double t = o.x.x + o.y.y + o.z.z;
    const std::array<double, 4> squares{1 + t, 1 + 2 * o.x.x - t, 1 + 2 * o.y.y - t, 1 + 2 * o.z.z - t};
    const auto k = std::max_element(squares.begin(), squares.end()) - squares.begin();
    const double yz = o.y.z - o.z.y, zx = o.z.x - o.x.z, xy = o.x.y - o.y.x;
    const double a = o.x.y + o.y.x, b = o.z.x + o.x.z, c = o.y.z + o.z.y;
    const std::array<std::array<double, 4>, 4> rows{
        {{squares[0], yz, zx, xy}, {yz, squares[1], a, b}, {zx, a, squares[2], c}, {xy, b, c, squares[3]}}};
    auto q = rows[static_cast<std::size_t>(k)];
    const double size = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3])) * (q[0] < 0 ? -1 : 1);
    for (double& v : q) v /= size;
    return q;
}

std::array<double, 3> rotation_vector(const Orientation& o) {
    const auto q = quaternion(o);
    const double s = std::sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    const double f = s > 1e-12 ? 2 * std::atan2(s, q[0]) / s : 2;
    return {f * q[1], f * q[2], f * q[3]};
}

RobotProgram::RobotProgram(const machine::Profile& profile, const Survey& survey, Text out)
    : Writer(profile, placeholders(survey, profile, {}), std::move(out)), axis_speed_(kAxisSpeed) {}

void RobotProgram::number(double value, int decimals) {
    append_units(text_, std::llround(value * std::pow(10.0, decimals)), decimals);
}

void RobotProgram::list(std::span<const double> values, int decimals) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) text_ += ',';
        number(values[i], decimals);
    }
}

void RobotProgram::begin(const std::vector<std::string>& about) {
    // A module's first line must be its own in some languages: what it is stands behind.
    code(profile_->templates.start);
    for (const auto& line : about) comment(line);
}

void RobotProgram::end() {
    comment("end of program, " + std::to_string(lines_) + " moves");
    code(profile_->templates.end);
    flush();
}

void RobotProgram::krl(const Step& step, const Orientation& o) {
    if (std::abs(step.feed - speed_) > 1e-6) {
        text_ += "$VEL.CP=";
        number(step.feed / 1000, 6);
        end_line();
    }
    const int d = profile_->format.xyz_decimals;
    const auto angles = euler_zyx(o);
    const char* names[] = {"A ", ",B ", ",C "};
    text_ += "LIN {X ", number(step.to.x, d);
    text_ += ",Y ", number(step.to.y, d);
    text_ += ",Z ", number(step.to.z, d);
    text_ += ',';
    for (std::size_t k = 0; k < 3; ++k) text_ += names[k], number(angles[k] / kDegree, profile_->axes.angle_decimals);
    if (counts()) text_ += ",E1 ", number(laid_, profile_->format.e_decimals);
    text_ += step.halt ? "}" : "} C_DIS";
}

void RobotProgram::rapid(const Step& step, const Orientation& o) {
    const double xyz[] = {step.to.x, step.to.y, step.to.z};
    const double b = profile_->axes.blend;
    text_ += "MoveL [[", list(xyz, profile_->format.xyz_decimals);
    text_ += "],[", list(quaternion(o), 7);
    text_ += "],[0,0,0,0],[";
    if (counts())
        number(laid_, profile_->format.e_decimals);
    else
        text_ += "9E9";
    text_ += ",9E9,9E9,9E9,9E9,9E9]],[", number(step.feed, 3);
    text_ += ",500,", number(axis_speed_, 3);
    text_ += ",1000],";
    if (step.halt) {
        text_ += "fine";
    } else {
        const double zone[] = {b, 1.5 * b, 1.5 * b, 0.15 * b, 1.5 * b, 0.15 * b};
        text_ += "[FALSE,", list(zone, 3);
        text_ += ']';
    }
    text_ += ",tFilum\\WObj:=wFilum;";
}

void RobotProgram::urscript(const Step& step, const Orientation& o) {
    const double xyz[] = {step.to.x / 1000, step.to.y / 1000, step.to.z / 1000};
    text_ += "movel(p[", list(xyz, profile_->format.xyz_decimals + 3);
    text_ += ',', list(rotation_vector(o), 7);
    text_ += "],a=", number(profile_->motion.acceleration / 1000, 4);
    text_ += ",v=", number(step.feed / 1000, 6);
    text_ += ",r=", number(step.halt ? 0 : profile_->axes.blend / 1000, 6);
    text_ += ')';
}

void RobotProgram::move(const Step& step) {
    laid_ += feeds(step);
    if (step.length == 0 && step.seconds == 0 && lines_ > 0) return;
    // Where the tool turns more than it goes, it goes slower than its feed.
    Step slow = step;
    if (step.seconds > 0) slow.feed = std::max(step.length / step.seconds, 0.01);
    write(slow);
}

void RobotProgram::write(const Step& step) {
    const Orientation o = orientation(step.axis, step.heading);
    switch (profile_->format.dialect) {
    case Dialect::krl:
        krl(step, o);
        break;
    case Dialect::rapid:
        rapid(step, o);
        break;
    default:
        urscript(step, o);
    }
    end_line();
    speed_ = step.feed;
    last_ = step;
    ++lines_;
}

// Pushes fibre where the tool is: the extruder moves alone.
void RobotProgram::push() {
    if (!counts() || profile_->fibre.prime == 0) return;
    laid_ += profile_->fibre.prime;
    axis_speed_ = profile_->fibre.prime_speed;
    Step still = last_;
    still.feed = profile_->fibre.prime_speed;
    still.halt = true;
    write(still);
    axis_speed_ = kAxisSpeed;
}

void RobotProgram::layer(const Step& step) {
    values_["layer"] = step.layer, values_["z"] = step.to.z, values_["height"] = step.height;
    code(profile_->templates.layer);
}

void RobotProgram::close(const Step& step) { code(off(step)); }

// Taken back and given again on the way: with the next move.
void RobotProgram::retract() { laid_ -= profile_->travel.retract; }
void RobotProgram::prime() { laid_ += profile_->travel.retract + profile_->travel.extra; }

void RobotProgram::change_tool(const Step& step) {
    tool(step);
    speed_ = -1;
}

void RobotProgram::cut() { code(profile_->fibre.cut); }

} // namespace filum::postproc
