#include "render/camera.hpp"

#include <algorithm>
#include <cmath>

namespace filum::render {

using geom::Vec3;

Vec3 Camera::ray(double sx, double sy) const { return unit(forward + sx * right + sy * up); }

namespace {

constexpr double kTan = 0.2679; // tangent of half the smaller angle of view, which is 30 degrees

Camera towards(Vec3 from) {
    Camera c;
    c.forward = -1.0 * unit(from);
    const Vec3 above = std::abs(c.forward.z) > 0.9999 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    c.right = unit(cross(c.forward, above));
    c.up = cross(c.right, c.forward);
    return c;
}

} // namespace

Camera aim(Vec3 at, double radius, Vec3 from, double aspect) {
    Camera c = towards(from);
    const double tan_v = aspect >= 1 ? kTan : kTan / aspect, tan_h = tan_v * aspect;
    c.eye = at - (radius / kTan * std::sqrt(1 + kTan * kTan)) * c.forward;
    c.right = tan_h * c.right;
    c.up = tan_v * c.up;
    return c;
}

Camera aim(const Scene& scene, Vec3 centre, Vec3 from, double aspect, bool travels) {
    constexpr double kMargin = 0.90; // share of the picture that the points fill
    Camera c = towards(from);
    const double tan_v = aspect >= 1 ? kTan : kTan / aspect, tan_h = tan_v * aspect;
    const double th = kMargin * tan_h, tv = kMargin * tan_v;
    // The largest r - t f and -r - t f over all points, where t is th or tv. r is the coordinate to the right or
    // upwards, f the one forward. They give the four sides of the viewing pyramid, moved outwards until no point is
    // beyond them.
    double right = -INFINITY, left = -INFINITY, top = -INFINITY, bottom = -INFINITY;
    const auto show = [&](const Vec3& at, double w) {
        const Vec3 p = at - centre;
        const double f = dot(p, c.forward) - w, r = dot(p, c.right), u = dot(p, c.up);
        right = std::max(right, r - th * f);
        left = std::max(left, -r - th * f);
        top = std::max(top, u - tv * f);
        bottom = std::max(bottom, -u - tv * f);
    };
    for (const auto& s : scene.spans) {
        if (!toolpath::extrudes(s.role) && !travels) continue;
        for (const Vec3& at : s.points) show(at, s.width.empty() ? 0 : s.width.front());
    }
    for (const Thing& thing : scene.meshes)
        for (const Vec3& at : thing.mesh.vertices) show(at, 0);
    if (!(right > -INFINITY)) right = left = top = bottom = 1;
    const double back = std::min(-(right + left) / (2 * th), -(top + bottom) / (2 * tv));
    c.eye = std::min(back, -1e-3) * c.forward + 0.5 * (right - left) * c.right + 0.5 * (top - bottom) * c.up;
    c.right = tan_h * c.right;
    c.up = tan_v * c.up;
    return c;
}

} // namespace filum::render
