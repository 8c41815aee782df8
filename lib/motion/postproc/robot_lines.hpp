// One move as a line of a robot's language.
#pragma once

#include "geom/frame.hpp"
#include "kinematics/arm.hpp"
#include "machine/profile.hpp"

#include <optional>
#include <string>

namespace filum::postproc {

struct RobotLine {
    geom::Frame tip;                              // in the part's frame; z points out of the nozzle
    const kinematics::Posture* posture = nullptr; // for a joint move: its end, if known
    bool joint = false;                           // a joint move; else the tip moves straight
    double feed = 0;                              // mm/s
    double seconds = 0;                           // s, of a move that only turns the tool; else 0
    double blend = 0;                             // mm before its end where the next move may begin; 0: it halts
    std::optional<double> extruder;               // position of the extruder's axis
    double extruder_speed = 0;                    // mm/s, maximum
    std::string trigger;                          // RAPID: the trigger to switch at the end of the move
};

// The settings that earlier lines made and that still hold; -1: none.
struct ModalState {
    double feed = -1, blend = -1;
};

// Appends the line or lines of a move, each followed by `end`.
// KUKA KRL:    LIN {X 1,Y 2,Z 3,A 0,B 0,C 180,E1 4} C_DIS      mm, degrees; speeds as $VEL.CP in m/s, $APO.CDIS in mm
//              PTP {X 1,Y 2,Z 3,A 0,B 0,C 180,S 2,T 2,E1 4}    status and turn of the posture
// ABB RAPID:   MoveL [[1,2,3],[0,1,0,0],[0,0,0,0],[4,9E9,...]],[20,60,5000,1000],zone,tool\WObj:=object;
//              TriggL [[...]],[...],trigger,zone,tool\WObj:=object;        MoveAbsJ [[1,...,6],[4,9E9,...]],...
// URScript:    movel(pose_trans(filum_part,p[0.001,0.002,0.003,3.14,0,0]),a=1,v=0.02,r=0.0005)     m, rad
//              movej([1,...,6],a=1,v=0.5)
void append_robot_line(std::string& out, const RobotLine& line, const machine::Profile& profile, const char* end,
                       ModalState& modal);

// KUKA's Status of a posture is a sum.  It holds 1 if the wrist is behind axis 1.  It holds 2 if the wrist is in front
// of the line through axes 2 and 3, and 4 if axis 5 is negative.
// KUKA's Turn has a bit for each negative axis.
int krl_status(const kinematics::Arm& arm, const kinematics::Posture& posture);
int krl_turn(const kinematics::Posture& posture);

} // namespace filum::postproc
