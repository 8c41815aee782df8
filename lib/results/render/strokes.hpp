// Lines drawn on a surface, which can be found from the points that they cover.
#pragma once

#include "render/colour.hpp"

#include "geom/vec.hpp"

#include <cstdint>
#include <vector>

namespace filum::render {

struct Stroke {
    geom::Vec3 a, b;               // mm
    geom::Vec3 normal;             // unit normal of the side of the surface that it lies on; 0: any side
    double half_a = 0, half_b = 0; // mm, half its width at both ends
    double reach = 0;              // mm, largest distance from the surface at which it still covers it
    double along = 0;              // mm of path before it
    std::uint32_t layer = 0;
    Srgb8 colour;
};

// The stroke that covers a point of the surface.
struct Cover {
    const Stroke* stroke = nullptr; // null: none; else one of the highest layer, the nearest there, ties: the first
    double off = 0;                 // distance from its middle in half widths, 0 to 1
    geom::Vec3 outwards;            // mm, vector from its middle to the point
    bool twice = false;             // covered by parts of that layer that are not neighbours along the path
};

// A hash grid with cells slightly wider than the widest stroke. Memory: a few hundred bytes per length of one width,
// and at most about 100 MB for very thin strokes.
class Strokes {
  public:
    explicit Strokes(std::vector<Stroke> strokes);
    // The cover of the point `p` of a surface with `normal` there. A stroke covers it if it lies on this side and at
    // most `reach` off. Seen along the stroke's own normal, the point must be at most half its width aside.
    [[nodiscard]] Cover at(geom::Vec3 p, geom::Vec3 normal) const;
    [[nodiscard]] bool empty() const { return strokes_.empty(); }

  private:
    struct Slot {
        std::uint64_t key = 0;
        std::uint32_t begin = 0, end = 0; // range in items_; empty slots have end 0
    };
    [[nodiscard]] std::uint64_t key(geom::Vec3 p) const;
    void fill();
    std::vector<Stroke> strokes_;
    std::vector<Slot> slots_; // open addressing; a power of 2
    std::vector<std::uint32_t> items_;
    geom::Vec3 lo_;
    double cell_ = 1;
};

} // namespace filum::render
