// The profile of a machine: what it can reach, how it extrudes and moves, and how its programs are written.
#pragma once

#include "geom/vec.hpp"
#include "machine/cooling.hpp"
#include "machine/feature_rules.hpp"
#include "machine/fibre.hpp"
#include "machine/head.hpp"
#include "machine/multi_axis.hpp"
#include "machine/overhang.hpp"
#include "machine/purge.hpp"
#include "machine/robot.hpp"
#include "preset/settings.hpp"
#include "toolpath/path.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace filum::machine {

// The space that the nozzle tip can reach, mm.
struct Bed {
    double x_min = 0, x_max = 0, y_min = 0, y_max = 0, z_min = 0, z_max = 0;
    std::vector<geom::Vec2> outline{}; // of a bed that is no rectangle: convex, counter-clockwise
    double z_offset = 0;               // added to z in programs, to correct an end stop
    [[nodiscard]] geom::Vec2 centre() const { return {(x_min + x_max) / 2, (y_min + y_max) / 2}; }
};

// The unit of a move's extruder word.
enum class Feeding : std::uint8_t {
    filament, // mm of filament
    plunger,  // mm of a syringe's plunger
    volume,   // mm3
    valve,    // none: there is no word; the codes `on` and `off` open and close a valve
};

struct Extrusion {
    Feeding feeding = Feeding::filament;
    char letter = 'E';                    // of the extruder word
    bool relative = true;                 // true: material per move; false: total since the last reset
    double diameter = 1.75;               // mm, of the filament or of the syringe's bore
    double nozzle = 0;                    // mm, diameter of the nozzle's hole; 0: unknown
    double flow = 1;                      // factor on all material
    double density = 0;                   // g/cm3; 0: unknown
    double cost = 0;                      // of 1 kg, in the user's money; 0: unknown
    std::string on, off;                  // codes before the first and after the last move of a stroke; "": none
    std::string on_trigger, off_trigger;  // RAPID: triggers instead, which do not stop the robot
    [[nodiscard]] double per_mm3() const; // extruder units for one mm3 of bead
};

struct Limits {
    double section = std::numeric_limits<double>::infinity();               // mm2, largest bead cross-section
    double narrowest = 0, widest = std::numeric_limits<double>::infinity(); // mm, bead widths of the nozzle
    double flow = std::numeric_limits<double>::infinity();                  // mm3/s; feeds are lowered to keep it
    double layer_time = 0;                                                  // s per layer, at least; feeds are lowered
    double least_feed = 0;                                                  // mm/s: layer_time lowers no feed below it
    double turn_outside = std::numeric_limits<double>::infinity(); // mm that paths may turn beyond a part's rims
};

// Speeds of the nozzle, mm/s.
struct Feeds {
    double bead = 50, first_layer = 25, lift = 25, jog = 50, connector = 20, travel = 150, z = 10;
    double rise = 0;                // s in which the speed of a stroke rises to its full value; 0: at once
    double first_layer_infill = 0;  // of infill and solid areas of the first layer; 0: as first_layer
    double first_layer_share = 0;   // of a bead's speed on other layers, instead of both; 0: as these say
    bool first_layer_exact = false; // both also for beads that are slower on other layers
    std::array<double, toolpath::kFeatures> feature{}; // by feature; 0: as bead
};

// Travels and retractions.
struct Travel {
    // mm: lowest height of travels, of the first approach and of the end, as over the walls of wells
    double above = 0;
    double lift = 0.6;         // mm that travels are above everything printed so far
    double retract = 0.8;      // extruder units taken back; 0: none
    double retract_speed = 35; // extruder units per s
    double prime_speed = 0;    // extruder units per s when the material comes back; 0: as retract_speed
    double retract_acceleration = std::numeric_limits<double>::infinity(); // extruder units per s2
    double extra = 0;       // extruder units added when printing goes on; below 0: so many fewer come back
    double wipe = 0;        // mm: way back over the bead during a retraction; 0: the nozzle stands still
    double before_wipe = 0; // share of the retraction before the wipe
    double min_length = 0;  // mm; a shorter travel keeps its height and does not retract
    std::string retract_codes, prime_codes; // for retraction by the firmware: G10, G11
};

// The controllers whose motion planners are modelled; see look_ahead.hpp and parabolic.hpp.
enum class Controller : std::uint8_t { marlin, klipper, reprapfirmware, linuxcnc };

// The machine's own settings, as print times need them; see motion.hpp.
struct Motion {
    Controller controller = Controller::marlin;
    double max_speed = 300;                                          // mm/s along the path
    double max_speed_z = 10;                                         // mm/s along z
    double acceleration = 1500;                                      // mm/s2, extruding; LinuxCNC: of each axis
    double travel_acceleration = 1500;                               // mm/s2
    double acceleration_z = std::numeric_limits<double>::infinity(); // mm/s2
    double corner_speed = 5; // mm/s through a corner of 90 degrees; RepRapFirmware: jump of an axis
    double extruder_corner_speed = std::numeric_limits<double>::infinity(); // extruder units/s, largest jump
    double minimum_cruise_ratio = 0.5;                                      // Klipper's
    double arc_resolution = 1; // mm: Klipper's, of [gcode_arcs]: shortest chord of an arc
    double blend = 0;          // mm: LinuxCNC's G64 P, the value `tolerance`
    int look_ahead = 0;        // moves that the controller plans together; 0: no limit
    // Moves/s that the controller takes, on average over the moves that it plans together; over 16 moves if look_ahead
    // is 0.
    double moves_per_second = std::numeric_limits<double>::infinity();
};

