#include "render/table.hpp"

#include "parallel/parallel.hpp"
#include "render/camera.hpp"
#include "render/sampling.hpp"

#include <algorithm>
#include <cmath>

namespace filum::render {

namespace {

constexpr int kCells = 160; // cells per side
constexpr std::uint32_t kRays = 8;

std::size_t cell(int x, int y) { return static_cast<std::size_t>(y) * kCells + static_cast<std::size_t>(x); }

// The mean over 3 x 3 cells. Neighbouring cells use different rays, so it reduces the noise.
std::vector<float> smooth(const std::vector<float>& v) {
    std::vector<float> out(v);
    for (int y = 1; y + 1 < kCells; ++y)
        for (int x = 1; x + 1 < kCells; ++x) {
            float sum = 0;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) sum += v[cell(x + dx, y + dy)];
            out[cell(x, y)] = sum / 9;
        }
    return out;
}

} // namespace

geom::Vec3 lamp_ray(geom::Vec3 lamp, std::uint32_t seed, std::uint32_t k) {
    return unit(lamp + 0.12 * around(lamp, spread(seed ^ 0x85ebca6bU, k)));
}

Table::Table(const Tubes& tubes, geom::Vec3 lamp, double floor, double radius, int threads)
    : radius_(radius), bright_(std::size_t{kCells} * kCells, 1.0F) {
    if (tubes.empty() || radius <= 0) return;
    const double step = 2 * radius / (kCells - 1);
    parallel::for_chunks(kCells, 4, threads, [&](std::size_t begin, std::size_t end) {
        for (auto y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
            for (int x = 0; x < kCells; ++x) {
                const geom::Vec3 p{x * step - radius, y * step - radius, floor};
                const double far = std::hypot(p.x, p.y) / radius;
                if (far >= 1) continue;
                const std::uint32_t seed = hash(static_cast<std::uint32_t>(cell(x, y)));
                int open = 0, lit = 0;
                for (std::uint32_t k = 0; k < kRays; ++k) {
                    open += tubes.blocked(p, around({0, 0, 1}, spread(seed, k)), INFINITY) ? 0 : 1;
                    lit += tubes.blocked(p, lamp_ray(lamp, seed, k), INFINITY) ? 0 : 1;
                }
                const double bright = 0.42 + (0.32 * open + 0.26 * lit) / kRays;
                const double fade = std::clamp((far - 0.7) / 0.3, 0.0, 1.0);
                bright_[cell(x, y)] = static_cast<float>(bright + (1 - bright) * fade);
            }
        }
    });
    bright_ = smooth(smooth(bright_));
}

float Table::at(double x, double y) const {
    if (radius_ <= 0) return 1;
    const double u = (x + radius_) / (2 * radius_) * (kCells - 1), v = (y + radius_) / (2 * radius_) * (kCells - 1);
    if (!(u >= 0 && v >= 0 && u < kCells - 1 && v < kCells - 1)) return 1;
    const int i = static_cast<int>(u), j = static_cast<int>(v);
    const auto s = static_cast<float>(u - i), t = static_cast<float>(v - j);
    return (1 - t) * ((1 - s) * bright_[cell(i, j)] + s * bright_[cell(i + 1, j)]) +
           t * ((1 - s) * bright_[cell(i, j + 1)] + s * bright_[cell(i + 1, j + 1)]);
}

} // namespace filum::render
