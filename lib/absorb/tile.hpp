// A square part of the plane in pixels: what belongs to the region, and how many beads cover it.
#pragma once

#include "geom/segment_grid.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace filum::absorb {

using geom::Box2;
using geom::Vec2;

// A straight bead with round ends.
struct Bead {
    Vec2 a, b;
    double width = 0; // mm
};

struct Pixel {
    int x = 0, y = 0;
};

// 64 x 64 pixels, one bit each; row y of the window at `corner` is rows[y], its first pixel the lowest bit.
struct Mask {
    std::array<std::uint64_t, 64> rows{};
};

class Tile {
  public:
    // Covers `box` with pixels of side `pixel`; a pixel is the region's if its centre lies within `edges` by the
    // even-odd rule: all edges of the region on the level of the box, or all of them.
    Tile(std::span<const geom::Segment> edges, const Box2& box, double pixel);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] double pixel() const { return pixel_; }
    [[nodiscard]] Vec2 centre(Pixel p) const {
        return {origin_.x + (p.x + 0.5) * pixel_, origin_.y + (p.y + 0.5) * pixel_};
    }
    [[nodiscard]] Pixel at(Vec2 p) const; // the nearest pixel of the tile
    [[nodiscard]] bool holds(Vec2 p) const {
        const Vec2 d = p - origin_;
        return d.x >= 0 && d.y >= 0 && d.x < width_ * pixel_ && d.y < height_ * pixel_;
    }
    [[nodiscard]] std::size_t index(Pixel p) const {
        return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(p.x);
    }
    [[nodiscard]] bool inside(Pixel p) const { return (value_[index(p)] & kInside) != 0; }
    [[nodiscard]] bool well_inside(Vec2 p) const; // its pixel, and those beside, above and below
    [[nodiscard]] bool empty(Pixel p) const { return (value_[index(p)] & kSeenMask) == kInside; } // region, no bead
    [[nodiscard]] bool seen(Pixel p) const { return (value_[index(p)] & kSeen) != 0; }
    void see(Pixel p) { value_[index(p)] |= kSeen; }
    void forget(Pixel p) { value_[index(p)] &= kSeenMask; }
    // The first empty, unseen pixel of row y in [x, end), else end.
    [[nodiscard]] int next_empty(int x, int end, int y) const;
    // Pixels of the region in lo .. hi, and how many of them are empty.
    struct Counts {
        std::int64_t inside = 0, empty = 0;
    };
    [[nodiscard]] Counts count(Pixel lo, Pixel hi) const;

    // Counts the bead `times` times: 1 or -1.
    void add(const Bead& bead, int times) { paint(bead, {0, 0}, {width_ - 1, height_ - 1}, times); }
    // Of the window at `corner`: the pixels under `bead`, added to `mask`.
    void stamp(const Bead& bead, Pixel corner, Mask& mask) const;
    // Of the window at `corner`: the pixels that no bead covers but `beads`, up to seven of those that were added; of
    // the region and beyond it.
    void uncovered(Pixel corner, std::span<const Bead> beads, Mask& in, Mask& out) const;

  private:
    static constexpr std::uint8_t kInside = 0x80, kSeen = 0x40, kSeenMask = 0xbf, kCount = 0x3f;

    void paint(const Bead& bead, Pixel lo, Pixel hi, int times);
    template <class F>
    void rows(const Bead& bead, Pixel lo, Pixel hi, F&& f) const;
    void mark_inside(std::span<const geom::Segment> edges);

    Vec2 origin_;
    double pixel_;
    int width_, height_;
    std::vector<std::uint8_t> value_; // whether inside, whether seen, how many beads; 63 beads are counted no more
};

} // namespace filum::absorb
