// Regions to fill, and what every fill of them must hold.
#pragma once

#include "../../crossings.hpp"
#include "shapes.hpp"

#include "geom/segment_grid.hpp"
#include "polygon/clip.hpp"
#include "toolpath/path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace filum::test {

using toolpath::Curve;

inline Loops loop(const std::vector<Vec2>& points) {
    Loops out;
    out.add(points);
    return out;
}

inline Loops star(Vec2 centre, double outer, double inner, int points) {
    std::vector<Vec2> p;
    for (int k = 0; k < 2 * points; ++k) {
        const double a = std::numbers::pi * k / points, r = k % 2 == 0 ? outer : inner;
        p.push_back(centre + r * Vec2{std::cos(a), std::sin(a)});
    }
    return loop(p);
}

// The connected parts as the chain hands them on: simple, on the grid, 1 um simplified.
inline std::vector<Loops> regions_of(const Loops& area) {
    std::vector<Loops> out;
    for (const auto& part : polygon::split(polygon::unite(area)).part) out.push_back(polygon::simplify(part, 0.001));
    return out;
}

// A blob with random radii, rid of random discs and crossed by random slots: connected parts with holes and
// concavities.
inline std::vector<Loops> random_regions(unsigned seed) {
    std::mt19937 random(seed);
    const auto uniform = [&](double lo, double hi) {
        return lo + (hi - lo) * (static_cast<double>(random()) / 4294967296.0);
    };
    const int n = 8 + static_cast<int>(random() % 40);
    std::vector<Vec2> p;
    for (int k = 0; k < n; ++k) {
        const double a = 2 * std::numbers::pi * k / n, r = uniform(2, 8);
        p.push_back({r * std::cos(a), r * std::sin(a)});
    }
    Loops area = loop(p);
    // Each number has its statement: in what order a compiler evaluates arguments is its own affair.
    for (int k = static_cast<int>(random() % 6); k > 0; --k) {
        const double r = uniform(0.2, 1.5);
        const Vec2 c{uniform(-5, 5), uniform(-5, 5)};
        area = polygon::subtract(area, disc(c, r));
    }
    for (int k = static_cast<int>(random() % 3); k > 0; --k) {
        const Vec2 a{uniform(-6, 6), uniform(-6, 6)};
        const Vec2 size{uniform(0.05, 3), uniform(0.05, 3)};
        area = polygon::subtract(area, rectangle(a.x, a.y, a.x + size.x, a.y + size.y));
    }
    return regions_of(area);
}

// Named shapes that bead paths find hard.
inline std::vector<std::pair<std::string, Loops>> hard_regions() {
    std::vector<std::pair<std::string, Loops>> out;
    const auto add = [&](const std::string& name, const Loops& area) {
        out.emplace_back(name, regions_of(area).at(0));
    };
    add("bar", rectangle(0, 0, 30, 5));
    add("square of odd size", rectangle(0, 0, 7.13, 7.13));
    add("star", star({1, 2}, 6, 2.5, 7));
    add("disc", disc({-3, 100}, 5));
    add("annulus", polygon::subtract(disc({0, 0}, 6), disc({0, 0}, 3)));
    add("thin annulus", polygon::subtract(disc({0, 0}, 6), disc({0, 0}, 5.1)));
    Loops comb = rectangle(0, 0, 20, 3);
    for (int k = 0; k < 8; ++k) comb = polygon::unite(comb, rectangle(2.5 * k, 2.9, 2.5 * k + 1.1, 9 - 0.3 * k));
    add("comb", comb);
    Loops plate = rectangle(0, 0, 16, 12);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 3; ++j) plate = polygon::subtract(plate, disc({2.2 + 3.8 * i, 2 + 3.9 * j}, 1.2));
    add("plate with holes", plate);
    add("wedge", loop({{0, 0}, {25, 0}, {25, 4}}));
    add("dumbbell", polygon::unite(polygon::unite(disc({-5, 0}, 3), disc({5, 0}, 3)), rectangle(-5, -0.45, 5, 0.45)));
    return out;
}

inline double length_of(const Curve& c) {
    double sum = 0;
    for (std::size_t i = 0; i + (c.closed ? 0 : 1) < c.points.size(); ++i)
        sum += geom::distance(c.points[i], c.points[(i + 1) % c.points.size()]);
    return sum;
}

