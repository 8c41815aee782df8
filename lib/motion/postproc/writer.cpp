#include "postproc/writer.hpp"

#include "postproc/digits.hpp"
#include "postproc/program.hpp"
#include "postproc/robot.hpp"

namespace filum::postproc {

namespace {

constexpr std::size_t kBlock = std::size_t{64} << 10;

} // namespace

Writer::Writer(const machine::Profile& profile, machine::Values values, Text out)
    : profile_(&profile), values_(std::move(values)), out_(std::move(out)) {
    text_.reserve(kBlock + 1024);
}

void Writer::add(std::span<const Step> steps) {
    for (const Step& step : steps) {
        switch (step.act) {
        case Act::layer:
            layer(step);
            break;
        case Act::open:
            open(step);
            break;
        case Act::close:
            close(step);
            break;
        case Act::retract:
            retract();
            break;
        case Act::prime:
            prime();
            break;
        case Act::tool:
            change_tool(step);
            break;
        case Act::purge:
            purge(step);
            break;
        case Act::push:
            push();
            break;
        case Act::tension:
            tension();
            break;
        case Act::cut:
            cut();
            break;
        case Act::stand:
            stand(step);
            break;
        case Act::omit:
            break;
        case Act::travel:
        case Act::climb:
        case Act::extrude:
            move(step);
            break;
        }
        spill();
    }
}

void Writer::comment(std::string_view text) {
    append_comment(text_, text, profile_->format.comments);
    end_line();
}

void Writer::code(const std::string& text) {
    if (text.empty()) return;
    // The angles of a robot's frame need more decimals than positions do.
    const int decimals = profile_->format.dialect == machine::Dialect::gcode ? 5 : 9;
    for (const char c : machine::expand(text, values_, decimals)) {
        if (c == '\n')
            end_line();
        else
            text_ += c;
    }
    if (text.back() != '\n') end_line();
}

void Writer::tool(const Step& step) {
    values_["tool_last"] = profile_->tools.first + static_cast<double>(tool_);
    tool_ = step.tool;
    for (const auto& [name, value] : own().values) values_[name] = value;
    values_["tool_no"] = profile_->tools.first + static_cast<double>(step.tool);
    if (profile_->format.dialect != machine::Dialect::gcode) machine::add_frame("tool", own().robot.tool, values_);
    code(machine::change_codes(*profile_, step.tool));
}

const std::string& Writer::on(const Step& step) const {
    return lays_fibre(step) ? profile_->fibre.on : own(step).extrusion.on;
}

const std::string& Writer::off(const Step& step) const {
    return lays_fibre(step) ? profile_->fibre.off : own(step).extrusion.off;
}

void Writer::spill() {
    if (text_.size() >= kBlock) flush();
}

void Writer::flush() {
    out_(text_);
    text_.clear();
}

std::unique_ptr<Writer> writer(const machine::Profile& profile, const FirstPass& first_pass, Vec2 shift, Text out,
                               ModuleFile modules) {
    if (profile.format.dialect != machine::Dialect::gcode)
        return std::make_unique<RobotProgram>(profile, first_pass, std::move(out), std::move(modules));
    return std::make_unique<Program>(profile, first_pass, shift, std::move(out));
}

} // namespace filum::postproc
