// Fitted triangles are alike, face as the surface does, keep rims and edges, and are as far off as reported.
#include "surface/fit/fit.hpp"

#include "base/error.hpp"
#include "geom/angle.hpp"
#include "geom/segment.hpp"
#include "surface/curve/locate.hpp"
#include "surface/fit/sizes.hpp"

#include "../../../trials.hpp"
#include "../grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>

namespace filum::surface::fit {
namespace {

struct Given {
    std::string name;
    Surface surface;
};

Surface connected(mesh::Mesh m) {
    Notes notes;
    return connect(std::move(m), notes);
}

// Radii of 6 and 2.5 mm, closed.
mesh::Mesh ring(std::uint32_t n, std::uint32_t m) {
    mesh::Mesh out;
    for (std::uint32_t j = 0; j < m; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const double a = 2 * std::numbers::pi * i / n, b = 2 * std::numbers::pi * j / m, r = 6 + 2.5 * std::cos(b);
            out.vertices.push_back({r * std::cos(a), r * std::sin(a), 2.5 * std::sin(b)});
        }
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return j % m * n + i % n; };
    for (std::uint32_t j = 0; j < m; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            out.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            out.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return out;
}

// A hill that was scanned: noise of 10 um, and holes.
mesh::Mesh scan() {
    std::mt19937 random(7);
    std::vector<double> noise(41 * 33);
    for (double& z : noise) z = 0.02 * (double(random()) / double(random.max()) - 0.5);
    std::size_t k = 0;
    const auto hill = [&](geom::Vec2 p) {
        return geom::Vec3{p.x, p.y, 3 * std::exp(-0.05 * norm2(p - geom::Vec2{6, 5})) + noise[k++]};
    };
    const auto hole = [](geom::Vec2 p) {
        return (p.x > 2 && p.x < 3.4 && p.y > 2 && p.y < 4.1) || norm(p - geom::Vec2{9, 6}) < 1;
    };
    return pierced_grid(12, 10, 40, 32, hill, hole);
}

mesh::Mesh box(double a, double b, double c) {
    mesh::Mesh m;
    for (std::uint32_t k = 0; k < 8; ++k)
        m.vertices.push_back({(k & 1U) != 0 ? a : 0, (k & 2U) != 0 ? b : 0, (k & 4U) != 0 ? c : 0});
    m.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return m;
}

std::vector<Given> surfaces() {
    const auto flat = [](geom::Vec2 p) { return geom::Vec3{p.x, p.y, 0}; };
    const auto roof = [](geom::Vec2 p) { return geom::Vec3{p.x, p.y, p.x < 4 ? p.x : 8 - p.x}; };
    const auto saddle = [](geom::Vec2 p) {
        return geom::Vec3{p.x, p.y, 0.06 * ((p.x - 5) * (p.x - 5) - (p.y - 4) * (p.y - 4))};
    };
    const auto half = [](geom::Vec2 p) { return geom::Vec3{5 * std::cos(p.x), p.y, 5 * std::sin(p.x)}; };
    std::vector<Given> out;
    out.push_back({"flat, coarse", connected(grid(9, 6, 1, 1, flat))});
    out.push_back({"flat, fine", connected(grid(9, 6, 80, 60, flat))});
    out.push_back({"roof", connected(grid(8, 6, 8, 6, roof))});
    out.push_back({"saddle, fine", connected(grid(10, 8, 60, 50, saddle))});
    out.push_back({"half a tube of long strips", connected(grid(std::numbers::pi, 20, 60, 1, half))});
    out.push_back({"half a tube of slivers", connected(grid(std::numbers::pi, 20, 600, 1, half))});
    out.push_back({"ring", connected(ring(80, 40))});
    out.push_back({"ring of few", connected(ring(24, 12))});
    out.push_back({"scan", connected(scan())});
    out.push_back({"box", connected(box(7, 5, 0.3))});
    return out;
}

// Measured at places all over each triangle, a fifth of a millimetre apart or closer.  A multiple of six of them along
// a side, so that the middles of sides and of the triangle are among them.
double farthest(const Surface& from, const Surface& to) {
    const curve::Locator locator(to);
    double out = 0;
    for (const auto& [a, b, c] : from.triangles) {
        const Vec3 &p = from.vertices[a], u = from.vertices[b] - p, v = from.vertices[c] - p;
        const int n =
            6 * std::clamp(static_cast<int>(std::ceil(5.0 / 6 * std::max({norm(u), norm(v), distance(u, v)}))), 1, 33);
        for (int i = 0; i <= n; ++i)
            for (int j = 0; i + j <= n; ++j) {
                const Vec3 q = p + double(i) / n * u + double(j) / n * v;
                out = std::max(out, distance(q, locator.nearest(q).point));
            }
    }
    return out;
}

using Sides = std::vector<std::pair<Vec3, Vec3>>;

// Rims, and edges sharper than `sharp` degrees.
Sides lines(const Surface& s, double sharp) {
    Sides out;
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        const std::uint32_t g = s.twin[h];
        if (g == kNone || (h < g && dot(normal(s, h / 3), normal(s, g / 3)) < std::cos(sharp * geom::kDegree)))
            out.emplace_back(s.vertices[s.tail(h)], s.vertices[s.head(h)]);
    }
    return out;
}

double farthest(const Sides& from, const Sides& to) {
    double out = 0;
    for (const auto& [a, b] : from)
        for (const double t : {0.0, 0.3, 0.5, 0.8}) {
            const Vec3 p = a + t * (b - a);
            double least = std::numeric_limits<double>::infinity();
            for (const auto& [c, d] : to)
                least = std::min(least, distance(p, c + geom::nearest_parameter(c, d, p) * (d - c)));
            out = std::max(out, least);
        }
    return out;
}

double flattest(const Surface& s) {
    double out = 1;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const double longest = std::max({side_length(s, 3 * t), side_length(s, 3 * t + 1), side_length(s, 3 * t + 2)});
        out = std::min(out, 2 * area(s, t) / (longest * longest));
    }
    return out;
}

