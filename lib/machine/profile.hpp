// A machine as its profile file describes it: what it can reach, how it is fed, how its programs are written.
#pragma once

#include "geom/vec.hpp"
#include "machine/cooling.hpp"
#include "machine/feature_rules.hpp"
#include "machine/fibre.hpp"
#include "machine/head.hpp"
#include "machine/multi_axis.hpp"
#include "machine/robot.hpp"
#include "preset/settings.hpp"
#include "toolpath/path.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace filum::machine {

// What the nozzle tip can reach, mm.
struct Bed {
    double x_min = 0, x_max = 0, y_min = 0, y_max = 0, z_min = 0, z_max = 0;
    std::vector<geom::Vec2> outline{}; // of a bed that is no rectangle: convex, counter-clockwise, mm
    double z_offset = 0; // mm that programs say more than the toolpath does, as the end stop is that much off
    [[nodiscard]] geom::Vec2 centre() const { return {(x_min + x_max) / 2, (y_min + y_max) / 2}; }
};

// What the extruder word of a move counts.
enum class Feeding : std::uint8_t {
    filament, // mm of filament
    plunger,  // mm of a syringe's plunger
    volume,   // mm3
    valve,    // nothing: no word, the codes `on` and `off` open and close
};

struct Extrusion {
    Feeding feeding = Feeding::filament;
    char letter = 'E';                    // of the extruder word
    bool relative = true;                 // per move, or counted on from the last reset
    double diameter = 1.75;               // mm, of the filament or of the syringe's bore
    double nozzle = 0;                    // mm, diameter of the nozzle's hole; 0: unknown
    double flow = 1;                      // factor on all material
    double density = 0;                   // g/cm3; 0: unknown
    std::string on, off;                  // codes before the first and after the last move of a stroke, may be empty
    std::string on_trigger, off_trigger;  // RAPID: triggers that do the same at the very place, while the robot goes on
    [[nodiscard]] double per_mm3() const; // extruder units for one mm3 of bead
};

struct Limits {
    double section = std::numeric_limits<double>::infinity();               // mm2, largest bead cross-section
    double narrowest = 0, widest = std::numeric_limits<double>::infinity(); // mm, of beads that the nozzle lays
    double flow = std::numeric_limits<double>::infinity();                  // mm3/s; feeds are lowered to keep it
    double layer_time = 0; // s: feeds are lowered so that a layer takes at least so long
    double turn_outside = std::numeric_limits<double>::infinity(); // mm beyond a part's rims; 0: not at all
};

// Speeds of the nozzle, mm/s.
struct Feeds {
    double bead = 50, first_layer = 25, lift = 25, jog = 50, connector = 20, travel = 150, z = 10;
    std::array<double, toolpath::kFeatures> feature{}; // of beads that have one; 0: as bead
};

// What a break costs.
struct Travel {
    // mm: travels, the first approach and the end are at least so high, as over the walls of wells
    double above = 0;
    double lift = 0.6;                                                     // mm above everything printed so far
    double retract = 0.8;                                                  // extruder units taken back, 0 for none
    double retract_speed = 35;                                             // extruder units per s
    double retract_acceleration = std::numeric_limits<double>::infinity(); // extruder units per s2
    double extra = 0;                       // extruder units given on top when printing goes on
    double min_length = 0;                  // mm; a shorter travel keeps its height and does not retract
    std::string retract_codes, prime_codes; // where the firmware takes material back and gives it: G10, G11
};

// Whose rules plan the moves; see look_ahead.hpp, parabolic.hpp.
enum class Controller : std::uint8_t { marlin, klipper, reprapfirmware, linuxcnc };

// What the machine's own settings are, for print times; see motion.hpp.
struct Motion {
    Controller controller = Controller::marlin;
    double max_speed = 300;                                          // mm/s along the path
    double max_speed_z = 10;                                         // mm/s along z
    double acceleration = 1500;                                      // mm/s2, extruding; LinuxCNC: of each axis
    double travel_acceleration = 1500;                               // mm/s2
    double acceleration_z = std::numeric_limits<double>::infinity(); // mm/s2
    double corner_speed = 5; // mm/s through a corner of 90 degrees; RepRapFirmware: the jump of an axis
    double extruder_corner_speed = std::numeric_limits<double>::infinity(); // extruder units/s that it may jump
    double minimum_cruise_ratio = 0.5;                                      // Klipper's
    double arc_resolution = 1; // mm: Klipper's, of [gcode_arcs]: it cuts an arc into chords of at least this length
    double blend = 0;          // mm: LinuxCNC's G64 P, the value `tolerance`
    int look_ahead = 0;        // moves that the controller plans together; 0: as many as matter
    // Moves/s that the controller takes, on average over the moves that it plans together (0: 16).
    double moves_per_second = std::numeric_limits<double>::infinity();
};

