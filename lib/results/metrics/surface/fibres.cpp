#include "metrics/surface/fibres.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::metrics::surface {

namespace {

constexpr double kJump = 1e-6;  // mm
constexpr double kStill = 1e-9; // mm

void lay(Fibres& f, const toolpath::Span& span, std::size_t i, double d) {
    const auto axis = [&](std::size_t k) { return span.normals.empty() ? Vec3{} : span.normals[k]; };
    if (!f.open) {
        f.all.push_back({{span.points[i]}, {0}, {axis(i)}, {}, {}, {}, {}});
        f.open = true;
    }
    Fibre& c = f.all.back();
    c.axes.push_back(axis(i + 1));
    c.points.push_back(span.points[i + 1]);
    c.along.push_back(c.along.back() + d);
    c.role.push_back(span.role);
    c.layer.push_back(span.layer);
    c.width.push_back((span.width_at(i) + span.width_at(i + 1)) / 2);
    c.height.push_back((span.height_at(i) + span.height_at(i + 1)) / 2);
}

} // namespace

void add(Fibres& f, const toolpath::Span& span) {
    const double jump = f.begun ? distance(f.at, span.points.front()) : 0;
    if (jump > kJump) {
        f.travel += jump;
        ++f.jumps;
        f.open = false;
    }
    for (std::size_t i = 0; i + 1 < span.points.size(); ++i) {
        const double d = distance(span.points[i], span.points[i + 1]);
        if (d <= kStill) continue;
        if (toolpath::extrudes(span.role))
            lay(f, span, i, d);
        else {
            f.travel += d;
            f.open = false;
        }
    }
    f.at = span.points.back();
    f.begun = true;
}

double length(const Fibres& fibres) {
    double sum = 0;
    for (const Fibre& c : fibres.all) sum += c.length();
    return sum;
}

double median_width(const Fibres& fibres) {
    std::vector<Weighted> all;
    for (const Fibre& c : fibres.all)
        for (std::size_t i = 0; i < c.width.size(); ++i) all.push_back({c.width[i], c.along[i + 1] - c.along[i]});
    return all.empty() ? 0 : quantile(all, 0.5);
}

Vec3 point_at(const Fibre& c, double s, std::size_t& stretch) {
    while (stretch + 2 < c.points.size() && c.along[stretch + 1] < s) ++stretch;
    const double t = (s - c.along[stretch]) / (c.along[stretch + 1] - c.along[stretch]);
    const Vec3 &a = c.points[stretch], &b = c.points[stretch + 1];
    return a + std::clamp(t, 0.0, 1.0) * (b - a);
}

std::vector<Vec3> resampled(const Fibre& c, double step) {
    const auto n = static_cast<std::size_t>(std::max(1.0, std::round(c.length() / step)));
    std::vector<Vec3> out{c.points.front()};
    std::size_t stretch = 0;
    for (std::size_t i = 1; i < n; ++i)
        out.push_back(point_at(c, c.length() * static_cast<double>(i) / static_cast<double>(n), stretch));
    out.push_back(c.points.back());
    return out;
}

double quantile(std::vector<Weighted>& values, double q) {
    std::sort(values.begin(), values.end(), [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
    double all = 0, below = 0;
    for (const Weighted& w : values) all += w.weight;
    for (const Weighted& w : values)
        if ((below += w.weight) >= q * all) return w.value;
    return values.empty() ? std::numeric_limits<double>::quiet_NaN() : values.back().value;
}

} // namespace filum::metrics::surface
