// Bead lines: what `fill` makes of a region, and the finished toolpath that `link3d` makes of those.
#pragma once

#include "base/join.hpp"
#include "geom/vec.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace filum::toolpath {

using geom::Vec2;
using geom::Vec3;

// What a bead is for, as `skins` and `supports` or the program of a slicer say it: speeds and flows depend on it;
// `none` where nobody does.
enum class Feature : std::uint8_t {
    none,
    outer_wall,
    wall,
    infill, // sparse
    solid,
    top,
    bottom,
    bridge,
    gap,
    ironing,
    support,
    interface,
    skirt, // or brim, or raft
    tower, // where tools are primed
};
inline constexpr std::array<const char*, 14> kFeatureNames{"none",    "outer-wall", "wall",   "infill", "solid",
                                                           "top",     "bottom",     "bridge", "gap",    "ironing",
                                                           "support", "interface",  "skirt",  "tower"};
inline constexpr std::size_t kFeatures = kFeatureNames.size();

// One bead line.  A closed one runs on from its last point to its first.
struct Curve {
    bool closed = false;
    std::vector<Vec2> points;
    std::vector<double> width;      // mm, per point, or one for all
    std::vector<Feature> feature{}; // per segment, the first from point 0 to point 1; one for all; none: not told

    [[nodiscard]] double width_at(std::size_t i) const { return width.size() == 1 ? width[0] : width[i]; }
    [[nodiscard]] Feature feature_at(std::size_t segment) const {
        return feature.empty() ? Feature::none : feature[feature.size() == 1 ? 0 : segment];
    }

    // With a width per point and no features:
    void add(Vec2 p, double w) {
        points.push_back(p);
        width.push_back(w);
    }
    void drop_last() {
        points.pop_back();
        width.pop_back();
    }
    void reverse() {
        std::reverse(points.begin(), points.end());
        std::reverse(width.begin(), width.end());
    }
};

// What fills one region.
struct RegionPaths {
    std::uint32_t region = 0, layer = 0;
    double z = 0, height = 0; // mm
    double area = 0;          // mm2, of the region
    std::uint32_t stroke = 0;
    Join join = Join::start;
    std::vector<Curve> curves;
    double unplaced = 0; // mm2 of the region that no bead reaches
    // Middle lines of walls that a curve passes twice on this very line, each time half as wide as the wall.  The first
    // pass is to be laid twice as wide in the lower half of the layer, the second one in the upper half: the same
    // volume.
    std::vector<std::vector<Vec2>> stacked;
};

// Of a layer's height: beads that share no more of it lie over each other and do not meet.
inline constexpr double kLevel = 0.1;

enum class Role : std::uint8_t {
    bead,      // fill
    lift,      // join to the layer above
    jog,       // join over material
    connector, // join outside the part, to be removed
    travel,    // not extruding: a break
    hairpin,   // fill in a turn that is declared to be tighter than what the path keeps to elsewhere
};
inline constexpr std::array<const char*, 6> kRoleNames{"bead", "lift", "jog", "connector", "travel", "hairpin"};
inline constexpr std::size_t kRoles = kRoleNames.size();

// What happens to the material on a travel.
enum class Retraction : std::uint8_t {
    by_machine, // what the profile of the machine says: most take some back
    none,       // it is not taken back: known of a program that was read
    taken,      // it is
};

inline bool extrudes(Role r) { return r != Role::travel; }
inline bool fills(Role r) { return r == Role::bead || r == Role::hairpin; }

// A stretch of the finished toolpath.  It begins where the span before ended; its first point is that place.
// The cross-section of a bead is width * height: the area that the machine will extrude per mm.
struct Span {
    Role role = Role::bead;
    std::uint32_t stroke = 0, layer = 0, region = 0;
    std::vector<Vec3> points;
    std::vector<double> width;  // mm, per point, or one for all; empty for a travel
    std::vector<double> height; // likewise
    // Per point, unit: where the tool comes from, on a curved surface its normal; none: from above, (0, 0, 1).
    // A travel with normals is to be followed as it is; one without may be raised above what is printed.
    std::vector<Vec3> normals{};
    std::uint32_t tool = 0; // of the machine, by number; of a travel, the one of the bead that follows
    Retraction retraction = Retraction::by_machine; // of a travel
    Feature feature = Feature::none;                // of what extrudes

    [[nodiscard]] double width_at(std::size_t i) const { return width.size() == 1 ? width[0] : width[i]; }
    [[nodiscard]] double height_at(std::size_t i) const { return height.size() == 1 ? height[0] : height[i]; }
};

// mm3 deposited by the segment i -> i + 1: length times the mean of the end sections.  Joins lay nothing where they go
// straight up or down, and travels lay nothing at all.
inline double volume(const Span& s, std::size_t i) {
    if (!extrudes(s.role)) return 0;
    if (!fills(s.role) && s.points[i].xy() == s.points[i + 1].xy()) return 0;
    const double a = s.width_at(i) * s.height_at(i), b = s.width_at(i + 1) * s.height_at(i + 1);
    return geom::distance(s.points[i], s.points[i + 1]) * (a + b) / 2;
}

} // namespace filum::toolpath
