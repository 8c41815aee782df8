// Bead lines: the output of `fill` for a region, and the finished toolpath that `link3d` makes of these.
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

// The purpose of a bead, set by `skins`, `supports` or the slicer that wrote the program; determines speed and flow;
// `none` if unknown.
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

// One bead line. A closed one continues from its last point to its first.
struct Curve {
    bool closed = false;
    std::vector<Vec2> points;
    std::vector<double> width; // mm: one value per point, or one value for all points
    // one per segment, the first from point 0 to point 1, or one for all segments; empty: unknown
    std::vector<Feature> feature{};
    // one per segment: the share of the bead's width that lies over air, in percent; empty: not measured
    std::vector<std::uint8_t> over_air{};

    [[nodiscard]] double width_at(std::size_t i) const { return width.size() == 1 ? width[0] : width[i]; }
    [[nodiscard]] Feature feature_at(std::size_t segment) const {
        return feature.empty() ? Feature::none : feature[feature.size() == 1 ? 0 : segment];
    }
    [[nodiscard]] std::uint8_t over_air_at(std::size_t segment) const {
        return over_air.empty() ? std::uint8_t{0} : over_air[segment];
    }

    // The following functions require a width per point and no features.
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

// The bead lines of one region.
struct RegionPaths {
    std::uint32_t region = 0, layer = 0;
    double z = 0, height = 0; // mm
    double area = 0;          // mm2: area of the region
    std::uint32_t stroke = 0;
    Join join = Join::start;
    std::vector<Curve> curves;
    double unplaced = 0; // mm2 of the region that no bead covers
    // Middle lines of walls that a curve follows twice on exactly this line, each time with half of the wall's width.
    // link3d makes the first pass twice as wide in the lower half of the layer and the second one in the upper half:
    // the volume stays the same.
    std::vector<std::vector<Vec2>> stacked;
    std::uint32_t body = 0, tool = 0; // numbers of the body and of the tool that prints it
    std::uint32_t skipped = 0;        // number of lower layers without its body, whose layers are several layers high

    // The number of the layer among those of its body: neighbours above each other differ by 1.
    [[nodiscard]] std::uint32_t own_layer() const { return layer - skipped; }
};

// Fraction of a layer's height: beads with a smaller common part of their heights lie above each other without
// contact.
inline constexpr double kLevel = 0.1;

enum class Role : std::uint8_t {
    bead,      // fill
    lift,      // join to the layer above
    jog,       // join over material
    connector, // join outside the part, removed later
    travel,    // without extrusion: a break
    hairpin,   // fill in a turn that is tighter than the limit for the rest of the path
};
inline constexpr std::array<const char*, 6> kRoleNames{"bead", "lift", "jog", "connector", "travel", "hairpin"};
inline constexpr std::size_t kRoles = kRoleNames.size();

// Retraction of the material on a travel.
enum class Retraction : std::uint8_t {
    by_machine, // as the machine profile states: most retract
    none,       // no retraction: read from a program
    taken,      // retraction: read from a program
};

inline bool extrudes(Role r) { return r != Role::travel; }
inline bool fills(Role r) { return r == Role::bead || r == Role::hairpin; }

// A part of the finished toolpath with one role. It begins where the span before ended; its first point is that place.
// The cross-section of a bead is width * height: the area that the machine extrudes per mm.
struct Span {
    Role role = Role::bead;
    std::uint32_t stroke = 0, layer = 0, region = 0;
    std::vector<Vec3> points;
    std::vector<double> width;  // mm: one value per point, or one for all; empty for a travel
    std::vector<double> height; // mm: one value per point, or one for all; empty for a travel
    // Unit, per point: from the tip to the tool, on a curved surface its normal; empty: (0, 0, 1), from above. A
    // travel with normals is executed exactly; one without may be raised above the printed material.
    std::vector<Vec3> normals{};
    std::uint32_t tool = 0;                         // number of the machine's tool; for a travel, that of the next bead
    Retraction retraction = Retraction::by_machine; // of a travel
    Feature feature = Feature::none;                // of an extruding span
    std::uint32_t body = 0;                         // number of the body that it belongs to
    std::uint8_t over_air = 0;                      // of a wall: share of its width over air, in percent

    [[nodiscard]] double width_at(std::size_t i) const { return width.size() == 1 ? width[0] : width[i]; }
    [[nodiscard]] double height_at(std::size_t i) const { return height.size() == 1 ? height[0] : height[i]; }
};

// Volume of segment i -> i + 1, mm3: length times the mean of the sections at its ends. 0 for vertical segments of
// joins, and for travels.
inline double volume(const Span& s, std::size_t i) {
    if (!extrudes(s.role)) return 0;
    if (!fills(s.role) && s.points[i].xy() == s.points[i + 1].xy()) return 0;
    const double a = s.width_at(i) * s.height_at(i), b = s.width_at(i + 1) * s.height_at(i + 1);
    return geom::distance(s.points[i], s.points[i + 1]) * (a + b) / 2;
}

} // namespace filum::toolpath
