// Programs of robots: a tool frame per move, in the robot's own language.
#pragma once

#include "geom/frame.hpp"
#include "postproc/first_pass.hpp"
#include "postproc/robot_lines.hpp"
#include "postproc/writer.hpp"

namespace filum::postproc {

// How a tool stands whose z axis leaves the nozzle: of a tool axis (which points up the tool) and the heading of its x
// axis, which counts as far as it lies across.
geom::Rotation orientation(const Vec3& axis, const Vec3& heading);

// Lines as append_robot_line has them.  A move flies by its end by the profile's blend, by a third of the shorter one
// of its neighbours at most (in KRL, where that is a line of its own, by the blend or a half, a quarter, ... of it); it
// halts where a code follows, but for triggers, which switch at the very place.
// An extruder is the first external axis, counted absolutely from 0 at the start; URScript has none: its extruder is a
// valve.  A program of more moves than a module may have goes on in modules of its own, which the main one runs; a new
// one begins between strokes if it is half full, else where it is full.
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
    Said said_;
    double extruder_speed_;       // mm/s at most
    std::optional<Step> pending_; // not written yet: how it ends depends on what follows
    double fed_ = 0;              // where the extruder stands at its end
    std::string trigger_;         // at its end
    Step last_;                   // written
    std::uint64_t lines_ = 0;
    ModuleFile modules_;
    bool split_ = false;          // in modules
    std::uint64_t in_module_ = 0; // moves
    int module_ = 0;
    Text main_;
};

} // namespace filum::postproc
