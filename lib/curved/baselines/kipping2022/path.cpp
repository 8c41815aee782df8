#include "baselines/kipping2022/path.hpp"

#include <Eigen/Dense>

#include <algorithm>

namespace filum::baselines::kipping2022 {

namespace {

// Row k: the weights of the values in a window in the polynomial's value at its k-th point.
Eigen::MatrixXd weights(std::size_t window, std::size_t degree) {
    const auto w = static_cast<Eigen::Index>(window), n = static_cast<Eigen::Index>(degree) + 1;
    const double half = static_cast<double>(window - 1) / 2;
    Eigen::MatrixXd powers(w, n);
    for (Eigen::Index i = 0; i < w; ++i)
        for (Eigen::Index k = 0; k < n; ++k) powers(i, k) = std::pow((static_cast<double>(i) - half) / half, k);
    const Eigen::MatrixXd q = powers.householderQr().householderQ() * Eigen::MatrixXd::Identity(w, n);
    return q * q.transpose();
}

} // namespace

Points resampled(std::span<const Vec3> points, bool closed, double step) {
    const double all = length(points, closed);
    const auto n = static_cast<std::size_t>(std::max(closed ? 3.0 : 1.0, std::round(all / step)));
    Points out;
    std::size_t i = 0;
    double before = 0;
    const auto stretch = [&] { return distance(points[i], points[(i + 1) % points.size()]); };
    const std::size_t last = points.size() - (closed ? 1 : 2);
    for (std::size_t k = 0; k < n; ++k) {
        const double way = all * static_cast<double>(k) / static_cast<double>(n);
        while (i < last && before + stretch() < way) {
            before += stretch();
            ++i;
        }
        const double l = stretch(), f = l > 0 ? std::min(1.0, (way - before) / l) : 0;
        out.push_back(points[i] + f * (points[(i + 1) % points.size()] - points[i]));
    }
    if (!closed) out.push_back(points.back());
    return out;
}

Points smoothed(std::span<const Vec3> points, std::size_t window, std::size_t degree) {
    Points out(points.begin(), points.end());
    window = std::min(window, points.size() - (points.size() % 2 == 0 ? 1 : 0));
    if (window <= degree + 1) return out;
    const Eigen::MatrixXd weight = weights(window, degree);
    const std::size_t half = window / 2;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t first = std::min(i > half ? i - half : 0, points.size() - window);
        Vec3 sum;
        for (std::size_t k = 0; k < window; ++k)
            sum = sum + weight(static_cast<Eigen::Index>(i - first), static_cast<Eigen::Index>(k)) * points[first + k];
        out[i] = sum;
    }
    return out;
}

void Strokes::lay(std::span<const Vec3> points, surfpath::plan::Plan& to) const {
    const double l = length(points, false);
    if (points.size() < 2 || l < o_.resample) {
        if (!points.empty()) to.notes.push_back(lines_note(NoteCode::line_too_short, l, points[0]));
        return;
    }
    const Points even = resampled(points, false, o_.resample);
    surfpath::plan::Section piece;
    for (const Vec3& p : smoothed(even, static_cast<std::size_t>(o_.window), static_cast<std::size_t>(o_.degree)))
        piece.line.places.push_back({locator_.nearest(p).triangle, p});
    to.strokes.push_back({{std::move(piece)}});
}

} // namespace filum::baselines::kipping2022
