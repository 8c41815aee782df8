#include "postproc/robot.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace filum::postproc {

namespace {

using machine::Dialect;

constexpr double kAxisSpeed = 5000;  // mm/s: the extruder keeps up with the path
constexpr double kNeighbour = 3;     // a move flies by by a third of a neighbour at most
constexpr double kLeastBlend = 1e-3; // mm: it halts rather
constexpr double kLeastFeed = 0.01;  // mm/s

} // namespace

geom::Rotation orientation(const Vec3& axis, const Vec3& heading) { return geom::rotation_of(-1.0 * axis, heading); }

RobotProgram::RobotProgram(const machine::Profile& profile, const FirstPass& first_pass, Text out, ModuleFile modules)
    : Writer(profile, placeholders(first_pass, profile, {}), out), extruder_speed_(kAxisSpeed),
      modules_(std::move(modules)), main_(std::move(out)) {
    const int most = profile.robot.module_moves;
    split_ = most > 0 && first_pass.moves > static_cast<std::uint64_t>(most);
    if (split_ && !modules_)
        throw Error(Exit::usage, "cannot write one module of " + std::to_string(first_pass.moves) + " moves: '" +
                                     profile.name + "' takes " + std::to_string(most) +
                                     "; give a folder for the others by --modules, or raise robot.module_moves");
}

void RobotProgram::begin(const std::vector<std::string>& about) {
    // A module's first line must be its own in some languages: what it is stands behind.
    code(profile_->templates.start);
    for (const auto& line : about) comment(line);
    if (split_) begin_module();
}

void RobotProgram::end(const std::vector<std::string>& history) {
    settle(0);
    if (split_) run_modules();
    for (const auto& line : history) comment(line);
    comment("end of program, " + std::to_string(lines_) + " moves");
    code(profile_->templates.end);
    flush();
}

void RobotProgram::begin_module() {
    flush();
    values_["module"] = ++module_;
    in_module_ = 0;
    redirect(modules_(machine::expand(profile_->robot.module_file, values_)));
    code(profile_->robot.module_start);
    said_ = {};
}

void RobotProgram::end_module() {
    code(profile_->robot.module_end);
    flush();
}

// In the main program: all are there before the robot moves, so that it does not stand between them.
void RobotProgram::run_modules() {
    end_module();
    redirect(main_);
    const auto& r = profile_->robot;
    for (const std::string* text : {&r.module_load, &r.module_call, &r.module_unload})
        for (int m = 1; m <= module_; ++m) {
            values_["module"] = m;
            code(*text);
        }
}

double RobotProgram::blend(double shorter) const {
    const double most = std::min(profile_->axes.blend, shorter / kNeighbour);
    if (profile_->format.dialect != Dialect::krl) return most < kLeastBlend ? 0 : most;
    double level = profile_->axes.blend;
    while (level > most && level >= kLeastBlend) level /= 2;
    return level < kLeastBlend ? 0 : level;
}

// Writes the move that waits; the one behind it is `next` mm long, 0 if it must halt.
void RobotProgram::settle(double next) {
    if (!pending_) return;
    const Step step = *std::exchange(pending_, std::nullopt);
    write(step, step.halt ? 0 : blend(std::min(step.length, next)));
    trigger_.clear();
}

void RobotProgram::write(const Step& step, double blend) {
    RobotLine line;
    line.tip = {orientation(step.axis, step.heading), step.to};
    line.joint = step.act == Act::stand;
    line.posture = step.posture;
    // Where the tool turns more than it goes, or an axis cannot follow, it goes slower than its feed.
    line.feed = step.seconds > 0 && step.length > 0 ? std::max(step.length / step.seconds, kLeastFeed) : step.feed;
    line.seconds = step.length > 0 ? 0 : step.seconds;
    line.blend = blend;
    if (counts()) line.extruder = fed_;
    line.extruder_speed = extruder_speed_;
    line.trigger = trigger_;
    append_robot_line(text_, line, *profile_, profile_->format.crlf ? "\r\n" : "\n", said_);
    last_ = step;
    ++lines_;
    ++in_module_;
}

void RobotProgram::move(const Step& step) {
    laid_ += feeds(step);
    if (step.length == 0 && step.seconds == 0 && lines_ > 0) return;
    const bool travels = step.act != Act::extrude;
    settle(step.length);
    const auto most = static_cast<std::uint64_t>(profile_->robot.module_moves);
    if (split_ && (in_module_ >= most || (travels && in_module_ >= most / 2))) {
        end_module();
        begin_module();
    }
    pending_ = step;
    fed_ = laid_;
}

void RobotProgram::stand(const Step& step) {
    settle(0);
    fed_ = laid_;
    write(step, 0);
}

// Codes belong to the very place.
void RobotProgram::codes(const std::string& text) {
    if (text.empty()) return;
    settle(0);
    code(text);
}

// Pushes fibre where the tool is: the extruder moves alone.
void RobotProgram::push() {
    if (!counts() || profile_->fibre.prime == 0) return;
    settle(0);
    laid_ += profile_->fibre.prime;
    fed_ = laid_;
    extruder_speed_ = profile_->fibre.prime_speed;
    Step still = last_;
    still.act = Act::travel;
    still.length = still.seconds = 0;
    still.feed = profile_->fibre.prime_speed;
    write(still, 0);
    extruder_speed_ = kAxisSpeed;
}

void RobotProgram::layer(const Step& step) {
    values_["layer"] = step.layer;
    values_["z"] = step.to.z;
    values_["height"] = step.height;
    codes(profile_->templates.layer);
}

void RobotProgram::open(const Step& step) {
    trigger(on_trigger(step));
    if (on_trigger(step).empty()) codes(on(step));
}

void RobotProgram::close(const Step& step) {
    trigger(off_trigger(step));
    if (off_trigger(step).empty()) codes(off(step));
}

// At the end of the move that waits, or where the tool is.
void RobotProgram::trigger(const std::string& name) {
    if (name.empty()) return;
    if (!pending_) {
        pending_ = last_;
        pending_->act = Act::travel;
        pending_->length = pending_->seconds = 0;
        pending_->feed = kLeastFeed;
    }
    trigger_ = name;
}

// Taken back and given again on the way: with the next move.
void RobotProgram::retract() { laid_ -= own().travel.retract; }
void RobotProgram::prime() { laid_ += own().travel.retract + own().travel.extra; }

void RobotProgram::change_tool(const Step& step) {
    settle(0);
    tool(step);
    said_ = {};
}

void RobotProgram::cut() { codes(profile_->fibre.cut); }
void RobotProgram::tension() { codes(profile_->fibre.tension); }

} // namespace filum::postproc
