// The print head as convex pieces, and its distance from polygons.
#pragma once

#include "geom/vec.hpp"
#include "machine/heads.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <span>

namespace filum::collision {

using geom::Vec3;

enum class HeadPiece : std::uint8_t { nozzle, carriage, gantry };
inline constexpr std::array<const char*, 3> kPieceNames{"nozzle", "carriage", "gantry"};

using machine::Heads;

// Position and orientation of the tool in the part's frame.
struct ToolFrame {
    Vec3 tip;           // mm
    Vec3 axis{0, 0, 1}; // unit: up the tool
    Vec3 side{1, 0, 0}; // unit, perpendicular to the axis: the carriage's x; zero if its rotation is unknown
};

// The frame of a head: its tip, and unit vectors in the part's frame, z up the tool.
struct Frame {
    Vec3 tip, x, y, z;
    Vec3 operator()(const Vec3& p) const { // in coordinates of this frame
        const Vec3 d = p - tip;
        return {dot(d, x), dot(d, y), dot(d, z)};
    }
};

// Points that stand for their convex hull: the corners of a polygon, or of one that moved.
struct Corners {
    std::array<Vec3, 24> point;
    std::size_t count = 0;
    void add(const Vec3& p) { point[count++] = p; }
    [[nodiscard]] std::span<const Vec3> all() const { return {point.data(), count}; }
};

// The head of machine::Head in its own frame: the tip at the origin, z up the tool, x along the carriage's x. Nozzle:
// the convex hull of the flat and the wide end of its cone, continued upwards. Carriage: a box from cone_height
// upwards, or the cylinder around it if its rotation is unknown. Gantry: everything above its height. All end 100 m
// above the tip, as in the planar chain's model (sequence/outline.hpp).
class Shape {
  public:
    explicit Shape(const machine::Head& head);

    struct NearestPiece {
        double distance = 0; // mm
        HeadPiece piece = HeadPiece::nozzle;
    };
    // Distance from the hull of `corners` (in the head's frame) to the head; 0 if they intersect, `cutoff` if it is at
    // least that. Relative accuracy 1e-8. Ties: the lower piece.
    [[nodiscard]] NearestPiece nearest(std::span<const Vec3> corners, bool round, double cutoff) const;

    // A lower bound on the distance from the head to a point `z` above the tip and `radius` from the axis.
    [[nodiscard]] double at_least(double radius, double z) const;

    [[nodiscard]] bool none() const { return none_; }

  private:
    bool none_ = false;
    double flat_ = 0, wide_ = 0, height_ = 0; // mm: radii of the nozzle's ends, height of the upper one
    double half_x_ = 0, half_y_ = 0, half_diagonal_ = 0, gantry_ = 0;
    double out_ = 1, down_ = 0; // components of the unit normal of the nozzle's side
};

// The shapes of all heads.
class Shapes {
  public:
    explicit Shapes(const Heads& heads) : common_(heads.common) {
        for (const auto& [tool, head] : heads.own) own_.emplace(tool, Shape(head));
    }
    [[nodiscard]] const Shape& of(std::uint32_t tool) const {
        const auto found = own_.find(tool);
        return found == own_.end() ? common_ : found->second;
    }

  private:
    Shape common_;
    std::map<std::uint32_t, Shape> own_;
};

} // namespace filum::collision
