// The lane coordinate: the widths of all lanes as one function over the medial axis.
#pragma once

#include "polygon/medial_axis.hpp"

#include <algorithm>

namespace filum::fill::rings {

using geom::Vec2;
using polygon::Loops;
using polygon::MedialAxis;

// The lane coordinate f as a function of the depth d along the rays to a node of the axis: d = width * f up to f =
// full, then `inner` mm per lane up to f = top.
struct Profile {
    double lanes = 0; // f at the node
    double full = 0, inner = 0, top = 0;
    double last = 0; // lane k reaches the ray if last >= k - 1
};

// The lane coordinate f of every point: 0 on the outline, k where lane k ends and lane k + 1 begins.
struct Beading {
    MedialAxis axis;
    double width = 0;             // mm
    std::vector<Profile> profile; // per node
    // Per piece of the axis:
    std::vector<char> wall;
    std::vector<double> reach; // of corners: half of the share of a lane that remains where it ends, at most 1/2
    std::vector<double> tip;   // of walls that end in a tip: mm, the radius at which lanes end; otherwise 0

    // Depth at which the ray to node i has lane coordinate f, mm.
    [[nodiscard]] double depth(std::uint32_t i, double f) const {
        const Profile& p = profile[i];
        return f <= p.full ? width * f : width * p.full + p.inner * (f - p.full);
    }
    // Lane coordinate at which lane k ends on the ray to node i.
    [[nodiscard]] double end(std::uint32_t i, int lane) const {
        const Profile& p = profile[i];
        return std::min({static_cast<double>(lane), p.top, 2 * p.lanes - p.last});
    }
};

// Widths: least width at which a lane begins.
inline constexpr double kLeastLane = 0.25;

// Widths: least width of a bead; thinner walls get a bead wider than they are.
inline constexpr double kNarrowest = 1.0 / 16;

// The beading of a region with beads of `width` mm wherever no other width is needed. Lanes end in corners and tips
// where the area beyond is at most `least_void` mm2, or where they would be too narrow.
Beading beading(const MedialAxis& axis, double width, double least_void);

} // namespace filum::fill::rings
