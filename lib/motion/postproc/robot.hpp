// Programs of robots, in the robot's own language, with one tool frame per move.
#pragma once

#include "geom/frame.hpp"
#include "postproc/first_pass.hpp"
#include "postproc/robot_lines.hpp"
#include "postproc/writer.hpp"

namespace filum::postproc {

// The orientation of a tool whose z axis points out of the nozzle.  `axis` is the tool axis, which points up the tool.
// `heading` is the direction of the tool's x axis; only its part perpendicular to `axis` counts.
geom::Rotation orientation(const Vec3& axis, const Vec3& heading);

// Writes lines as append_robot_line does.
//
// A move blends into the next one within the profile's blend, at most a third of the shorter of the two.  In KRL a new
// blend needs a line of its own.  So there it is the profile's blend, or a half, a quarter and so on of it.  A move
// halts if a code follows.  Triggers are the exception, as they switch at the exact place while the robot goes on.
//
// An extruder is the first external axis, with absolute values from 0 at the start.  URScript has no such axis: its
// extruder is a valve.
//
// A program with more moves than a module may have is divided into modules, which the main program runs.  A new module
// begins between strokes once the current one is half full, and anywhere once it is full.
class RobotProgram final : public Writer {
  public:
    RobotProgram(const machine::Profile& profile, const FirstPass& first_pass, Text out, ModuleFile modules);
    void begin(const std::vector<std::string>& about) override;
    void end(const std::vector<std::string>& history) override;

  private:
    void layer(const Step& step) override;
    void open(const Step& step) override;
    void close(const Step& step) override;
    void retract() override;
    void prime() override;
    void change_tool(const Step& step) override;
    void push() override;
    void cut() override;
    void tension() override;
    void move(const Step& step) override;
    void stand(const Step& step) override;
    void codes(const std::string& text);
    void settle(double next);
    void trigger(const std::string& name);
    void write(const Step& step, double blend);
    void begin_module();
    void end_module();
    void run_modules();
    [[nodiscard]] double blend(double shorter) const;
    double laid_ = 0; // extruder units
    ModalState modal_;
    double extruder_speed_;       // mm/s, maximum
    std::optional<Step> pending_; // the move not yet written: its end depends on what follows
    double fed_ = 0;              // extruder position at its end
    std::string trigger_;         // to switch at its end; "": none
    Step last_;                   // the move written last
    std::uint64_t lines_ = 0;
    ModuleFile modules_;
    bool split_ = false;          // the program is divided into modules
    std::uint64_t in_module_ = 0; // moves in the current module
    int module_ = 0;
    Text main_;
};

} // namespace filum::postproc
