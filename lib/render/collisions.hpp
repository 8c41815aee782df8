// Where the head meets something, as a picture: what stands there, the head in its place, the place itself.
#pragma once

#include "machine/head.hpp"
#include "render/perspective.hpp"
#include "render/view.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace filum::render {

// A line of the list that collide --places writes.
struct Meeting {
    std::string with;         // piece of the head
    std::uint64_t source = 0; // point of the toolpath, or line of a program
    double clearance = 0;     // mm
    geom::Vec3 tip, axis{0, 0, 1};
};

struct Meetings {
    bool points = true; // sources are points of the toolpath; else lines of a program
    std::vector<Meeting> all;
};

// The list in `text`.  Throws Error(bad_input) naming `name` and the line; also if it holds no place.
Meetings read_meetings(std::string_view text, const std::string& name);

// Two pictures side by side: all of it, and close by.  The head stands where it comes in deepest (ties: the first
// place), which is red; all other places are orange dots, at most 500 of them.  Of the beads those are drawn that are
// there at that time, if the list counts points.  The nozzle is solid, the carriage and the gantry are bars, the
// carriage a round column where the tool leans; parts are the scene's meshes.  Seen from where the least of the nozzle
// and of the carriage's rim is hidden among 16 sides and two heights (ties: the first); from `from` if that is not
// zero.  Same bytes for any `threads`.
Image draw_collisions(Scene scene, const Meetings& places, const machine::Head& head, By by, const View& view,
                      int threads);

} // namespace filum::render
