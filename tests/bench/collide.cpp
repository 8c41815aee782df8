// How long `collide` takes for a million moves over a part of 200000 triangles, tilted and growing:
// bench_collide [THREADS [LINES]].  Prints s of wall time and what was found.
#include "collision/report.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace filum;
using geom::Vec3;

constexpr double kSize = 300, kWave = 25, kHigh = 4;

// A field of hills, with its normal.
collision::ToolFrame hill(double x, double y, double above) {
    const double u = x / kWave, v = y / kWave;
    const double dx = kHigh / kWave * std::cos(u) * std::sin(v), dy = kHigh / kWave * std::sin(u) * std::cos(v);
    const double l = std::sqrt(1 + dx * dx + dy * dy);
    const Vec3 n{-dx / l, -dy / l, 1 / l};
    return {Vec3{x, y, kHigh * std::sin(u) * std::sin(v)} + above * n, n, {}};
}

mesh::Mesh ground() {
    constexpr std::uint32_t n = 317;
    mesh::Mesh out;
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i)
            out.vertices.push_back(hill(kSize * i / (n - 1), kSize * j / (n - 1), 0).tip);
    for (std::uint32_t j = 0; j + 1 < n; ++j)
        for (std::uint32_t i = 0; i + 1 < n; ++i) {
            const std::uint32_t a = j * n + i;
            out.triangles.push_back({a, a + 1, a + n + 1});
            out.triangles.push_back({a, a + n + 1, a + n});
        }
    return out;
}

} // namespace

int main(int argc, char** argv) {
    const int threads = argc > 1 ? std::atoi(argv[1]) : 2, lines = argc > 2 ? std::atoi(argv[2]) : 1000;
    collision::MoveReader walk(collision::Machine{});
    for (int j = 0; j < lines; ++j) {
        toolpath::Span span{toolpath::Role::bead, 0, 0, 0, {}, {0.3}, {0.2}, {}};
        for (int i = 0; i <= 1000; ++i) {
            const double x = kSize * (j % 2 == 0 ? i : 1000 - i) / 1000;
            const auto s = hill(x, 0.3 * j, 0.2);
            span.points.push_back(s.tip);
            span.normals.push_back(s.axis);
        }
        walk.add(span);
    }
    const auto begin = std::chrono::steady_clock::now();
    const auto now = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
    std::vector<collision::Solid> part;
    collision::add(ground(), part);
    const collision::Scene scene{collision::Tree(std::move(walk.growth.beads)), collision::Tree(std::move(part)),
                                 collision::Tree({}), collision::Tree({})};
    const double built = now();
    const collision::Options options;
    const auto found = collision::check(scene, {}, walk.growth.moves, options, threads);
    std::printf("%zu moves: trees %.2f s, check %.2f s, %zu collide\n", walk.growth.moves.size(), built, now() - built,
                found.moves);
    std::fputs(figures::text(collision::summary({walk.growth.moves, found, options}), figures::Format::table).c_str(),
               stdout);
    return 0;
}
