// The whole job of `surfpath`: surfaces in, a toolpath out.
#pragma once

#include "baselines/kipping2022/kipping2022.hpp"
#include "cli/command.hpp"
#include "surfpath/patches.hpp"
#include "surfpath/surfpath.hpp"

namespace filum::app::surfpath {

struct Options {
    std::string algorithm = "planned"; // by what the surfaces carry, or a name
    filum::surfpath::Options plan;
    filum::surfpath::plan::SpanOptions laying;
    std::string trim_list;               // file of where to trim; "": none
    std::string machine;                 // profile that must allow turns outside; "": not asked
    std::string follow, reference = "X"; // of field, as users have them
    double angle_deg = 0;
    std::int64_t ply = 0;
    std::vector<double>
        plane; // normal and distance, mm, beside which rows of the paper lie; empty: that of the sources
    baselines::kipping2022::Options paper;
};

// "X", "Y", "Z" or three numbers, "1,0,0.5", as a direction.  Throws Error(usage).
geom::Vec3 reference(const std::string& words);

// Where a plan on a flange is to be trimmed: a line of stroke, from `stroke` on, mm along it, x, y and z per place,
// each behind `before`.
std::string trim_lines(const filum::surfpath::Plan& plan, std::uint32_t part, std::size_t stroke,
                       const std::string& before = "");

// Reads surfaces, plans each, and writes one toolpath.  Warns of given options that no surface's algorithm uses.
// Throws Error as the planners do.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::surfpath
