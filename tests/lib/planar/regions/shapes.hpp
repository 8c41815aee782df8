// Shapes for the tests of regions.
#pragma once

#include "geom/segment.hpp"
#include "polygon/clip.hpp"
#include "polygon/region.hpp"
#include "regions/inradius.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace filum::regions {

using geom::Vec2;
using polygon::Loops;
using Random = std::mt19937;

inline double uniform(Random& random, double lo, double hi) { return lo + (hi - lo) * (random() / 4294967295.0); }

inline void add_box(Loops& to, double x, double y, double w, double h, bool hole = false) {
    if (hole)
        to.add(std::vector<Vec2>{{x, y}, {x, y + h}, {x + w, y + h}, {x + w, y}});
    else
        to.add(std::vector<Vec2>{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}});
}

inline Loops box(double x, double y, double w, double h) {
    Loops out;
    add_box(out, x, y, w, h);
    return out;
}

inline std::vector<Vec2> star(Random& random, Vec2 at, double size, int points) {
    std::vector<Vec2> out;
    for (int i = 0; i < points; ++i) {
        const double r = size * uniform(random, 0.3, 1), a = 2 * std::numbers::pi * i / points;
        out.push_back(
            {std::round((at.x + r * std::cos(a)) * 1e4) / 1e4, std::round((at.y + r * std::sin(a)) * 1e4) / 1e4});
    }
    return out;
}

// A star somewhere in a square of side `span`, of a size between two.
inline std::vector<Vec2> random_star(Random& random, double span, double least, double most, int points) {
    const Vec2 at{uniform(random, 0, span), uniform(random, 0, span)};
    return star(random, at, uniform(random, least, most), points);
}

inline std::vector<polygon::Region> layer_of(const std::vector<Loops>& outlines, std::uint32_t first) {
    std::vector<polygon::Region> out;
    for (const auto& l : outlines) {
        polygon::Region r;
        r.id = first++;
        r.loops = l;
        r.area = polygon::signed_area(l);
        r.inradius = inradius_bound(l, 0.2, 0.005);
        r.box = polygon::bounds(l);
        out.push_back(std::move(r));
    }
    return out;
}

inline polygon::Layer layer(Loops contours) { return {7, 1.6, 0.2, 1.5, std::move(contours)}; }

} // namespace filum::regions
