// What a program will hold, found before its first line is written: the box, the totals, and whatever breaks a limit.
#pragma once

#include "machine/motion.hpp"
#include "machine/pauses.hpp"
#include "machine/profile.hpp"
#include "postproc/footprint.hpp"
#include "postproc/labels.hpp"
#include "postproc/options.hpp"
#include "postproc/timeline.hpp"
#include "postproc/walk.hpp"

#include <array>
#include <map>

namespace filum::postproc {

// The point that lies farthest out in one direction, and on which layer.
struct Extreme {
    double value = 0;
    Vec3 at;
    std::uint32_t layer = 0;
};

// What one tool does.
struct ToolTotals {
    bool fibre = false;
    double path_len = 0, travel_len = 0;          // mm
    double volume = 0;                            // mm3 of bead, as the toolpath says
    double print_seconds = 0, travel_seconds = 0; // with the pauses of either
    double fibre_len = 0;                         // mm of fibre that is used: laid, and pushed into the air
    std::uint64_t strokes = 0, cuts = 0;
};

// Fibre strokes that are too short to be laid.
struct Omitted {
    std::uint64_t count = 0;
    double length = 0;                // mm, of all
    double shortest = 0, longest = 0; // mm
    Vec3 at;                          // where the shortest begins, as the toolpath says
    std::uint32_t layer = 0;          // of that one
};

// Where the program waits for its user.
struct Waits {
    std::uint64_t count = 0;      // pauses there are
    std::uint64_t within = 0;     // of these within a stroke
    std::uint64_t late = 0;       // layers that come behind a pause that should wait for them
    std::uint32_t late_layer = 0; // the first of them
};

struct FirstPass {
    std::array<Extreme, 3> low, high;              // x, y, z of the linear axes over every point that the nozzle visits
    std::array<double, 3> part_low{}, part_high{}; // the same over extruding moves only
    Vec3 part_size{};                              // mm: of the part as it is printed, see toolpath::Extent
    Vec3 start;                                    // of the first stroke
    double path_len = 0, travel_len = 0;           // mm
    double volume = 0;                             // mm3 of bead but for fibre, as the toolpath says
    double seconds = 0;
    std::uint64_t moves = 0, strokes = 0;
    std::uint64_t laying = 0;                        // moves that lay material
    std::uint32_t layers = 0;                        // highest index + 1
    Efforts efforts;                                 // of rotary axes
    std::string placed;                              // how the numbers' frame lies to the toolpath's; may be empty
    std::array<double, toolpath::kRoles> role_len{}; // mm, by Role
    std::map<std::uint32_t, ToolTotals> tools;
    Omitted omitted;
    machine::Pauses pauses; // as asked for
    Waits waits;
    std::vector<LayerValue> by_layer; // likewise
    std::vector<Labelled> parts;      // on the bed, if they are several
    Timeline timeline;
    // Only of machines with a slicer's profile:
    Footprint first_layer, footprint; // of its first layer, and of all
    std::uint32_t first_tool = 0;     // that extrudes
    std::vector<double> layers_begin; // nominal seconds, in the order of the program; a layer may come several times
    // How long the layer takes that is the n-th to begin.
    [[nodiscard]] double layer_seconds(std::size_t n) const;
};

// Reads steps as they come.  Throws Error(failure) with the place for a bead whose cross-section (flow included) is
// above the limit of its tool, or whose width is not of its nozzle; of fibre, which neither is about, none is.
class Surveyor {
  public:
    explicit Surveyor(const machine::Profile& profile, machine::Pauses pauses = {});
    void add(std::span<const Step> steps);
    // Throws Error(failure) for fibre strokes that are too short, unless the profile omits them, or for more fibre than
    // there is on the spool; Error(bad_input) if nothing is extruded.
    FirstPass end();

  private:
    void move(const Step& step);
    void spend_move(const Step& step, const Vec3& way);
    void visit_arc(const Step& step);
    void spend();
    void reach_layer(const Step& step);
    void omit(const Step& step);
    void check_fibre() const;
    void visit(const Step& step, bool extruding);
    void check_section(const Step& step, double length) const;
    const machine::Profile* profile_;
    machine::Clock clock_;
    FirstPass first_pass_;
    Vec3 at_;
    double tilt_ = 0, turn_ = 0; // rad
    double spent_ = 0;           // s of the clock that tools were charged with
    Nominal nominal_;
    std::uint32_t tool_ = 0;
    bool placed_ = false, open_ = false;
};

// Material of all tools but fibre's, as it leaves them: mm3, and extruder units of those that count.
struct Used {
    double volume = 0, units = 0;
};
Used used(const machine::Profile& profile, const FirstPass& first_pass);

// How far to move the toolpath in x and y: a whole number of um.
Vec2 placement(const FirstPass& first_pass, const machine::Bed& bed, Place place);

// Throws Error(failure): naming layer and place if anything visited, moved by `shift`, lies outside the bed; or if
// there is more material than the extruder's numbers can count.
void check_limits(const FirstPass& first_pass, const machine::Profile& profile, Vec2 shift);

// A line near an edge of the bed where a nozzle may be primed, 60 mm or as long as the bed: the first of front, left,
// back and right that stays 5 mm off the box [low, high] of the part.  Where none does, no line: the bed's corner.
geom::Segment purge_line(const machine::Bed& bed, Vec2 low, Vec2 high);

// What templates may name, for a program placed by `shift`; {layer}, {z}, {height} are those of the first layer.
std::map<std::string, double> placeholders(const FirstPass& first_pass, const machine::Profile& profile, Vec2 shift);

} // namespace filum::postproc
