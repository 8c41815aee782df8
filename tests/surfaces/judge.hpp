// What a path on a surface is, found out without asking those who laid it.
#pragma once

#include "base/note.hpp"
#include "surface/sources.hpp"
#include "toolpath/path.hpp"

#include <string>
#include <vector>

namespace filum::trials {

using geom::Vec3;
using surface::Surface;
using toolpath::Span;

struct Asked {
    double spacing = 1, least_radius = 2.4; // mm
    bool on_surface = true;                 // whether the path should keep to it
    bool rings = false;                     // whether it consists of rings, which must not lie on each other,
    surface::Sources from{};                // and where from
};

struct Judged {
    double area = 0, length = 0;               // mm2, mm
    double covered = 0, bare = 0, overlap = 0; // shares of the area; bare: farther than a spacing from any line
    double off = 0;                            // mm: the farthest that the path is from the surface
    double jump = 0;                           // mm: the farthest that a span begins from where one ended
    double tight = 0, unmarked = 0;            // mm of turns within less than the least radius; of these not marked
    double least_radius = 0;                   // mm
    double doubled = 0;                        // mm of path that lies on other path, but where rings meet on a ridge
    std::size_t crossings = 0;                 //
    Vec3 unmarked_at, doubled_at, off_at;      //
};

Judged judge(const Surface& s, const std::vector<Span>& spans, const Asked& asked);

// What is wrong with it, or with its notes; one line each.
std::vector<std::string> faults(const Surface& s, const std::vector<Span>& spans, const Judged& j, const Notes& notes,
                                const Asked& asked);

} // namespace filum::trials
