// How wide the lanes of beads are everywhere: one function over the medial axis.
#pragma once

#include "polygon/medial_axis.hpp"

#include <algorithm>

namespace filum::rings {

using geom::Vec2;
using polygon::Loops;
using polygon::MedialAxis;

// The lane coordinate f of a point: 0 on the outline, k where lane k ends and lane k + 1 begins.  On a ray it grows
// with the depth d by the profile of the axis node that the ray leads to: d = width * f up to f = full, then at `inner`
// mm per lane up to f = top.
struct Beading {
    MedialAxis axis;
    double width = 0; // mm
    // per node
    std::vector<double> lanes; // f at the node
    std::vector<double> full, inner, top;
    std::vector<double> last; // lane k is laid on rays to here if last >= k - 1
    // per piece
    std::vector<char> wall;
    std::vector<double> reach; // of corners: lanes end where so much of one is left on either side, at most a half
    std::vector<double> tip;   // of walls that end in a tip: mm, the radius at which they do, else 0

    // Depth at which the ray to node i has the lane coordinate f, mm.
    [[nodiscard]] double depth(std::uint32_t i, double f) const {
        return f <= full[i] ? width * f : width * full[i] + inner[i] * (f - full[i]);
    }
    // And back: the lane coordinate at a depth.
    [[nodiscard]] double lane_at(std::uint32_t i, double depth) const {
        const double rest = depth - width * full[i];
        return rest <= 0 ? depth / width : full[i] + rest / inner[i];
    }
    [[nodiscard]] bool laid(std::uint32_t i, int lane) const { return last[i] >= lane - 1 - 1e-9; }
    // Where lane k ends on the ray to node i, as a lane coordinate.
    [[nodiscard]] double end(std::uint32_t i, int lane) const {
        return std::min({static_cast<double>(lane), top[i], 2 * lanes[i] - last[i]});
    }
};

// Widths: no lane begins narrower.
inline constexpr double kLeastLane = 0.25;

// Widths: thinner walls are laid with a bead that is wider than they are.
inline constexpr double kNarrowest = 1.0 / 16;

// The beading of a region with beads `width` mm wide where nothing asks for another width.  Lanes end in corners and
// tips where the rest that no bead reaches is at most `least_void` mm2, or they would be too narrow.
Beading beading(const MedialAxis& axis, double width, double least_void);

} // namespace filum::rings
