// A uniform grid over many short segments: neighbours in constant time.
#pragma once

#include "geom/segment.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace filum::geom {

struct Segment {
    Vec2 a, b;
};

// Segment i lies in every cell that it comes nearer to than `margin`, along x and along y.  Cells grow where the box
// would need more than about eight per segment or 16 million, so memory is bounded whatever the coordinates.
class SegmentGrid {
  public:
    SegmentGrid(std::span<const Segment> segments, double cell, double margin = 0);

    [[nodiscard]] std::size_t cells() const { return start_.empty() ? 0 : start_.size() - 1; }
    // The segments of a cell, ascending.
    [[nodiscard]] std::span<const std::uint32_t> in(std::size_t cell) const {
        return {item_.data() + start_[cell], start_[cell + 1] - start_[cell]};
    }
    [[nodiscard]] std::size_t cell_at(Vec2 p) const { return cell(column(p.x), row(p.y)); } // the nearest, outside

    // Calls f(i) for every segment whose cells meet the box; a segment may come up several times.
    template <class F>
    void near(Vec2 lo, Vec2 hi, F&& f) const {
        if (columns_ == 0) return;
        const int x0 = column(lo.x), x1 = column(hi.x), y0 = row(lo.y), y1 = row(hi.y);
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x)
                for (const std::uint32_t i : in(cell(x, y))) f(i);
    }

    // True if the open segment p-q properly crosses any segment i for which use(i) holds.
    template <class Use>
    bool crosses(Vec2 p, Vec2 q, std::span<const Segment> segments, Use&& use) const {
        bool found = false;
        near({std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x), std::max(p.y, q.y)}, [&](std::uint32_t i) {
            if (!found && use(i)) found = cross_properly(p, q, segments[i].a, segments[i].b);
        });
        return found;
    }

  private:
    [[nodiscard]] int column(double x) const { return clamp_to((x - origin_.x) * per_mm_, columns_); }
    [[nodiscard]] int row(double y) const { return clamp_to((y - origin_.y) * per_mm_, rows_); }
    [[nodiscard]] std::size_t cell(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
    }
    static int clamp_to(double v, int n) { return static_cast<int>(std::clamp(v, 0.0, n - 1.0)); }
    template <class F>
    void cells_of(const Segment& s, double margin, F&& f) const;

    Vec2 origin_;
    double cell_ = 1, per_mm_ = 1; // mm; cells per mm
    int columns_ = 0, rows_ = 0;
    std::vector<std::uint32_t> start_, item_;
};

} // namespace filum::geom
