#include "render/plan.hpp"

#include "render/camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace filum::render {

namespace {

using geom::Vec3;

constexpr int kMostSamples = 1 << 22; // largest number of samples in a band, unless a single row of pixels has more

// Twice the signed area of the triangle a b c in the picture.
double turn(Vec3 a, Vec3 b, Vec3 c) { return geom::orient(a.xy(), b.xy(), c.xy()); }

} // namespace

Vec3 Plan::place(Vec3 p) const {
    const Vec3 d = p - centre;
    return {width / 2.0 + scale * dot(d, right), height / 2.0 - scale * dot(d, up), dot(d, towards)};
}

Vec3 upwards(Vec3 from) { return std::abs(unit(from).z) > 0.9 ? Vec3{0, 1, 0} : Vec3{0, 0, 1}; }

Plan lay_out(const std::vector<Vec3>& points, Vec3 from, Vec3 above, int width, int height) {
    constexpr double kMargin = 0.04, kLegend = 0.06; // as shares of the picture's height
    Plan plan;
    plan.width = width;
    plan.height = height;
    plan.towards = unit(from);
    plan.right = unit(cross(above, plan.towards));
    plan.up = cross(plan.towards, plan.right);
    Vec3 lo{INFINITY, INFINITY, INFINITY}, hi{-INFINITY, -INFINITY, -INFINITY};
    for (const Vec3& p : points) {
        const Vec3 q{dot(p, plan.right), dot(p, plan.up), dot(p, plan.towards)};
        lo = {std::min(lo.x, q.x), std::min(lo.y, q.y), std::min(lo.z, q.z)};
        hi = {std::max(hi.x, q.x), std::max(hi.y, q.y), std::max(hi.z, q.z)};
    }
    if (!(lo.x <= hi.x)) lo = hi = {};
    const double side = kMargin * height, below = (kMargin + kLegend) * height;
    const double wide = std::max(hi.x - lo.x, 1e-9), high = std::max(hi.y - lo.y, 1e-9);
    plan.scale = std::min((width - 2 * side) / wide, (height - side - below) / high);
    const double x = (lo.x + hi.x) / 2, y = (lo.y + hi.y) / 2 - (below - side) / (2 * plan.scale);
    plan.centre = x * plan.right + y * plan.up + (lo.z + hi.z) / 2 * plan.towards;
    return plan;
}

Raster::Raster(const surface::Surface& s, const Plan& plan, int fine)
    : s_(&s), plan_(plan), fine_(fine), rows_(std::clamp(kMostSamples / (plan.width * fine * fine), 1, 16)) {
    place_.reserve(s.vertices.size());
    for (const Vec3& p : s.vertices) {
        const Vec3 q = plan.place(p);
        place_.push_back({fine * q.x, fine * q.y, q.z});
    }
    in_band_.resize(static_cast<std::size_t>((plan.height + rows_ - 1) / rows_));
    const double high = rows_ * fine, last = static_cast<double>(in_band_.size()) - 1;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        double lo = INFINITY, hi = -INFINITY;
        for (const auto v : s.triangles[t]) {
            lo = std::min(lo, place_[v].y);
            hi = std::max(hi, place_[v].y);
        }
        if (hi < 0 || lo > fine * plan.height) continue;
        const auto first = static_cast<std::size_t>(std::clamp(std::floor(lo / high), 0.0, last));
        const auto end = static_cast<std::size_t>(std::clamp(std::floor(hi / high), 0.0, last));
        for (auto b = first; b <= end; ++b) in_band_[b].push_back(t);
    }
}

Sights Raster::band(int b) const {
    Sights out;
    out.columns = plan_.width * fine_;
    out.rows = std::min(rows_, plan_.height - b * rows_) * fine_;
    out.sample.resize(static_cast<std::size_t>(out.columns) * static_cast<std::size_t>(out.rows));
    for (const auto t : in_band_[static_cast<std::size_t>(b)]) cover(t, b * rows_ * fine_, out);
    return out;
}

void Raster::cover(std::uint32_t triangle, int first_row, Sights& out) const {
    const auto& corner = s_->triangles[triangle];
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = place_[corner[k]] - Vec3{0.5, first_row + 0.5, 0};
    const double area = turn(p[0], p[1], p[2]);
    if (area == 0) return;
    const auto first = [](double a, double b, double c) { return std::max(0.0, std::ceil(std::min({a, b, c}))); };
    const int x0 = static_cast<int>(std::min<double>(first(p[0].x, p[1].x, p[2].x), out.columns));
    const int y0 = static_cast<int>(std::min<double>(first(p[0].y, p[1].y, p[2].y), out.rows));
    const int x1 = static_cast<int>(std::min(out.columns - 1.0, std::max({p[0].x, p[1].x, p[2].x, -1.0})));
    const int y1 = static_cast<int>(std::min(out.rows - 1.0, std::max({p[0].y, p[1].y, p[2].y, -1.0})));
    constexpr double kBorder = -1e-9; // tolerance, so that no sample falls between neighbouring triangles
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const Vec3 at{static_cast<double>(x), static_cast<double>(y), 0};
            const double a = turn(at, p[1], p[2]) / area, b = turn(p[0], at, p[2]) / area, c = 1 - a - b;
            if (a < kBorder || b < kBorder || c < kBorder) continue;
            const auto height = static_cast<float>(a * p[0].z + b * p[1].z + c * p[2].z);
            Sight& s = out.sample[static_cast<std::size_t>(y) * static_cast<std::size_t>(out.columns) +
                                  static_cast<std::size_t>(x)];
            if (s.triangle == surface::kNone || height > s.height) s = {triangle, height};
        }
    }
}

Vec3 Raster::shares(std::uint32_t triangle, int x, int y) const {
    const auto& corner = s_->triangles[triangle];
    const Vec3 at{x + 0.5, y + 0.5, 0};
    const Vec3 p0 = place_[corner[0]], p1 = place_[corner[1]], p2 = place_[corner[2]];
    const double area = turn(p0, p1, p2), u = turn(at, p1, p2) / area, v = turn(p0, at, p2) / area;
    return {u, v, 1 - u - v};
}

} // namespace filum::render
