// Sample points on a surface, each with its share of the area.
#pragma once

#include "surface/surface.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace filum::surfpath::plan {

struct Sample {
    geom::Vec3 p, normal; // normal of its triangle
    double area;          // mm2
};

// Calls f(sample) for points of a triangle at distances of about `apart` mm, which share its area equally.
template <class F>
void each_sample(const surface::Surface& s, std::uint32_t t, double apart, const F& f) {
    const geom::Vec3 &a = s.vertices[s.triangles[t][0]], u = s.vertices[s.triangles[t][1]] - a,
                     v = s.vertices[s.triangles[t][2]] - a, n = surface::normal(s, t);
    const double side = std::max({norm(u), norm(v), norm(u - v)});
    const double most = std::sqrt(static_cast<double>(rules::kMostPieces)); // bounds the work on a huge triangle
    const auto k = static_cast<std::uint32_t>(std::clamp(std::ceil(side / apart), 1.0, most));
    const double part = norm(cross(u, v)) / 2 / (static_cast<double>(k) * k);
    for (std::uint32_t i = 0; i < k; ++i)
        for (std::uint32_t j = 0; j < 2 * (k - i) - 1; ++j) { // subtriangles, alternately upright and inverted
            const double turn = j % 2 == 0 ? 1.0 / 3 : 2.0 / 3;
            const std::uint32_t cell = j / 2;
            f(Sample{a + (i + turn) / k * u + (cell + turn) / k * v, n, part});
        }
}

// Calls f(samples) for the same points in small groups of neighbours. `room` is scratch space.
template <class F>
void each_few(const surface::Surface& s, std::uint32_t t, double apart, std::vector<Sample>& room, const F& f) {
    constexpr std::size_t kFew = 16; // such a group is not much longer than the beads around it are wide
    room.clear();
    each_sample(s, t, apart, [&](const Sample& one) {
        room.push_back(one);
        if (room.size() < kFew) return;
        f(std::span<const Sample>(room));
        room.clear();
    });
    if (!room.empty()) f(std::span<const Sample>(room));
}

inline geom::Box3 box_of(std::span<const Sample> samples) {
    geom::Box3 out;
    for (const Sample& one : samples) out.add(one.p);
    return out;
}

} // namespace filum::surfpath::plan