// Triangles in whose middle nothing of `of` is near that faces as they do.
std::size_t turned(const Surface& s, const Surface& of, double near) {
    const curve::Locator locator(of);
    std::size_t out = 0;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto& [a, b, c] = s.triangles[t];
        const Vec3 middle = 1.0 / 3 * (s.vertices[a] + s.vertices[b] + s.vertices[c]);
        out += locator.nearest(middle, normal(s, t), near).triangle == kNone ? 1U : 0U;
    }
    return out;
}

TEST(Fit, TrianglesAreAlikeAndFaceAsTheSurfaceDoes) {
    for (const auto& [name, s] : surfaces()) {
        const FittedSurface f = fitted(s, {1, 0.02});
        EXPECT_EQ(f.surface.components, s.components) << name;
        EXPECT_EQ(f.surface.rims.size(), s.rims.size()) << name;
        EXPECT_EQ(turned(f.surface, s, f.off + 1e-9), 0U) << name;
        EXPECT_GT(flattest(f.surface), 0.02) << name;
        EXPECT_LT(longest_edge(f.surface), 1.6) << name;
    }
}

TEST(Fit, TellsHowFarItIsOff) {
    FILUM_NOT_SANITIZED();
    for (const auto& [name, s] : surfaces()) {
        const FittedSurface f = fitted(s, {1, 0.02});
        const double off = std::max(farthest(f.surface, s), farthest(s, f.surface));
        EXPECT_LT(off, 1.15 * f.off + 1e-9) << name;
        EXPECT_LT(f.off, 1.05 * off + 1e-9) << name;
        const auto far = [&](const Surface& from) {
            return distance(f.off_at, curve::Locator(from).nearest(f.off_at).point);
        };
        EXPECT_NEAR(std::max(far(s), far(f.surface)), f.off, 1e-9) << name;
        EXPECT_NEAR(area(f.surface), area(s), 0.01 * area(s)) << name;
        if (name != "ring of few") {
            EXPECT_LT(f.off, 0.02 + 1e-9) << name;
        }
    }
}

TEST(Fit, RimsAndSharpEdgesStay) {
    for (const auto& [name, s] : surfaces()) {
        if (name == "ring of few") continue; // edges of 30 degrees: some are lines, and not when they are cut
        const FittedSurface f = fitted(s, {1, 0.02});
        EXPECT_LT(farthest(lines(s, 30), lines(f.surface, 25)), 0.02 + 1e-9) << name;
        EXPECT_LT(farthest(lines(f.surface, 30), lines(s, 30)), 0.02 + 1e-9) << name;
    }
}

TEST(Fit, AdaptsToBends) {
    const auto bent = [](geom::Vec2 p) { // flat, then round with a radius of 2 mm
        const double a = std::max(0.0, p.x - 10) / 2;
        return geom::Vec3{std::min(p.x, 10.0) + 2 * std::sin(a), p.y, 2 * (1 - std::cos(a))};
    };
    const Surface s = connected(grid(16, 8, 320, 160, bent));
    const auto mean = [](const Surface& of, bool flat) {
        double sum = 0, count = 0;
        for (std::uint32_t h = 0; h < of.twin.size(); ++h) {
            const double x = of.vertices[of.tail(h)].x;
            if (flat ? x > 6 : x < 11.5) continue;
            sum += side_length(of, h);
            count += 1;
        }
        return sum / count;
    };
    const FittedSurface fine = fitted(s, {2, 0.005}), coarse = fitted(s, {2, 0.05});
    EXPECT_GT(mean(fine.surface, true), 1.3);
    EXPECT_LT(mean(fine.surface, false), 0.5);
    EXPECT_GT(mean(coarse.surface, false), 2 * mean(fine.surface, false));
    EXPECT_LT(fine.off, 0.005);
    EXPECT_GT(coarse.off, 0.005);
    EXPECT_LT(coarse.off, 0.05);
    EXPECT_LT(10 * coarse.surface.triangles.size(), s.triangles.size());
}

