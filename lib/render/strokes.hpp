// Lines drawn on a surface, found again from the points that they cover.
#pragma once

#include "render/colour.hpp"

#include "geom/vec.hpp"

#include <cstdint>
#include <vector>

namespace filum::render {

struct Stroke {
    geom::Vec3 a, b;               // mm
    geom::Vec3 normal;             // unit, of the side of the surface that it lies on; 0: any side
    double half_a = 0, half_b = 0; // mm, half its width at the ends
    double reach = 0;              // mm: how far off the surface it may lie and still cover it
    double along = 0;              // mm of path before it
    std::uint32_t layer = 0;
    Srgb8 colour;
};

// What covers a point of the surface.
struct Cover {
    const Stroke* stroke = nullptr; // none: nothing; else the highest layer's, there the nearest, the first of equals
    double off = 0;                 // from its middle, in half widths: 0 to 1
    geom::Vec3 outwards;            // mm, from its middle to the point
    bool twice = false;             // by parts of that layer that are no neighbours along the path
};

// A hash grid of cells a little wider than the widest stroke: memory some hundred bytes per width of length, and no
// more than some 100 MB for very thin ones.
class Strokes {
  public:
    explicit Strokes(std::vector<Stroke> strokes);
    // The point `p` of a surface that faces `normal` there.  A stroke covers it if it lies on this side, at most
    // `reach` off, and, seen along its own normal, at most half its width aside.
    [[nodiscard]] Cover at(geom::Vec3 p, geom::Vec3 normal) const;
    [[nodiscard]] bool empty() const { return strokes_.empty(); }

  private:
    struct Slot {
        std::uint64_t key = 0;
        std::uint32_t begin = 0, end = 0; // in items_; an empty slot has none
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
