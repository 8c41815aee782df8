// How long a machine takes for a toolpath, and what each of its tools does.
#pragma once

#include "machine/motion.hpp"
#include "machine/profile.hpp"
#include "toolpath/path.hpp"

#include <map>
#include <set>
#include <vector>

namespace filum::metrics::planar {

// What one tool does.  Of fibre a stroke is whatever is laid between two travels; each is cut once.
struct ToolShare {
    bool fibre = false;
    double laid = 0, travel = 0; // mm; of travels, as the toolpath has them, those that lead to its strokes
    double volume = 0;           // mm3
    double print_seconds = 0;    // with the pauses of its strokes
    double travel_seconds = 0;   // on the way to its strokes, with what is pushed or given before they begin
    std::size_t strokes = 0, cuts = 0;
    std::size_t too_short = 0; // strokes of fibre below the profile's least_path: no machine lays them
};

// Time of the moves from the first extruding one to the last, by trapezoidal speed profiles with look-ahead
// (machine/motion.hpp). A travel of at least travel.min_length takes back material, rises above all printed so far,
// moves, comes down and primes; one that is shorter only moves, as does a jump between spans.  One from or to fibre, or
// to another tool, always rises.  Fibre is laid as machine::stretches says; codes of a tool change take no time.
class Pace {
  public:
    explicit Pace(const machine::Profile& profile) : profile_(profile), clock_(profile.motion) {}
    void add(const toolpath::Span& span);
    double seconds(); // so far; ends the stroke

    // By number, after seconds(); its parts add up to the whole.
    [[nodiscard]] const std::map<std::uint32_t, ToolShare>& tools() const { return tools_; }

  private:
    void travel(const toolpath::Span& span);
    void extrude(const toolpath::Span& span);
    void begin(const toolpath::Span& span);
    void lay_fibre();
    void go(geom::Vec3 to, double feed);
    void charge();
    [[nodiscard]] bool lays_fibre() const { return profile_.fibre.lays(tool_); }

    machine::Profile profile_;
    machine::Clock clock_;
    geom::Vec3 at_;  // of the nozzle
    double top_ = 0; // highest point printed so far
    bool begun_ = false, open_ = false, risen_ = false;
    std::uint32_t tool_ = 0;
    std::set<std::uint32_t> retracted_; // tools
    std::vector<toolpath::Span> fibre_; // of the stroke that is still open
    std::map<std::uint32_t, ToolShare> tools_;
    double charged_ = 0; // s of the clock
};

} // namespace filum::metrics::planar
