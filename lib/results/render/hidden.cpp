#include "render/hidden.hpp"

#include <cmath>

namespace filum::render {

using geom::Vec3;

// Visits the cells at points of the segment at most half a cell apart. Calls f(index of word, mask) until it returns
// false.
template <class F>
void HiddenBeads::for_cells(Vec3 a, Vec3 b, F&& f) const {
    const Vec3 d = b - a;
    const double steps =
        std::ceil(2 * std::max({std::abs(d.x) / cell_.x, std::abs(d.y) / cell_.y, std::abs(d.z) / cell_.z}));
    for (double k = 0; k <= steps; ++k) {
        const Vec3 p = a + (steps > 0 ? k / steps : 0) * d - lo_;
        const auto x = static_cast<std::size_t>(p.x / cell_.x), y = static_cast<std::size_t>(p.y / cell_.y),
                   z = static_cast<std::size_t>(p.z / cell_.z);
        if (!f((z * rows_ + y) * words_ + x / 64, std::uint64_t{1} << (x % 64))) return;
    }
}

HiddenBeads::HiddenBeads(const Scene& scene, double width, double height) : cell_{width, width, height} {
    Vec3 lo{INFINITY, INFINITY, INFINITY}, hi{-INFINITY, -INFINITY, -INFINITY};
    for (const auto& s : scene.spans) {
        if (!toolpath::extrudes(s.role)) continue;
        for (const Vec3& p : s.points) {
            lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
            hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
        }
    }
    if (!(hi.x >= lo.x)) return;
    lo_ = lo - 1.5 * cell_; // leaves an empty cell on each side, and puts layers at the middle of cells
    const Vec3 size = hi - lo_;
    const double x = std::floor(size.x / cell_.x) + 2, y = std::floor(size.y / cell_.y) + 2,
                 z = std::floor(size.z / cell_.z) + 2;
    if (x * y * z > 0x1p29) return;
    words_ = static_cast<std::size_t>(x) / 64 + 1;
    rows_ = static_cast<std::size_t>(y);
    levels_ = static_cast<std::size_t>(z);
    full_.assign(words_ * rows_ * levels_, 0);
    for (const auto& s : scene.spans)
        for (std::size_t i = 0; toolpath::extrudes(s.role) && i + 1 < s.points.size(); ++i)
            for_cells(s.points[i], s.points[i + 1], [&](std::size_t word, std::uint64_t bit) {
                full_[word] |= bit;
                return true;
            });
    erode();
}

// Keeps the full cells whose 26 neighbours are full, by erosion along x, then y, then z.
void HiddenBeads::erode() {
    const std::size_t level = words_ * rows_;
    const auto old = [](const std::vector<std::uint64_t>& v, std::size_t i, std::size_t back) {
        return i < back ? 0 : v[i - back];
    };
    const auto next = [](const std::vector<std::uint64_t>& v, std::size_t i) { return i < v.size() ? v[i] : 0; };
    std::vector<std::uint64_t> from = full_;
    for (std::size_t i = 0; i < from.size(); ++i)
        full_[i] = from[i] & (from[i] << 1 | old(from, i, 1) >> 63) & (from[i] >> 1 | next(from, i + 1) << 63);
    for (const std::size_t step : {words_, level}) {
        from = full_;
        for (std::size_t i = 0; i < from.size(); ++i) full_[i] = from[i] & old(from, i, step) & next(from, i + step);
    }
}

bool HiddenBeads::operator()(Vec3 a, Vec3 b) const {
    if (full_.empty()) return false;
    bool all = true;
    for_cells(a, b, [&](std::size_t word, std::uint64_t bit) { return all = (full_[word] & bit) != 0; });
    return all;
}

} // namespace filum::render
