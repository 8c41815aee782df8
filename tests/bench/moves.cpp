// A toolpath of very many moves on standard output, for the throughput of what reads toolpaths.
//   bench_moves planar|dome MOVES > FILE
// planar: layers of wavy rows, 0.4 mm a move, a travel between layers.
// dome: rows over a cap of radius 60 with its pole inside, the tool upright to it, 0.15 mm a move, travels along the
// normals between them; when the cap is full the next one lies on it.
#include "base/error.hpp"
#include "stream/writer.hpp"
#include "wire/planar.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using namespace filum;
using geom::Vec3;
using toolpath::Role;
using toolpath::Span;

constexpr std::size_t kRow = 500, kRows = 200;

// Hands over `next`, and before it the travel from the span before, lifted along the normals.
void hand_over(stream::Writer& writer, Span& last, Span&& next) {
    if (!last.points.empty()) {
        Span t{Role::travel, next.stroke, next.layer, 0, {last.points.back(), next.points.front()}, {}, {}, {}};
        if (!next.normals.empty()) {
            const Vec3 a = last.normals.back(), b = next.normals.front();
            t.points = {t.points[0], t.points[0] + 5 * a, t.points[1] + 5 * b, t.points[1]};
            t.normals = {a, a, b, b};
        }
        writer.write(wire::frame(t));
    }
    writer.write(wire::frame(next));
    last = std::move(next);
}

void planar(stream::Writer& writer, std::size_t moves) {
    Span last;
    for (std::uint32_t layer = 0; moves > 0; ++layer) {
        Span s{Role::bead, layer, layer, 0, {}, {0.42}, {0.2}, {}};
        for (std::size_t k = 0; k < kRow * kRows && moves > 0; ++k, --moves) {
            const std::size_t i = k % kRow, j = k / kRow;
            const double x = 0.4 * static_cast<double>(j % 2 == 0 ? i : kRow - 1 - i);
            s.points.push_back({x, 0.42 * static_cast<double>(j) + 0.1 * std::sin(x / 3 + layer), 0.2 * (layer + 1)});
        }
        if (s.points.size() > 1) hand_over(writer, last, std::move(s));
    }
}

void dome(stream::Writer& writer, std::size_t moves) {
    constexpr double radius = 60;
    Span last;
    for (std::uint32_t stroke = 0; moves > 0; ++stroke) {
        const std::uint32_t layer = stroke / kRows, row = stroke % kRows;
        Span s{Role::bead, stroke, layer, 0, {}, {0.42}, {0.2}, {}};
        const double y = 0.4 * (row - kRows / 2.0), rise = 0.2 * layer;
        for (std::size_t i = 0; i < kRow && moves > 0; ++i, --moves) {
            const double x = 0.15 * (static_cast<double>(row % 2 == 0 ? i : kRow - 1 - i) - kRow / 2.0);
            const Vec3 n{x / radius, y / radius, std::sqrt(radius * radius - x * x - y * y) / radius};
            s.points.push_back((radius + rise) * n + Vec3{0, 0, -40});
            s.normals.push_back(n);
        }
        if (s.points.size() > 1) hand_over(writer, last, std::move(s));
    }
}

} // namespace

int main(int argc, char** argv) {
    const std::string kind = argc > 1 ? argv[1] : "";
    const auto moves = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 0;
    if ((kind != "planar" && kind != "dome") || moves == 0) {
        std::fputs("usage: bench_moves planar|dome MOVES > FILE\n", stderr);
        return 2;
    }
    try {
        stream::Writer writer("-", {stream::Payload::toolpath, {{"bench_moves", "1", {}, {}}}, 0});
        kind == "planar" ? planar(writer, moves) : dome(writer, moves);
        writer.close();
    } catch (const Error& e) {
        std::fprintf(stderr, "bench_moves: %s\n", e.what());
        return static_cast<int>(e.exit());
    }
}