// Length times width, mm2: what is deposited, per mm of height.
inline double laid(const std::vector<Curve>& curves) {
    double sum = 0;
    for (const auto& c : curves)
        for (std::size_t i = 0; i + (c.closed ? 0 : 1) < c.points.size(); ++i) {
            const std::size_t j = (i + 1) % c.points.size();
            sum += geom::distance(c.points[i], c.points[j]) * (c.width_at(i) + c.width_at(j)) / 2;
        }
    return sum;
}

inline std::size_t crossings(const std::vector<Curve>& curves) {
    std::vector<geom::Segment> all;
    for (const auto& c : curves)
        for (std::size_t i = 0; i + (c.closed ? 0 : 1) < c.points.size(); ++i)
            all.push_back({c.points[i], c.points[(i + 1) % c.points.size()]});
    return crossing_pairs_of(std::move(all));
}

inline double distance_to_outline(const Loops& region, Vec2 p) {
    double best = 1e300;
    for (std::size_t i = 0; i < region.size(); ++i)
        for (std::size_t k = 0; k < region[i].size(); ++k)
            best = std::min(best, geom::point_segment_distance(region[i][k], region[i][(k + 1) % region[i].size()], p));
    return best;
}

// How far a point of the curves (vertices and middles) strays outside the region, mm.
inline double farthest_outside(const Loops& region, const std::vector<Curve>& curves) {
    double worst = 0;
    for (const auto& c : curves)
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            const bool last = i + 1 == c.points.size() && !c.closed;
            const Vec2 next = last ? c.points[i] : c.points[(i + 1) % c.points.size()];
            for (const Vec2 p : {c.points[i], geom::lerp(c.points[i], next, 0.5)})
                if (!polygon::contains(region, p)) worst = std::max(worst, distance_to_outline(region, p));
        }
    return worst;
}

// Share of the region that a bead covers, on a raster.
inline double coverage(const Loops& region, const std::vector<Curve>& curves, double pixel = 0.06) {
    const auto box = polygon::bounds(region);
    const auto columns = static_cast<std::size_t>((box.hi.x - box.lo.x) / pixel) + 1;
    const auto rows = static_cast<std::size_t>((box.hi.y - box.lo.y) / pixel) + 1;
    std::vector<char> hit(columns * rows, 0);
    const auto centre = [&](std::size_t x, std::size_t y) {
        return Vec2{box.lo.x + (static_cast<double>(x) + 0.5) * pixel,
                    box.lo.y + (static_cast<double>(y) + 0.5) * pixel};
    };
    const auto cell = [&](double v, double lo, std::size_t n) {
        return static_cast<std::size_t>(std::clamp((v - lo) / pixel, 0.0, static_cast<double>(n)));
    };
    for (const auto& c : curves)
        for (std::size_t i = 0; i + (c.closed ? 0 : 1) < c.points.size(); ++i) {
            const std::size_t j = (i + 1) % c.points.size();
            const Vec2 a = c.points[i], b = c.points[j];
            const double r = std::max(c.width_at(i), c.width_at(j)) / 2;
            for (std::size_t y = cell(std::min(a.y, b.y) - r, box.lo.y, rows);
                 y < std::min(rows, cell(std::max(a.y, b.y) + r, box.lo.y, rows) + 1); ++y)
                for (std::size_t x = cell(std::min(a.x, b.x) - r, box.lo.x, columns);
                     x < std::min(columns, cell(std::max(a.x, b.x) + r, box.lo.x, columns) + 1); ++x) {
                    const double t = geom::nearest_parameter(a, b, centre(x, y));
                    const double w = c.width_at(i) + t * (c.width_at(j) - c.width_at(i));
                    if (geom::distance(geom::lerp(a, b, t), centre(x, y)) <= w / 2) hit[y * columns + x] = 1;
                }
        }
    double in = 0, covered = 0;
    for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t x = 0; x < columns; ++x)
            if (polygon::contains(region, centre(x, y))) {
                ++in;
                covered += hit[y * columns + x];
            }
    return in > 0 ? covered / in : 1;
}

inline bool same(const std::vector<Curve>& a, const std::vector<Curve>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i].closed != b[i].closed || a[i].points != b[i].points || a[i].width != b[i].width) return false;
    return true;
}

// Every curve has points, as many widths or one, all finite, none of no width.
inline void expect_sound(const std::vector<Curve>& curves) {
    for (const auto& c : curves) {
        ASSERT_GE(c.points.size(), c.closed ? 3U : 2U);
        ASSERT_TRUE(c.width.size() == 1 || c.width.size() == c.points.size());
        for (const Vec2 p : c.points) ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
        for (const double w : c.width) ASSERT_GT(w, 0);
    }
}

} // namespace filum::test
