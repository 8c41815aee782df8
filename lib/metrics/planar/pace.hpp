// How long a machine takes for a toolpath, and what each of its tools does.
#pragma once

#include "machine/profile.hpp"
#include "postproc/first_pass.hpp"
#include "toolpath/path.hpp"

#include <map>
#include <memory>
#include <string>
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
    std::size_t too_short = 0; // strokes of fibre below the profile's least_path: no machine lays them, nor takes time
};

// Lengths, volumes and strokes as the toolpath has them; times of the program that postproc would write of it, by the
// planner of the profile's controller (machine/motion.hpp), from above the first stroke on.  Codes of templates and of
// a tool change take no time.  With rotary axes the toolpath is kept until it ends.
class Pace {
  public:
    explicit Pace(const machine::Profile& profile);
    void add(const toolpath::Span& span);
    // Ends the toolpath; only once.  Below 0 where the machine cannot do it: `why` then says what postproc would.
    double seconds();
    [[nodiscard]] const std::string& why() const { return why_; }

    // By number, after seconds(); their times add up to the whole.
    [[nodiscard]] const std::map<std::uint32_t, ToolShare>& tools() const { return tools_; }

  private:
    void count(const toolpath::Span& span);
    [[nodiscard]] postproc::FirstPass first_pass();

    machine::Profile profile_;
    postproc::Surveyor surveyor_;
    std::unique_ptr<postproc::Walker> walker_; // with three axes
    std::vector<toolpath::Span> kept_;         // with more
    std::map<std::uint32_t, ToolShare> tools_;
    std::string why_;
    bool begun_ = false, open_ = false; // a bead; a stroke
    std::uint32_t tool_ = 0;
    double fibre_ = 0; // mm of the stroke of fibre that is open
    void close();
};

} // namespace filum::metrics::planar
