// Programs of robots: a tool frame per move, in the robot's own language.
#pragma once

#include "postproc/survey.hpp"
#include "postproc/writer.hpp"

#include <array>

namespace filum::postproc {

// The orientation of a tool whose z axis leaves the nozzle: columns x, y, z, orthonormal, right-handed.
struct Orientation {
    Vec3 x, y, z;
};

// Of a tool axis (which points up the tool) and the heading of its x axis, which counts as far as it lies across.
Orientation orientation(const Vec3& axis, const Vec3& heading);

std::array<double, 3> euler_zyx(const Orientation& o);       // A, B, C of KRL: about z, the new y, the new x; rad
std::array<double, 4> quaternion(const Orientation& o);      // w, x, y, z of RAPID; w >= 0
std::array<double, 3> rotation_vector(const Orientation& o); // of URScript: axis times angle in [0, pi], rad

// KUKA KRL:    LIN {X 1,Y 2,Z 3,A 0,B 0,C 180,E1 4} C_DIS      mm, degrees; speeds as $VEL.CP in m/s
// ABB RAPID:   MoveL [[1,2,3],[0,1,0,0],[0,0,0,0],[4,9E9,...]],[20,500,5000,1000],zone,tool\WObj:=object;
// URScript:    movel(p[0.001,0.002,0.003,3.14,0,0],a=1,v=0.02,r=0.0005)      m, rad
// An extruder is the first external axis, counted absolutely; URScript has none: its extruder is a valve.
class RobotProgram final : public Writer {
  public:
    RobotProgram(const machine::Profile& profile, const Survey& survey, Text out);
    void begin(const std::vector<std::string>& about) override;
    void end() override;

  private:
    void layer(const Step& step) override;
    void close(const Step& step) override;
    void retract() override;
    void prime() override;
    void change_tool(const Step& step) override;
    void push() override;
    void cut() override;
    void move(const Step& step) override;
    void number(double value, int decimals);
    void list(std::span<const double> values, int decimals);
    void write(const Step& step);
    void krl(const Step& step, const Orientation& o);
    void rapid(const Step& step, const Orientation& o);
    void urscript(const Step& step, const Orientation& o);
    double laid_ = 0;   // extruder units
    double speed_ = -1; // mm/s, as last said
    double axis_speed_; // mm/s at most, of the extruder
    Step last_;         // written
    std::uint64_t lines_ = 0;
};

} // namespace filum::postproc
