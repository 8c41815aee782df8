// A uniform grid over many short segments, which finds neighbours in constant time.
#pragma once

#include "geom/segment.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace filum::geom {

struct Segment {
    Vec2 a, b;
};

// mm: a good size of cells for these segments, at least `least`. As wide as the segments lie apart on average, so that
// few segments share a cell, but at least a quarter of their mean length: a segment lies in about six cells, however
// long it is. Cells that long rows share cost little: the pairs of rows in them are as many for any size of cells.
double cell_for(std::span<const Segment> segments, double least);

// The numbers of the cells of a uniform grid over some segments. Cells are stored in blocks of 8 x 8, in the order in
// which segments reach them, and only if a block is not empty. So neighbouring cells along a line are near each other
// in memory, and a thin ring in a large box needs memory for its own area only. Cells grow if the box would need more
// than about eight blocks per segment or 16 million, or if the segments would be in more cells than 4 million and 24
// each, which bounds memory for any coordinates.
class CellBlocks {
  protected:
    static constexpr unsigned kSide = 8; // cells per side of a block

    CellBlocks(std::span<const Segment> segments, double cell, double margin);

    [[nodiscard]] bool none() const { return columns_ == 0; }
    [[nodiscard]] unsigned column(double x) const { return clamp_to((x - origin_.x) * per_mm_, columns_); }
    [[nodiscard]] unsigned row(double y) const { return clamp_to((y - origin_.y) * per_mm_, rows_); }
    [[nodiscard]] std::size_t number(unsigned x, unsigned y) const {
        return first_[block(x, y)] + kSide * (y % kSide) + x % kSide;
    }
    // The number of a cell whose block gets cells in `cells` if it has none.
    std::size_t number_in(std::vector<std::uint32_t>& cells, unsigned x, unsigned y) {
        std::uint32_t& first = first_[block(x, y)];
        if (first == 0) {
            first = static_cast<std::uint32_t>(cells.size() - 1);
            cells.resize(cells.size() + kSide * kSide, 0);
        }
        return first + kSide * (y % kSide) + x % kSide;
    }
    // Calls f(x, y) for the cells of segment s.
    template <class F>
    void cells_of(const Segment& s, double margin, F&& f) const;

  private:
    [[nodiscard]] std::size_t block(unsigned x, unsigned y) const { return y / kSide * blocks_ + x / kSide; }
    static unsigned clamp_to(double v, unsigned n) {
        return static_cast<unsigned>(static_cast<int>(std::clamp(v, 0.0, n - 1.0)));
    }

    Vec2 origin_;
    double cell_ = 1, per_mm_ = 1; // mm; cells per mm
    unsigned columns_ = 0, rows_ = 0;
    std::size_t blocks_ = 0;           // per row of blocks
    std::vector<std::uint32_t> first_; // per block: its first cell; 0 for empty blocks
};

// Segment i is in every cell to which its distance along x and along y is less than `margin`.
class SegmentGrid : private CellBlocks {
  public:
    SegmentGrid(std::span<const Segment> segments, double cell, double margin = 0);

    [[nodiscard]] std::size_t cells() const { return start_.empty() ? 0 : start_.size() - 1; }
    // The segments of a cell, ascending. All cells without segments may share the first one.
    [[nodiscard]] std::span<const std::uint32_t> in(std::size_t cell) const {
        return {item_.data() + start_[cell], start_[cell + 1] - start_[cell]};
    }
    // for points outside: the nearest cell
    [[nodiscard]] std::size_t cell_at(Vec2 p) const { return number(column(p.x), row(p.y)); }

    // Calls f(i) for every segment whose cells meet the box, possibly several times.
    template <class F>
    void near(Vec2 lo, Vec2 hi, F&& f) const {
        if (none()) return;
        const unsigned x0 = column(lo.x), x1 = column(hi.x), y0 = row(lo.y), y1 = row(hi.y);
        for (unsigned y = y0; y <= y1; ++y)
            for (unsigned x = x0, last = 0; x <= x1; x = last + 1) { // cells of a row within a block are consecutive
                last = std::min(x1, x | (kSide - 1));
                const std::size_t c = number(x, y), end = start_[c + (last - x) + 1];
                for (std::size_t k = start_[c]; k < end; ++k) f(item_[k]);
            }
    }

    // Calls f(i) for every segment that shares a cell with the segment p-q, possibly several times. A long diagonal
    // segment passes few of the cells of its box.
    template <class F>
    void along(Vec2 p, Vec2 q, F&& f) const {
        if (none()) return;
        cells_of({p, q}, 0, [&](unsigned x, unsigned y) {
            for (const std::uint32_t i : in(number(x, y))) f(i);
        });
    }

    // Whether the open segment p-q properly crosses any segment i for which use(i) holds.
    template <class Use>
    bool crosses(Vec2 p, Vec2 q, std::span<const Segment> segments, Use&& use) const {
        bool found = false;
        along(p, q, [&](std::uint32_t i) {
            if (!found && use(i)) found = cross_properly(p, q, segments[i].a, segments[i].b);
        });
        return found;
    }

