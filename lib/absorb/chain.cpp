#include "absorb/chain.hpp"

#include <algorithm>
#include <cmath>

namespace filum::absorb {

Chain::Chain(const std::vector<toolpath::Curve>& curves) {
    for (const auto& c : curves) {
        const auto first = static_cast<std::uint32_t>(nodes_.size()), n = static_cast<std::uint32_t>(c.points.size());
        first_.push_back(first);
        for (std::uint32_t i = 0; i < n; ++i)
            nodes_.push_back({{c.points[i], c.width_at(i)}, first + (i + 1) % n, first + (i + n - 1) % n});
    }
    originals_ = static_cast<std::uint32_t>(nodes_.size());
}

std::uint32_t Chain::put_after(std::uint32_t i, const Knot& k) {
    const auto id = static_cast<std::uint32_t>(nodes_.size());
    const std::uint32_t next = nodes_[i].next;
    nodes_.push_back({k, next, i});
    nodes_[i].next = id, nodes_[next].before = id;
    return id;
}

std::vector<toolpath::Curve> Chain::curves() const {
    std::vector<toolpath::Curve> out;
    for (const std::uint32_t first : first_) {
        toolpath::Curve c{true, {}, {}};
        std::uint32_t i = first;
        do {
            c.points.push_back(nodes_[i].knot.at), c.width.push_back(nodes_[i].knot.width);
            i = nodes_[i].next;
        } while (i != first);
        out.push_back(std::move(c));
    }
    return out;
}

Near::Near(const Chain& chain, const Box2& box, double cell)
    : chain_(&chain), origin_(box.lo), size_(cell), columns_(static_cast<int>((box.hi.x - box.lo.x) / cell) + 1),
      rows_(static_cast<int>((box.hi.y - box.lo.y) / cell) + 1),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

// Row by row of cells, those that the segment's stretch in the row meets, and one more where rounding might matter.
void Near::add(std::uint32_t segment) {
    Vec2 a = chain_->point(segment), b = chain_->point((*chain_)[segment].next);
    if (a.y > b.y) std::swap(a, b);
    const int y0 = row(a.y), y1 = row(b.y);
    const double slope = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0;
    for (int y = y0; y <= y1; ++y) {
        const double lo = origin_.y + y * size_, hi = lo + size_;
        const double xa = y0 == y1 ? a.x : a.x + slope * (std::max(lo, a.y) - a.y);
        const double xb = y0 == y1 ? b.x : a.x + slope * (std::min(hi, b.y) - a.y);
        const double slack = 1e-6 * size_;
        const int x0 = column(std::min(xa, xb) - slack), x1 = column(std::max(xa, xb) + slack);
        for (int x = x0; x <= x1; ++x) cells_[cell(x, y)].push_back(segment);
    }
}

} // namespace filum::absorb
