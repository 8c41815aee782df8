// Print time of a toolpath, and the share of each tool.
#pragma once

#include "machine/profile.hpp"
#include "postproc/first_pass.hpp"
#include "toolpath/path.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace filum::metrics::planar {

// The share of one tool. For fibre a stroke is the length between two travels; each is cut once.
struct ToolShare {
    bool fibre = false;
    double laid = 0, travel = 0; // mm; travels of the toolpath to the tool's strokes
    double volume = 0;           // mm3
    double print_seconds = 0;    // including the pauses of its strokes
    double travel_seconds = 0;   // on the way to its strokes, including priming before them
    std::size_t strokes = 0, cuts = 0;
    // strokes of fibre below the profile's least_path: machines omit them, so they take no time
    std::size_t too_short = 0;
};

// Lengths, volumes and strokes of the toolpath; times of the program that postproc would write, by the planner of the
// profile's controller (machine/motion.hpp), from above the first stroke on. Codes of templates and tool changes take
// no time. With rotary axes the whole toolpath is kept in memory.
class Pace {
  public:
    // `as_written`: the toolpath was read from a program, so its moves are those of the program and are not merged
    // again. With rotary axes it stays where it is; otherwise it is measured in the middle of the machine.
    explicit Pace(const machine::Profile& profile, bool as_written = false);
    void add(const toolpath::Span& span);
    // Ends the toolpath and returns its time; only once. Negative if the machine cannot run it: why() is postproc's
    // reason.
    double seconds();
    [[nodiscard]] const std::string& why() const { return why_; }

    // By number, valid after seconds(); their times add up to the total.
    [[nodiscard]] const std::map<std::uint32_t, ToolShare>& tools() const { return tools_; }

  private:
    void count(const toolpath::Span& span);
    [[nodiscard]] postproc::FirstPass first_pass();
    [[nodiscard]] postproc::FirstPass first_pass(postproc::Place place);

    machine::Profile profile_;
    bool as_written_;
    postproc::Surveyor surveyor_;
    std::unique_ptr<postproc::Walker> walker_; // with three axes
    std::vector<toolpath::Span> kept_;         // with more
    std::map<std::uint32_t, ToolShare> tools_;
    std::string why_;
    bool begun_ = false, open_ = false; // a bead has begun; a stroke is open
    std::uint32_t tool_ = 0;
    double fibre_ = 0; // mm: length of the open stroke of fibre
    void close();
};

} // namespace filum::metrics::planar
