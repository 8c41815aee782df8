// A robot: the frames of the part and the tool, and its axes; [robot] of a profile.
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
    std::string model;                  // name or file; "": unknown, so its axes are not checked
    std::optional<kinematics::Arm> arm; // the model's axes
    geom::Frame base;                   // the part's frame (work object), in the robot's base
    geom::Frame tool;                   // the nozzle's tip, z out of it, in the flange's frame
    kinematics::Posture start{};        // rad: posture at the start of the program
    double singular = 0;                // rad: distance from singularities to keep; nearer ones are reported
    int module_moves = 0;               // most moves in a module of a program; 0: no limit
    std::string module_file, module_start, module_end;   // a module's file name, and codes around it
    std::string module_load, module_call, module_unload; // codes: load before all moves, run, unload at the end
};

// Reads the section [robot], which machines with tool frames need and others must not have.  `file` is the profile's;
// a model's file is sought beside it.  Throws Error(bad_input) as parse_profile does, and for a model that cannot be
// used.
void read_robot(Document& doc, const std::string& file, bool frames, Robot& out);
void read_tool_frame(Document& doc, Robot& out); // `frame` of a tool with a section of its own

// The links of a URDF that are the robot's base, as its controller counts, and its flange.  An empty `base` means a
// link named "base" or "base_link", or else the root.  An empty `flange` means a link named "tool0" or "flange", or
// else the last link of the only chain of six axes.
struct RobotLinks {
    std::string base, flange;
};

// Loads a model by name, from robots/NAME.toml in the folders of profiles or beside them, or by its file.  A model is a
// table of Denavit and Hartenberg as TOML, or a URDF.  Throws Error: io if it cannot be read; bad_input for an unknown
// name, and with the reason if it is no robot with six turning axes.
kinematics::Arm load_robot(const std::string& name_or_path, const std::string& beside, const RobotLinks& links);
kinematics::Arm table_robot(std::string_view text, const std::string& file);
kinematics::Arm urdf_robot(std::string_view text, const std::string& file, const RobotLinks& links);

std::vector<std::string> robot_names(); // the names that load_robot knows, sorted

// Adds the numbers of a frame for templates, each with `name` before it: _x _y _z mm, _a _b _c degrees (Euler ZYX),
// _q1 to _q4 (quaternion), _mx _my _mz m, _rx _ry _rz rad (rotation vector).
void add_frame(const std::string& name, const geom::Frame& frame, std::map<std::string, double>& to);

// Adds the numbers of a robot for templates: the frames "base" and "tool", start_1 to start_6 (degrees), start_r1 to
// start_r6 (rad), and module.
void add_robot(const Robot& robot, std::map<std::string, double>& to);

} // namespace filum::machine
