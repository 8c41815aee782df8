#include "postproc/robot.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace filum::postproc {

namespace {

using machine::Dialect;

constexpr double kAxisSpeed = 5000;  // mm/s: fast enough for the extruder to keep up with any path
constexpr double kNeighbour = 3;     // a blend is at most this part of the shorter neighbour
constexpr double kLeastBlend = 1e-3; // mm: with a smaller blend the robot halts instead
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
    // In some languages the first line must be the module's header, so the comments come after it.
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
    modal_ = {};
}

void RobotProgram::end_module() {
    code(profile_->robot.module_end);
    flush();
}

// Loads all modules before the first is run, so that the robot does not stop between them.
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

// Writes the pending move.  `next` is the length of the move after it, mm; 0 if the robot must halt.
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
    // A move is slower than its feed if the tool turns much, or if an axis cannot follow.
    line.feed = step.seconds > 0 && step.length > 0 ? std::max(step.length / step.seconds, kLeastFeed) : step.feed;
    line.seconds = step.length > 0 ? 0 : step.seconds;
    line.blend = blend;
    if (counts()) line.extruder = fed_;
    line.extruder_speed = extruder_speed_;
    line.trigger = trigger_;
    append_robot_line(text_, line, *profile_, profile_->format.crlf ? "\r\n" : "\n", modal_);
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

// Writes codes where the pending move ends, so that the move must halt.
void RobotProgram::codes(const std::string& text) {
    if (text.empty()) return;
    settle(0);
    code(text);
}

// Pushes fibre while the tool stands still: only the extruder moves.
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

// Switches a trigger at the end of the pending move, or where the tool is if there is none.
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

// Material is taken back and pushed forward during the next move.
void RobotProgram::retract() { laid_ -= own().travel.retract; }
void RobotProgram::prime() { laid_ += own().travel.retract + own().travel.extra; }

void RobotProgram::change_tool(const Step& step) {
    settle(0);
    tool(step);
    modal_ = {};
}

void RobotProgram::cut() { codes(profile_->fibre.cut); }
void RobotProgram::tension() { codes(profile_->fibre.tension); }

} // namespace filum::postproc
