#include "polygon/inside_test.hpp"

#include <algorithm>
#include <cmath>

namespace filum::polygon {

InsideTest::InsideTest(const Loops& area) {
    constexpr double kItems = 4; // rows that an average edge crosses, at most
    double climbed = 0;          // mm, the heights of all edges together
    for (std::size_t l = 0; l < area.size(); ++l) {
        const auto loop = area[l];
        for (std::size_t j = 0, k = loop.size() - 1; j < loop.size(); k = j++) {
            edge_.push_back({loop[k], loop[j]});
            box_.add(loop[j]);
            climbed += std::abs(loop[j].y - loop[k].y);
        }
    }
    const double height = edge_.empty() ? 0 : box_.hi.y - box_.lo.y;
    if (!(height > 0)) return;
    const auto n = static_cast<double>(edge_.size());
    rows_ = static_cast<std::size_t>(std::clamp(kItems * n * height / climbed, 1.0, n));
    per_mm_ = static_cast<double>(rows_) / height;
    first_.assign(rows_ + 1, 0);
    const auto rows = [&](const Edge& e, const auto& f) {
        const std::size_t to = row(std::max(e.a.y, e.b.y));
        for (std::size_t k = row(std::min(e.a.y, e.b.y)); k <= to; ++k) f(k);
    };
    for (const Edge& e : edge_) rows(e, [&](std::size_t k) { ++first_[k + 1]; });
    for (std::size_t k = 0; k < rows_; ++k) first_[k + 1] += first_[k];
    item_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < edge_.size(); ++i) rows(edge_[i], [&](std::size_t k) { item_[next[k]++] = i; });
}

std::size_t InsideTest::row(double y) const {
    return static_cast<std::size_t>(std::clamp((y - box_.lo.y) * per_mm_, 0.0, static_cast<double>(rows_ - 1)));
}

bool InsideTest::operator()(Vec2 p) const {
    if (rows_ == 0 || p.y < box_.lo.y || p.y > box_.hi.y) return false;
    const std::size_t at = row(p.y);
    bool inside = false;
    for (std::uint32_t k = first_[at]; k < first_[at + 1]; ++k) {
        const auto& [a, b] = edge_[item_[k]];
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
    return inside;
}

} // namespace filum::polygon
