// The whole job of `surfpath`: reads surfaces and writes a toolpath.
#pragma once

#include "cli/command.hpp"
#include "surfpath/patches.hpp"
#include "surfpath/surfpath.hpp"

#include <functional>

namespace filum::app::surfpath {

// Plans the path on one sheet, by the algorithm and the spacing of the options. Throws Error.
using Planner = std::function<filum::surfpath::Plan(const surface::Sheet&, const filum::surfpath::Options&)>;

struct Options {
    std::string algorithm = "planned"; // name of the algorithm; "planned": as each surface's frame says
    filum::surfpath::Options plan;
    filum::surfpath::plan::SpanOptions laying;
    std::string trim_list;               // file for the list of places to trim; "": none
    std::string machine;                 // profile that must allow turns outside the part; "": not checked
    std::string follow, reference = "X"; // options of `field`, as the user types them
    double angle_deg = 0;
    std::int64_t ply = 0;
    Planner planner = filum::surfpath::plan_paths;
};

// The options that every method has: spacing and radius of the lines, and the bead.
std::vector<cli::Option> line_options(Options& options);
std::vector<cli::Option> bead_options(Options& options);

// The direction that "X", "Y", "Z" or three numbers such as "1,0,0.5" give.  Throws Error(usage) for other text.
geom::Vec3 reference(const std::string& words);

// The places where a plan on a flange must be trimmed, one line (TSV) each: the text `before`, the number of the
// stroke, counted from `stroke`, the arc length on it (mm), and x, y and z.  `part`: number of triangles of the part,
// as in Flange.
std::string trim_lines(const filum::surfpath::Plan& plan, std::uint32_t part, std::size_t stroke,
                       const std::string& before = "");

// Reads surfaces, plans each, and writes one toolpath.  Warns of given options that no surface's algorithm uses.
// Throws Error as the planners.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::surfpath
