// How wide the lanes of beads are everywhere: one function over the medial axis.
#pragma once

#include "polygon/medial_axis.hpp"

#include <algorithm>

namespace filum::rings {

using geom::Vec2;
using polygon::Loops;
using polygon::MedialAxis;

// How the lane coordinate f grows with the depth d on the rays to a node of the axis: d = width * f up to f = full,
// then at `inner` mm per lane up to f = top.
struct Profile {
    double lanes = 0; // f at the node
    double full = 0, inner = 0, top = 0;
    double last = 0; // lane k is laid on rays to here if last >= k - 1
};

// The lane coordinate f of a point: 0 on the outline, k where lane k ends and lane k + 1 begins.
struct Beading {
    MedialAxis axis;
    double width = 0;             // mm
    std::vector<Profile> profile; // per node
    // per piece
    std::vector<char> wall;
    std::vector<double> reach; // of corners: lanes end where so much of one is left on either side, at most a half
    std::vector<double> tip;   // of walls that end in a tip: mm, the radius at which they do, else 0

    // Depth at which the ray to node i has the lane coordinate f, mm.
    [[nodiscard]] double depth(std::uint32_t i, double f) const {
        const Profile& p = profile[i];
        return f <= p.full ? width * f : width * p.full + p.inner * (f - p.full);
    }
    // Where lane k ends on the ray to node i, as a lane coordinate.
    [[nodiscard]] double end(std::uint32_t i, int lane) const {
        const Profile& p = profile[i];
        return std::min({static_cast<double>(lane), p.top, 2 * p.lanes - p.last});
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
