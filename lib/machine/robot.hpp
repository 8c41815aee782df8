// What a profile says of a robot: where the part, the tool and its own axes are.
#pragma once

#include "geom/frame.hpp"
#include "kinematics/arm.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace filum::machine {

class Document;

struct Robot {
    std::string model;                  // as the profile names it; "": unknown, so nothing about its axes is checked
    std::optional<kinematics::Arm> arm; // of the model
    geom::Frame base;                   // the part's frame (work object), seen from the robot's base
    geom::Frame tool;                   // the nozzle's tip, z out of it, seen from the flange
    kinematics::Posture start{};        // rad: where the axes stand when the program begins
    double singular = 0;                // rad: nearer to a singularity than that is told, and kept away from
    int module_moves = 0;               // moves in a module of a program; 0: it is one
    std::string module_file, module_start, module_end;   // its name, codes around it
    std::string module_load, module_call, module_unload; // codes before all moves, that run it, after all moves
};

// Reads the section [robot], which machines of tool frames need and others must not have; `file`: the profile's, beside
// which a model's file is sought.  Throws Error(bad_input) as parse_profile does, or for a model that cannot be used.
void read_robot(Document& doc, const std::string& file, bool frames, Robot& out);
void read_tool_frame(Document& doc, Robot& out); // of a tool with a section of its own: `frame`

// Which links of a URDF are the robot's base, as its controller counts, and its flange.  "": a link named "base" or
// "base_link", or the root; and a link named "tool0" or "flange" or, without one, the last of the only chain of six
// axes.
struct RobotLinks {
    std::string base, flange;
};

// A model by its name, in the folders of profiles (robots/NAME.toml) or beside them, or by its file: a table of Denavit
// and Hartenberg as TOML, or a URDF.  Throws Error: io if it cannot be read, bad_input for what is no robot of six
// turning axes, naming what is wrong.
kinematics::Arm load_robot(const std::string& name_or_path, const std::string& beside, const RobotLinks& links);
kinematics::Arm table_robot(std::string_view text, const std::string& file);
kinematics::Arm urdf_robot(std::string_view text, const std::string& file, const RobotLinks& links);

std::vector<std::string> robot_names(); // that load_robot knows, sorted

// Numbers of a frame for templates, each with `name` before it: _x _y _z mm, _a _b _c degrees (Euler ZYX),
// _q1 to _q4 (quaternion), _mx _my _mz m, _rx _ry _rz rad (rotation vector).
void add_frame(const std::string& name, const geom::Frame& frame, std::map<std::string, double>& to);

// Numbers for templates: the frames "base" and "tool", start_1 to start_6 (degrees), start_r1 to start_r6 (rad),
// module.
void add_robot(const Robot& robot, std::map<std::string, double>& to);

} // namespace filum::machine