// How far programs may be from the toolpath to need fewer moves; all 0: not at all.
struct Merging {
    double planar = 0, surface = 0; // mm, of planar paths and of those that lean the tool
    double axis = 0;                // rad, of the tool's axis on surfaces
};
// What `postproc` takes unless told otherwise: 0.01 mm; 0.02 mm and half a degree.
Merging standard_merging();

enum class CommentStyle : std::uint8_t { semicolon, parentheses, exclamation, hash };

enum class Dialect : std::uint8_t {
    gcode,
    krl,      // KUKA
    rapid,    // ABB
    urscript, // Universal Robots
};

// How a program says which of several parts it is at.
enum class Objects : std::uint8_t { none, exclude_object, m486 };

struct Format {
    int xyz_decimals = 3, e_decimals = 5, f_decimals = 0;
    Dialect dialect = Dialect::gcode;
    CommentStyle comments = CommentStyle::semicolon;
    bool viewer_comments = true; // ;TYPE: ;LAYER_CHANGE ;Z: ;HEIGHT: ;WIDTH:
    bool crlf = false;           // line ends
    std::string travel_code = "G0";
    bool arcs = false; // the controller takes G2 and G3
    Objects objects = Objects::none;
};

// Text with {placeholders}; see template.hpp.
struct Templates {
    std::string start, layer, end;
    std::string upper_layers, first_layer; // when the first layer is left for those above, and when it is come back to
    std::string pause;                     // the machine waits for its user
    std::string progress;                  // tells how far the print is, whenever a percent or a minute has passed

    bool primed = false; // material stands at the nozzle's tip when the start is over
};

struct Profile {
    std::string name;        // letters, digits, '.', '_', '-'
    std::string fingerprint; // 16 hex digits over the profile's text: with `name`, what the history says of it
    std::string about;       // one line
    Bed bed;
    Head head;
    Extrusion extrusion;
    Limits limits;
    Feeds feeds;
    FeatureRules features;
    Cooling cooling;
    Travel travel;
    Motion motion;
    Merging merging; // none of the file's: the user says it
    // Share of its feed that each layer keeps, so that it takes limits.layer_time; layers behind the last keep all.
    std::vector<double> pace;
    MultiAxis axes;
    Robot robot; // of tool frames
    Tools tools;
    Fibre fibre;
    Format format;
    Templates templates;
    std::shared_ptr<const preset::Preset> preset; // of a slicer: its G-code instead of start, layer, end and pause
    std::map<std::string, double> values;         // the user's own placeholders: nozzle_temp, bed_temp, ...

    // Of a tool with a section of its own, [tool.N].
    std::string change; // codes when it takes over; "": tools.change
    geom::Vec3 offset;  // mm: from tool 0's tip to its own; the controller does not know
    // Tools with a section of their own, each with the whole profile as it is for it; see of_tool.
    std::map<std::uint32_t, std::shared_ptr<const Profile>> own;
};

// The profile as it is for a tool: head, extrusion, limits, feeds, travel, offset, kinematics and frame of its own
// where it has a section; else `profile` itself.
inline const Profile& of_tool(const Profile& profile, std::uint32_t tool) {
    const auto found = profile.own.find(tool);
    return found == profile.own.end() ? profile : *found->second;
}

// Throws Error(usage) if the machine does not let paths turn that far, mm, beyond the rims of a part; `where` is what
// asks for it.
void allow_outside(const Profile& profile, double depth, const std::string& where);

// Codes when the tool takes over; "": there are none.
const std::string& change_codes(const Profile& profile, std::uint32_t tool);

// The profile in `name_or_path`: a file if that holds a '/' or ends in ".toml", else NAME.toml in the folders of
// $FILUM_PROFILES (separated by ':'), then in ../share/filum/profiles and ../../share/filum/profiles beside the
// executable.  `set` changes keys of the file: "feeds.bead=40,nozzle_temp=230"; a key without a section is a value.
// Throws Error: usage for an unknown name (listing the known ones) or a wrong `set`; io if it cannot be read; bad_input
// naming file, line and key for an unknown key, a wrong type or an impossible value.
Profile load_profile(const std::string& name_or_path, const std::string& set = "");

// The same from text; `file` is what messages call it, and beside which a robot's model is sought.
Profile parse_profile(std::string_view text, const std::string& file, const std::string& set = "");

// Names that load_profile knows, sorted.
std::vector<std::string> profile_names();

// The text of a profile, found as load_profile does.
std::string profile_text(const std::string& name_or_path);

// Sets the pace of layers, of the profile and of its own tools.
void set_pace(Profile& profile, const std::vector<double>& pace);

// Sets the merging of the profile and of its own tools.
void merge_moves(Profile& profile, const Merging& merging);

} // namespace filum::machine