// The tolerances within which moves are merged; all 0: moves are not merged.
struct Merging {
    double planar = 0, surface = 0; // mm, of planar paths, and of paths that lean the tool
    double axis = 0;                // rad, of the tool's axis on surfaces
};
// The default of `postproc`: 0.01 mm on planar paths; 0.02 mm and half a degree on surfaces.
Merging standard_merging();

enum class CommentStyle : std::uint8_t { semicolon, parentheses, exclamation, hash };

enum class Dialect : std::uint8_t {
    gcode,
    krl,      // KUKA
    rapid,    // ABB
    urscript, // Universal Robots
};

// The language of labels for the parts on a bed; see postproc/labels.hpp.
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

// Codes with {placeholders}; see template.hpp.
struct Templates {
    std::string start, layer, end;
    std::string upper_layers, first_layer; // at a change from the first layer to upper ones, and back
    std::string pause;                     // makes the machine wait for its user
    std::string progress;                  // reports progress; written whenever a percent or a minute has passed

    bool primed = false; // material is at the nozzle's tip after the start
};

struct Profile {
    std::string name;        // letters, digits, '.', '_', '-'
    std::string fingerprint; // 16 hex digits, a hash of the profile's text, for the history
    std::string about;       // one line
    Bed bed;
    Head head;
    Extrusion extrusion;
    Limits limits;
    Feeds feeds;
    FeatureRules features;
    Overhang overhang;
    Cooling cooling;
    Travel travel;
    Motion motion;
    Merging merging; // not in the file: the user sets it
    // By layer: the share of its feeds that it keeps, so that it takes limits.layer_time; later layers keep all.
    std::vector<double> pace;
    MultiAxis axes;
    Robot robot; // for machines with tool frames
    Tools tools;
    Purge purge;
    Fibre fibre;
    Format format;
    Templates templates;
    std::shared_ptr<const preset::Preset> preset; // a slicer's profile; its G-code replaces start, layer, end and pause
    std::map<std::string, double> values;         // the user's own placeholders: nozzle_temp, bed_temp, ...

    // Only of a tool with a section of its own, [tool.N].
    std::string change; // codes when this tool takes over; "": tools.change
    geom::Vec3 offset;  // mm, from tool 0's tip to this tool's; unknown to the controller
    // The tool hangs on the carriage of tool 0, so its tip moves along while it is idle: mm from tool 0's tip.
    bool mounted = false;
    geom::Vec3 mount;
    // The whole profile for each tool with a section of its own; see of_tool.
    std::map<std::uint32_t, std::shared_ptr<const Profile>> own;
};

// The profile for a tool.  A tool with a section has its own head, extrusion, limits, feeds, travel, offset, kinematics
// and frame; for any other tool it is `profile` itself.
inline const Profile& of_tool(const Profile& profile, std::uint32_t tool) {
    const auto found = profile.own.find(tool);
    return found == profile.own.end() ? profile : *found->second;
}

// Throws Error(usage) if the machine does not allow paths to turn `depth` mm beyond the rims of a part.  `where` names
// the option that asks for it.
void allow_outside(const Profile& profile, double depth, const std::string& where);

// The codes when the tool takes over; "": there are none.
const std::string& change_codes(const Profile& profile, std::uint32_t tool);

// Reads the profile `name_or_path`: a file if that holds a '/' or ends in ".toml".  Else it is NAME.toml, sought in the
// folders of $FILUM_PROFILES (separated by ':'), then in ../share/filum/profiles and ../../share/filum/profiles beside
// the executable.
// `set` changes keys of the file: "feeds.bead=40,nozzle_temp=230"; a key without a section is one of [values].
// Throws Error: usage for an unknown name (with a list of the known ones) or a wrong `set`; io if the file cannot be
// read; bad_input with file, line and key for an unknown key, a wrong type or an impossible value.
Profile load_profile(const std::string& name_or_path, const std::string& set = "");

// The text of a profile, and the name of its file in messages.
struct ProfileText {
    std::string text, file;
};

// Reads a profile from its text.  `file` is the name in messages; a robot's model is sought beside it.  Throws as
// load_profile does.
Profile parse_profile(std::string_view text, const std::string& file, const std::string& set = "");

// Reads a profile from its own text and those of its bases, nearest first.  A key that a text lacks is that of the next
// one.
Profile parse_profile(std::span<const ProfileText> texts, const std::string& set);

// The texts of a profile and of its bases, nearest first.  A profile names its base by the key `base`, as in
// base = "marlin": a name or a file, beside the profile's own file.  Throws as load_profile does, and Error(bad_input)
// for a profile that is its own base.
std::vector<ProfileText> profile_texts(const std::string& name_or_path);

// The names that load_profile knows, sorted.
std::vector<std::string> profile_names();

// The text of a profile alone, found as load_profile does.
std::string profile_text(const std::string& name_or_path);

// Sets the pace of layers, of the profile and of its own tools.
void set_pace(Profile& profile, const std::vector<double>& pace);

// Sets the merging of the profile and of its own tools.
void merge_moves(Profile& profile, const Merging& merging);

} // namespace filum::machine
