#include "render/perspective.hpp"

#include "parallel/parallel.hpp"
#include "render/camera.hpp"
#include "render/sampling.hpp"
#include "render/table.hpp"
#include "render/tubes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace filum::render {

namespace {

using geom::Vec3;

// Bayer's matrix: neighbouring pixels are far apart in the sequence.
constexpr std::array<std::uint32_t, 16> kTile = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
constexpr std::uint32_t kSkySeed = 1, kLampSeed = 2; // arbitrary
constexpr Rgb kLampLight{1.22F, 1.17F, 1.10F}, kSkyLight{0.66F, 0.71F, 0.79F}, kTableLight{0.50F, 0.48F, 0.46F};

struct Studio {
    const Tubes& tubes;
    const Table& table;
    const View& view;
    int width, height; // pixels
    Camera camera;
    Vec3 lamp;        // direction to the lamp
    double reach = 0; // mm; nearer objects dim the sky
    double hair = 0;  // mm; secondary rays start at this distance from the surface
    double floor = 0; // z of the table
};

// A pixel before its light is smoothed. It holds its colours under an open sky and in full lamp light, and how much of
// both lights is free. Sky and lamp vary slowly, but the surfaces do not. So only the light is sampled coarsely and
// smoothed.
struct Pixel {
    Rgb under_sky, under_lamp, other; // sums over the samples
    float sky = 0, lamp = 0;          // sums of the free rays
    float sky_rays = 0, lamp_rays = 0, hits = 0;
    float depth = 0; // sum
    float nx = 0, ny = 0, nz = 0;
};

Rgb backdrop(double down) { // down: 0 at the top of the picture, 1 at the bottom
    return mix(oklch(0.985, 0.003, 250), oklch(0.91, 0.007, 250), static_cast<float>(down));
}

// Adds the colour of the surface that a ray met, as it is without shadows.
void add_surface(const Studio& s, Vec3 d, const Hit& hit, Pixel& out) {
    const Vec3 n = hit.normal;
    out.under_sky = out.under_sky + mix(kTableLight, kSkyLight, static_cast<float>(0.5 + 0.5 * n.z)) * hit.albedo;
    const double facing = dot(n, s.lamp);
    if (facing > 0) {
        const auto gloss = 0.10F * static_cast<float>(std::pow(std::max(0.0, dot(n, unit(s.lamp - d))), 24));
        out.under_lamp =
            out.under_lamp + kLampLight * (static_cast<float>(facing) * hit.albedo + Rgb{gloss, gloss, gloss});
    }
    out.hits += 1;
    out.depth += hit.distance;
    out.nx += static_cast<float>(n.x);
    out.ny += static_cast<float>(n.y);
    out.nz += static_cast<float>(n.z);
}

// Adds how much of the sky and the lamp reaches the point that a ray met.
void add_light(const Studio& s, Vec3 d, const Hit& hit, std::uint32_t k, Pixel& out) {
    const Vec3 n = hit.normal, from = s.camera.eye + double{hit.distance} * d + s.hair * n;
    Vec3 up = around(n, spread(kSkySeed, k));
    const bool down = s.view.table && up.z < 0;
    if (down) up.z = -up.z; // the table reflects light, dimmed by a factor
    out.sky += s.tubes.blocked(from, up, static_cast<float>(s.reach)) ? 0 : (down ? 0.55F : 1.0F);
    out.sky_rays += 1;
    if (dot(n, s.lamp) <= 0) return;
    out.lamp += s.tubes.blocked(from, lamp_ray(s.lamp, kLampSeed, k), INFINITY) ? 0 : 1;
    out.lamp_rays += 1;
}

float table_light(const Studio& s, Vec3 d) {
    const double t = s.view.table && d.z < -1e-6 ? (s.floor - s.camera.eye.z) / d.z : -1;
    return t > 0 ? s.table.at(s.camera.eye.x + t * d.x, s.camera.eye.y + t * d.y) : 1.0F;
}

// Enough rays towards the sky for a pixel: the share of them that is free is off by at most an eighth (standard error).
constexpr int kEnough = 16;

// Samples a pixel, four rays at a time. With fewer than 16 rays per pixel, only one hit in four is tested for light,
// and the result is smoothed later.
Pixel sample(const Studio& s, int x, int y, Rgb back, int rays) {
    Pixel out;
    const auto seed = hash(static_cast<std::uint32_t>(y) * 65536U + static_cast<std::uint32_t>(x));
    // Pixels of a tile of 4 x 4 share one even set of directions, so smoothing over a tile uses the whole set.
    const auto tile = kTile[static_cast<std::size_t>(4 * (y & 3) + (x & 3))];
    const auto samples = static_cast<std::uint32_t>(rays), stride = rays < kEnough ? 4U : 1U;
    for (std::uint32_t k = 0; k < samples; k += 4) {
        std::array<Vec3, 4> d;
        for (std::uint32_t j = 0; j < 4; ++j) {
            const Square at = spread(seed, k + j);
            d[j] = s.camera.ray(2 * (x + at.u) / s.width - 1, 1 - 2 * (y + at.v) / s.height);
        }
        const auto hit = s.tubes.shoot(s.camera.eye, d);
        for (std::uint32_t j = 0; j < std::min(4U, samples - k); ++j) {
            if (!hit[j].any) {
                out.other = out.other + table_light(s, d[j]) * back;
                continue;
            }
            if (static_cast<std::uint32_t>(out.hits) % stride == 0)
                add_light(s, d[j], hit[j], 16 * static_cast<std::uint32_t>(out.sky_rays) + tile, out);
            add_surface(s, d[j], hit[j], out);
        }
    }
    return out;
}

constexpr int kStrip = 256; // rows that are kept in memory at once

// The rows [first, last) of the picture before smoothing.
struct Strip {
    int first = 0, last = 0, width = 0;
    std::vector<Pixel> pixel;
    [[nodiscard]] const Pixel& at(int x, int y) const {
        return pixel[static_cast<std::size_t>(y - first) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x)];
    }
};

