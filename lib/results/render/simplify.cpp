#include "render/simplify.hpp"

namespace filum::render {

namespace {

using geom::Vec3;

// The distance of p from the segment a -> b.
double off_segment(Vec3 a, Vec3 b, Vec3 p) {
    const Vec3 d = b - a;
    const double l2 = dot(d, d), t = l2 > 0 ? std::clamp(dot(p - a, d) / l2, 0.0, 1.0) : 0;
    return norm(p - (a + t * d));
}

} // namespace

std::vector<std::uint32_t> visible_points(const toolpath::Span& s, double tolerance) {
    constexpr std::size_t kLongest = 24;
    std::vector<std::uint32_t> out{0};
    const auto fits = [&](std::size_t a, std::size_t b) {
        const double l = geom::distance(s.points[a], s.points[b]);
        for (std::size_t i = a + 1; i < b; ++i) {
            if (off_segment(s.points[a], s.points[b], s.points[i]) > tolerance) return false;
            if (s.width.size() <= 1) continue;
            const double t = l > 0 ? geom::distance(s.points[a], s.points[i]) / l : 0;
            if (std::abs(s.width[i] - (1 - t) * s.width[a] - t * s.width[b]) > tolerance) return false;
        }
        return true;
    };
    for (std::size_t i = 1; i < s.points.size(); ++i) {
        const std::size_t a = out.back();
        if (i + 1 < s.points.size() && i + 1 - a <= kLongest && fits(a, i + 1)) continue;
        out.push_back(static_cast<std::uint32_t>(i));
    }
    return out;
}

} // namespace filum::render
