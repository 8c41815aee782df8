#include "render/perspective.hpp"

#include "parallel/parallel.hpp"
#include "render/tubes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::render {

namespace {

using geom::Vec3;

Vec3 unit(Vec3 v) {
    const double l = norm(v);
    return l > 0 ? (1 / l) * v : Vec3{0, 0, 1};
}

struct Camera {
    Vec3 eye, right, up, forward; // right and up scaled to half the picture at distance 1
};

// Far enough that the box around the origin fits, with some room at the border.
Camera camera(const View& view, Vec3 half) {
    constexpr double kTan = 0.2679; // of half the vertical angle: 30 degrees in all
    const double aspect = static_cast<double>(view.width) / view.height;
    Camera c;
    c.forward = -1.0 * unit(view.from);
    const Vec3 z = std::abs(c.forward.z) > 0.9999 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    c.right = unit(cross(c.forward, z));
    c.up = cross(c.right, c.forward);
    const double tan_v = aspect >= 1 ? kTan : kTan / aspect, tan_h = tan_v * aspect;
    double away = 1e-3;
    for (int k = 0; k < 8; ++k) {
        const Vec3 p{k & 1 ? half.x : -half.x, k & 2 ? half.y : -half.y, k & 4 ? half.z : -half.z};
        const double near = 1.13 * std::max(std::abs(dot(p, c.right)) / tan_h, std::abs(dot(p, c.up)) / tan_v);
        away = std::max(away, near - dot(p, c.forward));
    }
    c.eye = -away * c.forward;
    c.right = tan_h * c.right, c.up = tan_v * c.up;
    return c;
}

std::uint32_t hash(std::uint32_t v) { // Wellons, "lowbias32"
    v = (v ^ (v >> 16)) * 0x7feb352dU;
    v = (v ^ (v >> 15)) * 0x846ca68bU;
    return v ^ (v >> 16);
}

// Point k of a sequence that fills the unit square evenly (Roberts' R2), shifted by a pixel's own offset.
struct Square {
    double u = 0, v = 0;
};
Square spread(std::uint32_t seed, std::uint32_t k) {
    const auto fraction = [](double x) { return x - std::floor(x); };
    const std::uint32_t a = hash(seed), b = hash(a);
    return {fraction(a * 0x1p-32 + 0.7548776662466927 * k), fraction(b * 0x1p-32 + 0.5698402909980532 * k)};
}

// Direction around `n`, denser near it as the cosine asks.
Vec3 around(Vec3 n, Square s) {
    const double sign = n.z >= 0 ? 1 : -1, a = -1 / (sign + n.z), b = n.x * n.y * a; // Duff et al. 2017
    const Vec3 t{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, q{b, sign + n.y * n.y * a, -n.y};
    const double r = std::sqrt(s.u), phi = 2 * std::numbers::pi * s.v;
    return r * std::cos(phi) * t + r * std::sin(phi) * q + std::sqrt(std::max(0.0, 1 - s.u)) * n;
}

struct Stage {
    const Tubes& tubes;
    const View& view;
    Camera eye;
    Vec3 lamp;     // direction to it
    double reach;  // mm; the sky is dimmed by what is nearer
    double hair;   // mm; secondary rays start that far off the surface
    double floor;  // z of the table
    double shadow; // mm around the middle; beyond there is no shadow on the table
};

constexpr Rgb kLampLight{1.62F, 1.55F, 1.45F}, kSkyLight{0.72F, 0.79F, 0.90F}, kTableLight{0.50F, 0.48F, 0.46F};

Rgb backdrop(double down) { // 0 at the top of the picture, 1 at the bottom
    return mix(oklch(0.985, 0.003, 250), oklch(0.90, 0.008, 250), static_cast<float>(down));
}

// Light on a surface, 1 for white in full light; two sky rays and one lamp ray.
Rgb light(const Stage& s, Vec3 p, Vec3 n, std::uint32_t seed, std::uint32_t k) {
    const Vec3 from = p + s.hair * n;
    double sky = 0;
    constexpr std::uint32_t kSkyRays = 2;
    for (std::uint32_t j = 0; j < kSkyRays; ++j) {
        Vec3 d = around(n, spread(seed ^ 0x9e3779b9U, kSkyRays * k + j));
        const bool down = d.z < 0;
        if (s.view.table && down) d.z = -d.z; // the table gives light back, less of it
        sky += s.tubes.blocked(from, d, static_cast<float>(s.reach)) ? 0 : (down ? 0.55 : 1);
    }
    sky /= kSkyRays;
    const double facing = dot(n, s.lamp);
    double lit = 0;
    if (facing > 0) {
        const Square q = spread(seed ^ 0x85ebca6bU, k);
        const Vec3 d = unit(s.lamp + 0.12 * around(s.lamp, q));
        lit = s.tubes.blocked(from, d, INFINITY) ? 0 : facing;
    }
    const Rgb ambient = mix(kTableLight, kSkyLight, static_cast<float>(0.5 + 0.5 * n.z));
    return static_cast<float>(sky) * ambient + static_cast<float>(lit) * kLampLight;
}

Rgb shade_table(const Stage& s, Rgb back, Vec3 p, std::uint32_t seed, std::uint32_t k) {
    const double far = std::hypot(p.x, p.y) / s.shadow;
    if (far >= 1) return back;
    const Vec3 n{0, 0, 1};
    double open = 0;
    const Vec3 from = p + s.hair * n;
    for (std::uint32_t j = 0; j < 2; ++j)
        open += s.tubes.blocked(from, around(n, spread(seed ^ 0x9e3779b9U, 2 * k + j)), INFINITY) ? 0 : 0.5;
    const Vec3 d = unit(s.lamp + 0.12 * around(s.lamp, spread(seed ^ 0x85ebca6bU, k)));
    const double lit = s.tubes.blocked(from, d, INFINITY) ? 0 : 1;
    const double bright = 0.42 + 0.30 * open + 0.28 * lit, fade = far < 0.7 ? 0 : (far - 0.7) / 0.3;
    return static_cast<float>(bright + (1 - bright) * fade) * back;
}

Rgb look(const Stage& s, double x, double y, std::uint32_t seed, std::uint32_t k) {
    const double sx = 2 * x / s.view.width - 1, sy = 1 - 2 * y / s.view.height;
    const Vec3 d = unit(s.eye.forward + sx * s.eye.right + sy * s.eye.up);
    const Hit hit = s.tubes.shoot(s.eye.eye, d);
    if (!hit.any) {
        const Rgb back = backdrop(y / s.view.height);
        const double t = d.z < -1e-6 ? (s.floor - s.eye.eye.z) / d.z : -1;
        if (!s.view.table || t <= 0 || s.tubes.empty()) return back;
        return shade_table(s, back, s.eye.eye + t * d, seed, k);
    }
    const Rgb got = light(s, s.eye.eye + double{hit.distance} * d, hit.normal, seed, k);
    const Vec3 middle = unit(s.lamp - d);
    const float gloss = 0.10F * static_cast<float>(std::pow(std::max(0.0, dot(hit.normal, middle)), 24)) * got.r;
    return hit.albedo * got + Rgb{gloss, gloss, gloss};
}

// Bends what is brighter than white, so that colours do not run out.
Rgb tone(Rgb c) {
    const auto bend = [](float v) { return v < 0.8F ? v : 0.8F + 0.2F * (1 - std::exp(-(v - 0.8F) / 0.2F)); };
    return {bend(c.r), bend(c.g), bend(c.b)};
}

} // namespace

Image draw_perspective(const Scene& scene, const Tint& tint, const View& view, int threads) {
    const Tubes tubes(scene, tint, view.travels, threads);
    const Vec3 half = tubes.half();
    const double size = std::max(norm(half), 1e-6);
    Stage s{tubes, view, camera(view, half), {}, 0.35 * size, 0.02 * tubes.thickness(), -half.z, 2.2 * size};
    s.lamp = unit(-0.55 * unit(s.eye.right) + 0.85 * Vec3{0, 0, 1} + -0.45 * s.eye.forward + 0.25 * unit(s.eye.up));
    s.hair = std::max(s.hair, 1e-5 * size);
    Image out(view.width, view.height);
    parallel::for_chunks(static_cast<std::size_t>(view.height), 8, threads, [&](std::size_t begin, std::size_t end) {
        for (auto y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
            for (int x = 0; x < view.width; ++x) {
                const auto seed = hash(static_cast<std::uint32_t>(y) * 65536U + static_cast<std::uint32_t>(x));
                Rgb sum;
                for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(view.samples); ++k) {
                    const Square at = spread(seed, k);
                    sum = sum + tone(look(s, x + at.u, y + at.v, seed, k));
                }
                out.set(x, y, (1.0F / static_cast<float>(view.samples)) * sum);
            }
        }
    });
    draw_legend(out, tint);
    return out;
}

} // namespace filum::render
