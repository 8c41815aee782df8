// A surface divided into patches in which fibres can go one way.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "partition/cells.hpp"
#include "partition/merge.hpp"
#include "partition/seams.hpp"

namespace filum::partition {

struct Options {
    PullOptions pull;
    Limits limits;                        // least_area 0: a hundredth of the surface
    SeamOptions seams;                    // its least_area is that of the limits
    std::vector<std::vector<Vec3>> lines; // drawn onto the surface: seams, too
    double mask = 0;   // share of the load, of what 99 % of the surface stay below, under which nothing is wanted
    double detail = 0; // mm: what is smaller, of directions and borders, is smoothed; 0: a 50th of the area's root
};

// The patches of the sheet, without names, the greatest first (of equals the one with the first triangle).  What is not
// in any of them is noted, by area and place: parts without load, and faces smaller than the least area that seams keep
// from all others, and lines farther from it than a mean edge.  Where the sheet is one patch it is handed back as it
// is, else its lines and sources go with a note. Throws Error: usage if nothing is left, and as pull(), draw() and
// seams().
std::vector<Sheet> divide(Sheet sheet, const Options& options, int threads, Notes& notes);

// What a patch is like.
struct Figures {
    double area = 0;      // mm2
    double coherence = 1; // mean, by area and trust, of the cosine of the angle between directions and their mean
    double angle = 0;     // rad: nineteen twentieths of the directions, so weighted, are nearer to their mean
    double bend = 0;      // rad: nineteen twentieths of the normals, by area, are nearer to their mean
    bool pulled = false;  // else there are no directions, and nothing is known of angles
};
Figures figures(const Sheet& patch, const PullOptions& options);

// "patches", "area", and of each patch NAME what figures() says: "patch.NAME.area" in mm2, and if it is pulled
// "patch.NAME.coherence", .angle and .bend, these in degrees.
Facts facts(const std::vector<Sheet>& patches, const PullOptions& options);

} // namespace filum::partition
