// The first pass: it collects the contents of a program before its first line is written (box, totals, pauses), and
// checks the machine's limits.
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

// The farthest point in one direction, and its layer.
struct Extreme {
    double value = 0;
    Vec3 at;
    std::uint32_t layer = 0;
};

// The totals of one tool.
struct ToolTotals {
    bool fibre = false;
    double path_len = 0, travel_len = 0;          // mm
    double volume = 0;                            // mm3 of bead in the toolpath, without the profile's flow factor
    double print_seconds = 0, travel_seconds = 0; // both with their pauses
    double fibre_len = 0;                         // mm of fibre used: laid, and pushed into the air
    std::uint64_t strokes = 0, cuts = 0;
};

// Fibre strokes that are too short to lay.
struct OmittedMoves {
    std::uint64_t count = 0;
    double length = 0;                // mm, sum
    double shortest = 0, longest = 0; // mm
    Vec3 at;                          // start of the shortest, in the toolpath's frame
    std::uint32_t layer = 0;          // of the shortest
};

// The places where the program waits for its user.
struct PauseTotals {
    std::uint64_t count = 0;      // pauses
    std::uint64_t within = 0;     // pauses within a stroke
    std::uint64_t late = 0;       // layers printed after a pause that should come after them
    std::uint32_t late_layer = 0; // the first late layer
};

struct FirstPass {
    std::array<Extreme, 3> low, high;              // x, y, z of the linear axes over all points visited
    std::array<double, 3> part_low{}, part_high{}; // the same over extruding moves only
    Vec3 part_size{};                              // mm: of the printed part, see toolpath::Extent
    Vec3 start;                                    // of the first stroke
    double path_len = 0, travel_len = 0;           // mm
    double volume = 0;                             // mm3 of bead in the toolpath, without fibre
    double seconds = 0;
    std::uint64_t moves = 0, strokes = 0;
    std::uint64_t laying = 0;                        // moves that extrude
    std::uint32_t layers = 0;                        // highest index + 1
    Efforts efforts;                                 // of rotary axes
    std::string placed;                              // position of the program's frame in the toolpath's; may be empty
    std::array<double, toolpath::kRoles> role_len{}; // mm, by Role
    std::map<std::uint32_t, ToolTotals> tools;
    OmittedMoves omitted;
    machine::Pauses pauses; // as requested
    PauseTotals waits;
    std::vector<LayerValue> by_layer; // values by layer, as requested
    std::vector<LabelledPart> parts;  // on the bed, if there are several
    Timeline timeline;
    // Only for machines with a slicer's profile:
    Footprint first_layer, footprint; // of the first layer, and of all layers
    std::uint32_t first_tool = 0;     // the first tool that extrudes
    std::vector<double> layers_begin; // nominal seconds, in the order of the program; a layer may come several times
    // Duration in s of the layer that begins as the n-th, counted from 0; 0 if there are fewer.
    [[nodiscard]] double layer_seconds(std::size_t n) const;
};

// Reads the steps of a program in their order.  Throws Error(failure) with the place for a bead whose cross-section
// (flow included) exceeds the limit of its tool, or whose width its nozzle cannot print.  Fibre has neither limit.
class Surveyor {
  public:
    explicit Surveyor(const machine::Profile& profile, machine::Pauses pauses = {});
    void add(std::span<const Step> steps);
    // Throws Error(failure) for fibre strokes that are too short, unless the profile omits them, and for more fibre
    // than the spool holds.  Throws Error(bad_input) if nothing is extruded.
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
    double spent_ = 0;           // s of the clock that are charged to tools so far
    Nominal nominal_;
    std::uint32_t tool_ = 0;
    bool placed_ = false, open_ = false;
};

// Material of all tools except the fibre's, flow factor included: mm3, and extruder units of the tools that count them.
struct MaterialUse {
    double volume = 0, units = 0;
};
MaterialUse used(const machine::Profile& profile, const FirstPass& first_pass);

// The shift of the toolpath in x and y, mm, rounded to whole um; 0 for Place::as_is.
Vec2 placement(const FirstPass& first_pass, const machine::Bed& bed, Place place);

// Throws Error(failure) with layer and place if a visited point, moved by `shift`, lies outside the bed.  Throws
// Error(failure), too, if there is more material than the extruder's numbers can count.
void check_limits(const FirstPass& first_pass, const machine::Profile& profile, Vec2 shift);

// A line near an edge of the bed where a nozzle may be primed, 60 mm long or as long as the bed allows.  It is the
// first of front, left, back and right that stays 5 mm away from the part's box [low, high].  If no edge is free, the
// line has no length and lies in the bed's corner.
geom::Segment purge_line(const machine::Bed& bed, Vec2 low, Vec2 high);

// The values that templates may name, for a program placed by `shift`.  {layer} is that of the first layer; {z} and
// {height} are the z where the first stroke starts.
std::map<std::string, double> placeholders(const FirstPass& first_pass, const machine::Profile& profile, Vec2 shift);

} // namespace filum::postproc
