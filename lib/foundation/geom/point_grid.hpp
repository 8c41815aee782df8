// Points in the cells of a grid, to find those near a place.
#pragma once

#include "geom/vec.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace filum::geom {

// Points in the plane (V = Vec2) or in space (V = Vec3) in square or cubic cells. Memory is proportional to the number
// of points, wherever they are.
template <class V>
class PointGrid {
  public:
    PointGrid() = default;
    PointGrid(std::span<const V> points, double size) : size_(std::max(size, std::numeric_limits<double>::min())) {
        entries_.reserve(points.size());
        for (std::uint32_t i = 0; i < points.size(); ++i) entries_.push_back({cell(points[i]), i});
        std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
            return a.cell != b.cell ? a.cell < b.cell : a.point < b.point;
        });
    }

    // Calls f(i) for every point in the cells up to `cells` away from the cell of p along each axis; these include all
    // points within `cells` times the cell size. In the order of cells, x before y before z; within a cell by number.
    template <class F>
    void near(const V& p, std::int64_t cells, const F& f) const {
        Cell low = cell(p), high = low;
        for (auto& c : low) c -= cells;
        for (auto& c : high) c += cells;
        rows(low, high, low, 0, f);
    }

    // Calls f(i) for every point, in the same order.
    template <class F>
    void each(const F& f) const {
        for (const Entry& e : entries_) f(e.point);
    }

  private:
    static constexpr double kOutermost = 0x1p62; // largest number of a cell, which holds everything beyond
    static constexpr std::size_t kAxes = std::is_same_v<V, Vec2> ? 2 : 3;
    using Cell = std::array<std::int64_t, kAxes>;
    struct Entry {
        Cell cell;
        std::uint32_t point;
    };

    [[nodiscard]] Cell cell(const V& p) const {
        const auto number = [&](double v) {
            return static_cast<std::int64_t>(std::clamp(std::floor(v / size_), -kOutermost, kOutermost));
        };
        if constexpr (kAxes == 2)
            return {number(p.x), number(p.y)};
        else
            return {number(p.x), number(p.y), number(p.z)};
    }

    // Visits the cells from `low` to `high` that agree with `at` in the axes before `axis`; cells along the last axis
    // are consecutive.
    template <class F>
    void rows(const Cell& low, const Cell& high, Cell at, std::size_t axis, const F& f) const {
        if (axis + 1 < kAxes) {
            for (at[axis] = low[axis]; at[axis] <= high[axis]; ++at[axis]) rows(low, high, at, axis + 1, f);
            return;
        }
        Cell end = at;
        at[axis] = low[axis];
        end[axis] = high[axis];
        auto e = std::lower_bound(entries_.begin(), entries_.end(), at,
                                  [](const Entry& a, const Cell& c) { return a.cell < c; });
        for (; e != entries_.end() && e->cell <= end; ++e) f(e->point);
    }

    double size_ = 1;
    std::vector<Entry> entries_;
};

} // namespace filum::geom
