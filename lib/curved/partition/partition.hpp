// Divides a surface into patches on which fibres can follow one direction.
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
    std::vector<std::vector<Vec3>> lines; // projected onto the surface; seams, too
    double mask = 0;   // share of the 99th percentile of the load below which the surface is left out
    double detail = 0; // mm over which directions and borders are smoothed; 0: a 50th of the square root of the area
};

// The patches of the sheet, without names, in the order of decreasing area (ties: by first triangles). Notes, with
// area and place: parts without load, faces below the least area that seams separate from all others, and lines
// farther from the surface than a mean edge. If the sheet is a single patch it is returned unchanged; otherwise its
// isolines and sources are removed with a note.
// Throws Error(usage) if nothing is left, and as pull(), draw() and seams().
std::vector<Sheet> divide(Sheet sheet, const Options& options, int threads, Notes& notes);

// Figures of a patch.
struct PatchFigures {
    double area = 0;      // mm2
    double coherence = 1; // mean, by area and trust, of the cosine of the angle between directions and their mean
    double angle = 0;     // rad: 95th percentile, weighted as above, of that angle
    double bend = 0;      // rad: 95th percentile, by area, of the angle between normals and their mean
    bool pulled = false;  // whether there are directions; otherwise the first two are unknown
};
PatchFigures figures(const Sheet& patch, const PullOptions& options);

// Facts: "patches", "area", and for each patch NAME "patch.NAME.area" in mm2 and, if it is under tension,
// "patch.NAME.coherence", ".angle" and ".bend" (degrees).
Facts facts(const std::vector<Sheet>& patches, const PullOptions& options);

} // namespace filum::partition