  private:
    std::vector<std::uint32_t> start_, item_;
};

// Finds the pairs of segments that share a cell while segments are added, so a segment's cells are walked once.
class SegmentPairs : private CellBlocks {
  public:
    // `segments`: all that will be added.
    SegmentPairs(std::span<const Segment> segments, double cell, double margin = 0);

    // Adds segment i. Calls f(k) once for every segment k added before it that is in one of its cells.
    template <class F>
    void add(std::uint32_t i, F&& f) {
        cells_of(segments_[i], margin_, [&](unsigned x, unsigned y) {
            std::uint32_t& last = last_[number_in(last_, x, y)];
            for (std::uint32_t k = last; k != 0; k = entries_[k].before) {
                const std::uint32_t segment = entries_[k].segment;
                if (met_[segment] == i) continue;
                met_[segment] = i;
                f(segment);
            }
            entries_.push_back({i, last});
            last = static_cast<std::uint32_t>(entries_.size() - 1);
        });
    }

    // Calls f(k) for every segment k added so far that shares a cell with the segment p-q, possibly several times.
    template <class F>
    void along(Vec2 p, Vec2 q, F&& f) const {
        if (none()) return;
        cells_of({p, q}, 0, [&](unsigned x, unsigned y) {
            for (std::uint32_t k = last_[number(x, y)]; k != 0; k = entries_[k].before) f(entries_[k].segment);
        });
    }

  private:
    // A segment in a cell, and the entry of the same cell before it; 0: none.
    struct Entry {
        std::uint32_t segment, before;
    };

    std::span<const Segment> segments_;
    double margin_;
    std::vector<std::uint32_t> last_; // per cell: its last entry; 0: none
    std::vector<Entry> entries_;      // the first one is not used
    std::vector<std::uint32_t> met_;  // per segment: the last one that it was reported for
};

// Some of many segments: finds those that may meet another one. Costs little where they are few.
class MarkedSegments {
  public:
    // `marked`: per segment, whether it is one of them. `least`: mm, of a cell, as in cell_for().
    MarkedSegments(std::span<const Segment> all, std::span<const char> marked, double least, double margin = 0);

    // Calls f(i, k), i < k, once for every pair of segments that share a cell, if one of them is marked.
    template <class F>
    void pairs(F&& f) const {
        std::vector<std::uint32_t> met(number_.size(), ~std::uint32_t{0}); // per marked one: the last that met it
        for (std::uint32_t k = 0; k < all_.size(); ++k) {
            if (!meet(box_, bounds_of(all_[k]))) continue;
            grid_.along(all_[k].a, all_[k].b, [&](std::uint32_t m) {
                const std::uint32_t i = number_[m];
                if (std::exchange(met[m], k) == k) return;
                if (i < k)
                    f(i, k);
                else if (i > k && marked_[k] == 0) // else i meets k in its turn
                    f(k, i);
            });
        }
    }
    // Calls f(i) for every marked segment that shares a cell with the segment p-q, possibly several times.
    template <class F>
    void along(Vec2 p, Vec2 q, F&& f) const {
        grid_.along(p, q, [&](std::uint32_t m) { f(number_[m]); });
    }

  private:
    static Box2 bounds_of(const Segment& s) {
        return {{std::min(s.a.x, s.b.x), std::min(s.a.y, s.b.y)}, {std::max(s.a.x, s.b.x), std::max(s.a.y, s.b.y)}};
    }
    std::span<const Segment> all_;
    std::vector<char> marked_;
    std::vector<std::uint32_t> number_; // of each marked one
    std::vector<Segment> segments_;     // these
    Box2 box_;                          // of these, and a margin
    SegmentGrid grid_;
};

template <class F>
void CellBlocks::cells_of(const Segment& s, double margin, F&& f) const {
    const Vec2 a = s.a.y <= s.b.y ? s.a : s.b, b = s.a.y <= s.b.y ? s.b : s.a;
    const double beside = margin + 1e-9 * cell_; // adds a cell on each side where rounding could decide
    const unsigned y0 = row(a.y - margin), y1 = row(b.y + margin);
    const auto cells = [&](unsigned y, double xa, double xb) {
        const unsigned x0 = column(std::min(xa, xb) - beside), x1 = column(std::max(xa, xb) + beside);
        for (unsigned x = x0; x <= x1; ++x) f(x, y);
    };
    if (y0 == y1) return cells(y0, a.x, b.x); // most segments are in one row
    const double slope = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0;
    for (unsigned y = y0; y <= y1; ++y) { // the part of the segment in this row of cells
        const double bottom = origin_.y + y * cell_ - margin, top = bottom + cell_ + 2 * margin;
        cells(y, y > y0 && bottom > a.y ? a.x + slope * (bottom - a.y) : a.x,
              y < y1 && top < b.y ? a.x + slope * (top - a.y) : b.x);
    }
}

} // namespace filum::geom
