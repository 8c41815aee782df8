// Windows: parts of an edge that are reached from one source by straight lines in an unfolded strip of triangles.
// Private to lib/shapes/geodesic.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace filum::geodesic {

// In the frame of a half-edge: x along it from its tail, y to the left, into the triangle that the window will enter.
//   point source at (sx, sy), sy <= 0:  distance(x) = sigma + |(x, 0) - (sx, sy)|
//   line source, sy > 0:                distance(x) = sigma + sx x, along the unit direction (sx, sy)
struct Window {
    double b0, b1;      // mm, b0 < b1: the part of the edge
    double sx, sy;      // source or direction
    double sigma;       // mm: distance at the source, or at the frame's origin
    std::uint32_t next; // next window of the half-edge by b0; kNone for the last
    bool pending;       // not yet propagated

    [[nodiscard]] bool is_line() const { return sy > 0; }
    [[nodiscard]] double at(double x) const {
        if (is_line()) return sigma + sx * x;
        const double dx = x - sx;
        return sigma + std::sqrt(dx * dx + sy * sy);
    }
};

// Windows by number, in blocks that never move, so growing needs no second copy. Numbers are not reused, so windows
// created together are near each other in memory.
class Windows {
  public:
    [[nodiscard]] std::size_t size() const { return size_; }
    Window& operator[](std::uint32_t i) { return blocks_[i >> kBits][i & kMask]; }
    const Window& operator[](std::uint32_t i) const { return blocks_[i >> kBits][i & kMask]; }
    void add() {
        if ((size_++ & kMask) != 0) return;
        blocks_.push_back(std::make_unique_for_overwrite<Window[]>(std::size_t{1} << kBits));
        used_.push_back(std::size_t{1} << kBits);
    }
    // Frees window i; a block is freed with its last window.
    void drop(std::uint32_t i) {
        if (--used_[i >> kBits] == 0) blocks_[i >> kBits].reset();
    }

  private:
    static constexpr std::uint32_t kBits = 12, kMask = (1U << kBits) - 1;
    std::vector<std::unique_ptr<Window[]>> blocks_;
    std::vector<std::size_t> used_;
    std::size_t size_ = 0;
};

// Where the distances of two windows are equal within (lo, hi): at most two places, ascending.
struct Crossings {
    int count = 0;
    double x[2] = {0, 0};
};
Crossings crossings(const Window& a, const Window& b, double lo, double hi);

} // namespace filum::geodesic
