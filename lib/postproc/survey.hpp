// What a program will hold, found before its first line is written: the box, the totals, and whatever breaks a limit.
#pragma once

#include "machine/motion.hpp"
#include "machine/profile.hpp"
#include "postproc/walk.hpp"

#include <array>

namespace filum::postproc {

// The point that lies farthest out in one direction, and on which layer.
struct Extreme {
    double value = 0;
    Vec3 at;
    std::uint32_t layer = 0;
};

struct Survey {
    std::array<Extreme, 3> low, high;              // x, y, z of the linear axes over every point that the nozzle visits
    std::array<double, 3> part_low{}, part_high{}; // the same over extruding moves only
    Vec3 start;                                    // of the first stroke
    double path_len = 0, travel_len = 0;           // mm
    double volume = 0;                             // mm3 of bead, as the toolpath says
    double seconds = 0;
    std::uint64_t moves = 0, strokes = 0;
    std::uint32_t layers = 0;                        // highest index + 1
    Efforts efforts;                                 // of rotary axes
    std::string placed;                              // how the numbers' frame lies to the toolpath's; may be empty
    std::array<double, toolpath::kRoles> role_len{}; // mm, by Role
};

// Reads steps as they come.  Throws Error(failure) with the place for a bead whose cross-section (flow included) is
// above the profile's limit.
class Surveyor {
  public:
    explicit Surveyor(const machine::Profile& profile);
    void add(std::span<const Step> steps);
    Survey end(); // throws Error(bad_input) if nothing is extruded

  private:
    void visit(const Step& step, bool extruding);
    void check_section(const Step& step, double length) const;
    const machine::Profile* profile_;
    machine::Clock clock_;
    Survey survey_;
    Vec3 at_;
    bool placed_ = false;
};

enum class Place : std::uint8_t {
    center, // the middle of the visited box goes to the middle of the bed
    as_is,  // coordinates stay
};

Place parse_place(const std::string& text); // "center" or "as-is"

// How far to move the toolpath in x and y: a whole number of um.
Vec2 placement(const Survey& survey, const machine::Bed& bed, Place place);

// Throws Error(failure): naming layer and place if anything visited, moved by `shift`, lies outside the bed; or if
// there is more material than the extruder's numbers can count.
void check_limits(const Survey& survey, const machine::Profile& profile, Vec2 shift);

// What templates may name, for a program placed by `shift`; {layer}, {z}, {height} are those of the first layer.
std::map<std::string, double> placeholders(const Survey& survey, const machine::Profile& profile, Vec2 shift);

} // namespace filum::postproc
