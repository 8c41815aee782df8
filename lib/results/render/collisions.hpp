// Pictures of collisions: the head at a place where it touches something, and all other places.
#pragma once

#include "machine/head.hpp"
#include "render/perspective.hpp"
#include "render/view.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace filum::render {

// One line of the list that collide --places writes.
struct Meeting {
    std::string with;         // part of the head
    std::uint64_t source = 0; // index of a toolpath point, or line of a program
    double clearance = 0;     // mm
    geom::Vec3 tip, axis{0, 0, 1};
};

struct Meetings {
    bool points = true; // whether sources are points of the toolpath; else they are lines of a program
    std::vector<Meeting> all;
};

// Reads the list in `text`. Throws Error(bad_input) naming `name` and the line, and also if the list holds no place.
Meetings read_meetings(std::string_view text, const std::string& name);

// Draws two pictures side by side: the whole part, and a close-up.
// The head stands at the place where it penetrates deepest (ties: the first place), marked red. Other places are orange
// dots, at most 500. If the list counts points, only beads printed before that place are drawn.
// The nozzle is solid; carriage and gantry are drawn as bars. The carriage is a round column if the tool leans. Parts
// are the meshes of the scene.
// If `from` of the view is zero, the direction is chosen among 16 sides and two heights. It is the one that hides the
// least of the nozzle and of the rim of the carriage (ties: the first). Same bytes for any `threads`.
void draw_collisions(Canvas& page, Scene scene, const Meetings& places, const machine::Head& head, ColourBy by,
                     const View& view, int threads);

} // namespace filum::render