struct FreeShares {
    float sky = 0, lamp = 0;
    float rays = 0; // how many rays of equal weight give a mean as steady as that of the sky
};

// The free shares of sky and lamp at pixel (x, y), averaged over pixels around it that show the same surface.
FreeShares smoothed(const Studio& s, const Strip& strip, int x, int y, int reach) {
    const int w = s.width, h = s.height;
    const auto place = [&](const Pixel& p, int i, int j) {
        return double{p.depth / p.hits} * s.camera.ray((2.0 * i + 1) / w - 1, 1 - (2.0 * j + 1) / h);
    };
    const Pixel& p = strip.at(x, y);
    const Vec3 n = unit({p.nx, p.ny, p.nz}), here = place(p, x, y);
    const double thin = 0.35 * s.tubes.thickness();
    float sky = 0, sky_weight = 0, squares = 0, lamp = 0, lamp_weight = 0;
    for (int j = std::max(0, y - reach); j <= std::min(h - 1, y + reach); ++j) {
        for (int i = std::max(0, x - reach); i <= std::min(w - 1, x + reach); ++i) {
            const Pixel& q = strip.at(i, j);
            if (q.hits == 0) continue;
            const double alike = dot(n, {q.nx, q.ny, q.nz}) / q.hits, off = dot(n, place(q, i, j) - here) / thin;
            if (alike < 0.7 && !(i == x && j == y)) continue;
            const auto weight =
                static_cast<float>(alike > 0 ? alike * alike * alike * alike / (1 + off * off * off * off) : 1e-6);
            sky += weight * q.sky;
            sky_weight += weight * q.sky_rays;
            squares += weight * weight * q.sky_rays;
            lamp += weight * q.lamp;
            lamp_weight += weight * q.lamp_rays;
        }
    }
    return {sky_weight > 0 ? sky / sky_weight : 1, lamp_weight > 0 ? lamp / lamp_weight : 1,
            squares > 0 ? sky_weight * sky_weight / squares : 0};
}

// Compresses bright colours towards white, so that they are not clipped.
Rgb tone(Rgb c) {
    const auto bend = [](float v) { return v < 0.75F ? v : 0.75F + 0.25F * (1 - std::exp(-(v - 0.75F) / 0.25F)); };
    return {bend(c.r), bend(c.g), bend(c.b)};
}

