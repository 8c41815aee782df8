#include "geom/segment_grid.hpp"

namespace filum::geom {

template <class F>
void SegmentGrid::cells_of(const Segment& s, F&& f) const {
    Vec2 a = s.a, b = s.b;
    if (a.y > b.y) std::swap(a, b);
    const int y0 = row(a.y), y1 = row(b.y);
    for (int y = y0; y <= y1; ++y) { // the stretch of the segment within this row of cells
        double xa = a.x, xb = b.x;
        if (y0 != y1) {
            const double slope = (b.x - a.x) / (b.y - a.y), bottom = origin_.y + y * cell_;
            if (y > y0) xa = a.x + slope * (bottom - a.y);
            if (y < y1) xb = a.x + slope * (bottom + cell_ - a.y);
        }
        // one cell more on each side where rounding could have gone either way
        const double slack = 1e-9 * cell_;
        const int x0 = column(std::min(xa, xb) - slack), x1 = column(std::max(xa, xb) + slack);
        for (int x = x0; x <= x1; ++x)
            f(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x));
    }
}

SegmentGrid::SegmentGrid(std::span<const Segment> segments, double cell) : cell_(cell) {
    if (segments.empty()) return;
    Box2 box;
    double length = 0;
    for (const Segment& s : segments) box.add(s.a), box.add(s.b), length += distance(s.a, s.b);
    origin_ = box.lo;
    const Vec2 size = box.hi - box.lo;
    const double most = std::min(16e6, 64 + 8 * (static_cast<double>(segments.size()) + length / cell));
    while ((size.x / cell_ + 1) * (size.y / cell_ + 1) > most) cell_ *= 1.5;
    columns_ = static_cast<int>(size.x / cell_) + 1;
    rows_ = static_cast<int>(size.y / cell_) + 1;

    // how many, then where the next cell begins; each item put in moves that to where its own cell begins
    start_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    for (const Segment& s : segments) cells_of(s, [&](std::size_t c) { ++start_[c]; });
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    item_.resize(start_.back());
    for (auto i = static_cast<std::uint32_t>(segments.size()); i-- > 0;)
        cells_of(segments[i], [&](std::size_t c) { item_[--start_[c]] = i; });
}

} // namespace filum::geom
