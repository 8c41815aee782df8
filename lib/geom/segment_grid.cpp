#include "geom/segment_grid.hpp"

#include "base/none.hpp"

namespace filum::geom {

template <class F>
void SegmentGrid::cells_of(const Segment& s, double margin, F&& f) const {
    const Vec2 a = s.a.y <= s.b.y ? s.a : s.b, b = s.a.y <= s.b.y ? s.b : s.a;
    const double beside = margin + 1e-9 * cell_; // one cell more on each side where rounding could have gone either way
    const int y0 = row(a.y - margin), y1 = row(b.y + margin);
    const auto cells = [&](int y, double xa, double xb) {
        const int x0 = column(std::min(xa, xb) - beside), x1 = column(std::max(xa, xb) + beside);
        for (int x = x0; x <= x1; ++x) f(cell(x, y));
    };
    if (y0 == y1) return cells(y0, a.x, b.x); // as of most
    const double slope = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0;
    for (int y = y0; y <= y1; ++y) { // the stretch of the segment within this row of cells
        const double bottom = origin_.y + y * cell_ - margin, top = bottom + cell_ + 2 * margin;
        cells(y, y > y0 && bottom > a.y ? a.x + slope * (bottom - a.y) : a.x,
              y < y1 && top < b.y ? a.x + slope * (top - a.y) : b.x);
    }
}

SegmentGrid::SegmentGrid(std::span<const Segment> segments, double cell, double margin) : cell_(cell) {
    if (segments.empty()) return;
    Box2 box;
    double length = 0;
    for (const Segment& s : segments) {
        box.add(s.a);
        box.add(s.b);
        length += distance(s.a, s.b);
    }
    origin_ = box.lo;
    const Vec2 size = box.hi - box.lo;
    const double most = std::min(16e6, 64 + 8 * (static_cast<double>(segments.size()) + length / cell));
    while ((size.x / cell_ + 1) * (size.y / cell_ + 1) > most) cell_ *= 1.5;
    per_mm_ = 1 / cell_;
    columns_ = static_cast<int>(size.x * per_mm_) + 1;
    rows_ = static_cast<int>(size.y * per_mm_) + 1;

    // how many, then where the next cell begins; each item put in moves that to where its own cell begins
    start_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    std::vector<std::uint32_t> only(segments.size()); // the cell of a segment that lies in one; most do
    for (std::size_t i = 0; i < segments.size(); ++i) {
        std::uint32_t cells = 0;
        cells_of(segments[i], margin, [&](std::size_t c) {
            ++start_[c];
            only[i] = cells++ == 0 ? static_cast<std::uint32_t>(c) : kNone;
        });
    }
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    item_.resize(start_.back());
    for (auto i = static_cast<std::uint32_t>(segments.size()); i-- > 0;) {
        const auto put = [&](std::size_t c) { item_[--start_[c]] = i; };
        if (only[i] != kNone)
            put(only[i]);
        else
            cells_of(segments[i], margin, put);
    }
}

} // namespace filum::geom