void expose(const Studio& s, int threads, Strip& strip) {
    strip.pixel.assign(static_cast<std::size_t>(strip.last - strip.first) * static_cast<std::size_t>(strip.width), {});
    parallel::for_chunks(
        static_cast<std::size_t>(strip.last - strip.first), 8, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t row = begin; row < end; ++row) {
                const int y = strip.first + static_cast<int>(row);
                const Rgb back = backdrop(static_cast<double>(y) / s.height);
                for (int x = 0; x < strip.width; ++x)
                    strip.pixel[row * static_cast<std::size_t>(strip.width) + static_cast<std::size_t>(x)] =
                        sample(s, x, y, back, s.view.samples);
            }
        });
}

Rgb lit(const Pixel& p, FreeShares f, int rays) {
    Rgb c = p.other;
    if (p.hits > 0) c = c + p.hits * tone((1 / p.hits) * (f.sky * p.under_sky + f.lamp * p.under_lamp));
    return (1.0F / static_cast<float>(rays)) * c;
}

// The colour of pixel (x, y). Where the pixels around it show other surfaces, such as beads that are thinner than a
// pixel, their light does not count for it; it is sampled again, with enough rays of its own.
Rgb lit(const Studio& s, const Strip& strip, int x, int y, int reach) {
    const Pixel& p = strip.at(x, y);
    if (p.hits == 0) return lit(p, {}, s.view.samples);
    const FreeShares around = smoothed(s, strip, x, y, reach);
    if (2 * around.rays >= kEnough || s.view.samples >= kEnough) return lit(p, around, s.view.samples);
    const Pixel own = sample(s, x, y, backdrop(static_cast<double>(y) / s.height), kEnough);
    return lit(own, {own.sky_rays > 0 ? own.sky / own.sky_rays : 1, own.lamp_rays > 0 ? own.lamp / own.lamp_rays : 1},
               kEnough);
}

Image develop(const Studio& s, int threads) {
    const View& v = s.view;
    const int reach = v.samples < 16 ? 2 : (v.samples < 64 ? 1 : 0);
    Image out(s.width, s.height);
    for (int top = 0; top < s.height; top += kStrip) {
        const int bottom = std::min(s.height, top + kStrip);
        Strip strip{std::max(0, top - reach), std::min(s.height, bottom + reach), s.width, {}};
        expose(s, threads, strip);
        parallel::for_chunks(static_cast<std::size_t>(bottom - top), 8, threads,
                             [&](std::size_t begin, std::size_t end) {
                                 for (int y = top + static_cast<int>(begin); y < top + static_cast<int>(end); ++y) {
                                     for (int x = 0; x < s.width; ++x) {
                                         out.set(x, y, lit(s, strip, x, y, reach));
                                     }
                                 }
                             });
    }
    return out;
}

} // namespace

void draw_perspective(Canvas& canvas, const Scene& scene, const Tint& tint, const View& view, int threads) {
    const Tubes tubes(scene, tint, view.travels, threads);
    const double size = std::max(norm(tubes.half()), 1e-6), floor = -tubes.half().z;
    const double aspect = static_cast<double>(canvas.width()) / canvas.height();
    const Camera camera = view.around
                              ? aim(view.around->centre - tubes.centre(), view.around->radius, view.from, aspect)
                              : aim(scene, tubes.centre(), view.from, aspect, view.travels);
    // The lamp is above the viewer's left shoulder.
    const Vec3 lamp =
        unit(-0.55 * unit(camera.right) + 0.85 * Vec3{0, 0, 1} - 0.45 * camera.forward + 0.25 * unit(camera.up));
    const Table table(tubes, lamp, floor, view.table ? 2.2 * size : 0, threads);
    Studio studio{tubes,          table,           view,
                  canvas.width(), canvas.height(), camera,
                  lamp,           0.35 * size,     std::max(0.02 * tubes.thickness(), 1e-5 * size),
                  floor};
    canvas.image(develop(studio, threads));
    draw_legend(canvas, tint);
}

} // namespace filum::render
