#include "stressfield/principal.hpp"

#include "stressfield/triangle.hpp"

#include <Eigen/Dense>

namespace filum::stressfield {

namespace {

constexpr double kEqual = 1e-6;
constexpr double kTie = 1e-9;

Vec3 times(const Tensor& t, const Vec3& d) {
    return {t[0] * d.x + t[3] * d.y + t[5] * d.z, t[3] * d.x + t[1] * d.y + t[4] * d.z,
            t[5] * d.x + t[4] * d.y + t[2] * d.z};
}

} // namespace

PrincipalAxes principal_axes(const Tensor& t) {
    Eigen::Matrix3d m;
    m << t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
    const auto& w = solver.eigenvalues(); // ascending
    PrincipalAxes out{{w[2], w[1], w[0]}, {}};
    const Eigen::Vector3d d = solver.eigenvectors().col(2);
    if (w[2] - w[1] > kEqual * std::max(std::abs(w[2]), std::abs(w[0]))) out.first = Vec3{d[0], d[1], d[2]};
    return out;
}

std::optional<Vec3> in_plane_axis(const Tensor& t, const Vec3& n) {
    const Vec3 u = across(n), v = cross(n, u);
    const Vec3 tu = times(t, u), tv = times(t, v);
    const double uu = dot(u, tu), uv = dot(u, tv), vv = dot(v, tv);
    const double size = std::max(std::abs(uu), std::abs(vv));
    if (std::hypot(uu - vv, 2 * uv) <= kEqual * size) return {};
    const double angle = std::atan2(2 * uv, uu - vv) / 2;
    return std::cos(angle) * u + std::sin(angle) * v;
}

Vec3 signed_direction(const Vec3& d) {
    const double largest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) - kTie;
    const double leading = std::abs(d.x) >= largest ? d.x : std::abs(d.y) >= largest ? d.y : d.z;
    return leading < 0 ? -1.0 * d : d;
}

} // namespace filum::stressfield
