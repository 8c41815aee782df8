#include "surfpath/rows/swath.hpp"

#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace filum::surfpath::rows {

Swath::Swath(double width, double half)
    : half_width_(width / 2), grain_(rules::kFineGrain * width), size_(2 * static_cast<int>(std::ceil(half / grain_))),
      covered_(static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_), 0) {}

void Swath::add(geom::Vec2 p) {
    const double middle = (size_ - 1) / 2.0, x = p.x / grain_ + middle, y = p.y / grain_ + middle,
                 r = half_width_ / grain_;
    const int first = std::max(0, static_cast<int>(std::ceil(y - r))),
              last = std::min(size_ - 1, static_cast<int>(std::floor(y + r)));
    for (int row = first; row <= last; ++row) {
        const double half = std::sqrt(std::max(0.0, r * r - (row - y) * (row - y)));
        const int from = std::max(0, static_cast<int>(std::ceil(x - half))),
                  to = std::min(size_ - 1, static_cast<int>(std::floor(x + half)));
        const auto at = covered_.begin() + static_cast<std::ptrdiff_t>(row) * size_;
        if (from <= to) std::fill(at + from, at + to + 1, std::uint8_t{1});
    }
}

double Swath::covered() const {
    return grain_ * grain_ * static_cast<double>(std::accumulate(covered_.begin(), covered_.end(), std::size_t{0}));
}

} // namespace filum::surfpath::rows