TEST(Fit, TheGivenTrianglesDecideLittle) {
    const auto flat = [](geom::Vec2 p) { return geom::Vec3{p.x, p.y, 0}; };
    const double wanted = 54 / (std::sqrt(3) / 4);
    for (const int n : {1, 7, 30, 100}) {
        const auto count =
            static_cast<double>(fitted(connected(grid(9, 6, n, n, flat)), {1, 0.02}).surface.triangles.size());
        EXPECT_GT(count, 0.6 * wanted) << n;
        EXPECT_LT(count, 1.7 * wanted) << n;
    }
}

TEST(Fit, IsTheSameEveryTime) {
    const Surface s = connected(scan());
    const FittedSurface a = fitted(s, {1, 0.02}), b = fitted(s, {1, 0.02});
    EXPECT_EQ(a.surface.vertices, b.surface.vertices);
    EXPECT_EQ(a.surface.triangles, b.surface.triangles);
    EXPECT_EQ(a.off, b.off);
}

TEST(Fit, RefusesWhatIsTooFine) { EXPECT_THROW(fitted(connected(box(7, 5, 1)), {1e-4, 1e-4}), Error); }

// Meshes as CAD programs write them: as few triangles as the curves of a face allow, however long and thin.
mesh::Mesh random_cad(std::mt19937& random) {
    const auto within = [&](double lo, double hi) { return lo + (hi - lo) * double(random()) / double(random.max()); };
    const auto n = static_cast<std::uint32_t>(8 * std::pow(200, within(0, 1)));
    const double radius = within(3, 20), length = within(5, 60);
    const std::uint32_t kind = random() % 4;
    mesh::Mesh m;
    const auto on_circle = [&](double z) {
        for (std::uint32_t k = 0; k < n; ++k) {
            const double a = 2 * std::numbers::pi * k / n;
            m.vertices.push_back({radius * std::cos(a), radius * std::sin(a), z});
        }
    };
    on_circle(0);
    if (kind == 0) { // a tube of strips
        on_circle(length);
        for (std::uint32_t k = 0; k < n; ++k) {
            const std::uint32_t j = (k + 1) % n;
            m.triangles.insert(m.triangles.end(), {{k, j, n + j}, {k, n + j, n + k}});
        }
    } else if (kind == 1) { // a disc of triangles round its middle
        m.vertices.push_back({0, 0, 0});
        for (std::uint32_t k = 0; k < n; ++k) m.triangles.push_back({k, (k + 1) % n, n});
    } else if (kind == 2) { // a disc of triangles from one corner
        for (std::uint32_t k = 1; k + 1 < n; ++k) m.triangles.push_back({0, k, k + 1});
    } else { // a face between an edge of many points and one of two
        m.vertices.clear();
        for (std::uint32_t k = 0; k <= n; ++k) m.vertices.push_back({length * k / n, 0, 0});
        m.vertices.insert(m.vertices.end(), {{0, radius, 0}, {length, radius, 0}});
        for (std::uint32_t k = 0; k < n; ++k) m.triangles.push_back({k, k + 1, n + 2});
        m.triangles.push_back({0, n + 2, n + 1});
    }
    return m;
}

// A fan of needles from one far point: halving each of them alone would triple their number at every step.
TEST(Fit, NeedlesSideBySideGrowTogetherBeforeTheyAreHalved) {
    for (const int n : {40, 400}) {
        mesh::Mesh m;
        for (int k = 0; k <= n; ++k) m.vertices.push_back({0, 5.0 * k / n, 0});
        m.vertices.push_back({300, 2, 0});
        for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(n); ++k)
            m.triangles.push_back({k + 1, k, static_cast<std::uint32_t>(n) + 1});
        const FittedSurface f = fitted(connected(m), {0.5, 0.02});
        EXPECT_LT(f.splits, 4 * f.most_splits / kMostWork) << n; // four for each triangle of the result
        EXPECT_NEAR(area(f.surface), 750, 1e-6);
    }
}

TEST(Fit, WorkIsBoundedHoweverLongAndThinTrianglesAre) {
    std::mt19937 random(6);
    const char* many = std::getenv("FILUM_TRIALS");
    const int count = many != nullptr ? std::atoi(many) : trials(12);
    for (int trial = 0; trial < count; ++trial) {
        const Surface s = connected(random_cad(random));
        const Options o{1, 0.02};
        const FittedSurface f = fitted(s, o);
        double longest = 0;
        for (std::uint32_t h = 0; h < s.twin.size(); ++h) longest = std::max(longest, side_length(s, h));
        const double passes = 9 + std::ceil(std::log2(std::max(1.0, longest / (kLeast * o.tolerance))));
        EXPECT_LE(static_cast<double>(f.splits), passes * static_cast<double>(f.most_splits)) << trial;
        EXPECT_LE(f.splits, f.most_splits) << trial; // all passes together stay within the bound of one
        EXPECT_LE(f.surface.triangles.size(), 2 * f.most_splits / kMostWork + 200) << trial;
        EXPECT_LE(f.off, 2 * o.tolerance) << trial;
        EXPECT_NEAR(area(f.surface), area(s), 0.01 * area(s)) << trial;
    }
}

} // namespace
} // namespace filum::surface::fit
