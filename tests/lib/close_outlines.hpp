// Random regions whose outlines have parts that are collinear, nearly collinear, coincident or nearly so.
#pragma once

#include "polygon/clip.hpp"
#include "polygon/simple.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace filum::test {

// Coordinates are whole grid units of 0.1 um until the loops are made.
class CloseOutlines {
  public:
    explicit CloseOutlines(unsigned seed) : random_(seed) {}

    // The connected parts of one random area.
    std::vector<polygon::Loops> regions() {
        polygon::Loops area = outline();
        for (int more = below(3); more > 0; --more) {
            const polygon::Loops other = outline();
            area = below(2) == 0 ? polygon::unite(area, other) : polygon::subtract(area, other);
        }
        area = polygon::unite(area);
        return area.empty() ? std::vector<polygon::Loops>{} : polygon::split(area).part;
    }

  private:
    struct Point {
        std::int64_t x, y;
    };

    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    double uniform(double lo, double hi) { return lo + (hi - lo) * (static_cast<double>(random_()) / 4294967296.0); }

    polygon::Loops outline() {
        if (size_ == 0) size_ = std::pow(10, uniform(3.5, 6.5)); // 0.3 mm to 300 mm
        std::vector<Point> p = below(2) == 0 ? on_lattice() : star();
        if (below(2) == 0) turn(p);
        if (below(2) == 0) p = with_points_on_edges(p);
        if (below(2) == 0) p = with_near_touch(p);
        if (below(3) == 0) shake(p);
        polygon::Loops out;
        for (const Point& q : p)
            out.points.push_back(
                {static_cast<double>(q.x) / polygon::kGridPerMm, static_cast<double>(q.y) / polygon::kGridPerMm});
        out.close();
        return polygon::unite(out, polygon::Fill::even_odd);
    }

    // Few corners on few places: many are collinear, edges coincide.
    std::vector<Point> on_lattice() {
        const int side = 2 + below(7);
        const auto pitch = static_cast<std::int64_t>(std::max(1.0, size_ / side));
        std::vector<Point> p(static_cast<std::size_t>(3 + below(12)));
        for (Point& q : p) q = {pitch * below(side + 1), pitch * below(side + 1)};
        return p;
    }
    std::vector<Point> star() {
        const int n = 3 + below(14);
        std::vector<Point> p;
        for (int k = 0; k < n; ++k) {
            const double a = 2 * std::numbers::pi * k / n, r = size_ / 2 * (1 + below(3)) / 3;
            p.push_back(rounded(size_ / 2 + r * std::cos(a), size_ / 2 + r * std::sin(a)));
        }
        return p;
    }
    static Point rounded(double x, double y) { return {std::llround(x), std::llround(y)}; }

    void turn(std::vector<Point>& p) {
        const double a = uniform(0, 2 * std::numbers::pi);
        for (Point& q : p) {
            const auto x = static_cast<double>(q.x), y = static_cast<double>(q.y);
            q = rounded(x * std::cos(a) - y * std::sin(a), x * std::sin(a) + y * std::cos(a));
        }
    }
    void shake(std::vector<Point>& p) {
        for (Point& q : p) q = {q.x + below(3) - 1, q.y + below(3) - 1};
    }
    // Adds corners to the edges.  They lie on the edge up to rounding to the grid; some are moved aside by one grid
    // unit.
    std::vector<Point> with_points_on_edges(const std::vector<Point>& p) {
        std::vector<Point> out;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Point a = p[i], b = p[(i + 1) % p.size()];
            out.push_back(a);
            std::vector<double> at(static_cast<std::size_t>(below(4)));
            for (double& t : at) t = uniform(0, 1);
            std::sort(at.begin(), at.end());
            for (const double t : at)
                out.push_back(rounded(static_cast<double>(a.x) + t * static_cast<double>(b.x - a.x) + below(3) - 1,
                                      static_cast<double>(a.y) + t * static_cast<double>(b.y - a.y)));
        }
        return out;
    }
    // A tooth from one corner to a point as near to another edge as the grid allows: 1 / length grid units.
    std::vector<Point> with_near_touch(const std::vector<Point>& p) {
        const std::size_t e = random_() % p.size(), at = random_() % p.size();
        const Point a = p[e], b = p[(e + 1) % p.size()];
        std::int64_t dx = b.x - a.x, dy = b.y - a.y;
        const std::int64_t common = std::gcd(dx, dy);
        if (common == 0) return p;
        dx /= common;
        dy /= common;
        // u, v with |dx v - dy u| = 1, by Euclid.
        std::int64_t r0 = dx, r1 = dy, s0 = 1, s1 = 0, t0 = 0, t1 = 1;
        while (r1 != 0) {
            const std::int64_t q = r0 / r1;
            r0 = std::exchange(r1, r0 - q * r1);
            s0 = std::exchange(s1, s0 - q * s1);
            t0 = std::exchange(t1, t0 - q * t1);
        }
        const std::int64_t sign = below(2) == 0 ? 1 : -1, u = -sign * t0, v = sign * s0;
        const std::int64_t along = common < 2 ? 0 : static_cast<std::int64_t>(random_()) % common;
        const Point tip{a.x + u + along * dx, a.y + v + along * dy};
        std::vector<Point> out = p;
        const Point from = p[at], next{from.x + 1 + below(20000), from.y + below(20000)};
        out.insert(out.begin() + static_cast<std::ptrdiff_t>(at) + 1, {tip, next});
        return out;
    }

    std::mt19937 random_;
    double size_ = 0;
};

// How many random areas a test takes: few, or as many as the environment variable FILUM_OUTLINES says.
inline unsigned outlines(unsigned few) {
    const char* many = std::getenv("FILUM_OUTLINES");
    return many == nullptr ? few : static_cast<unsigned>(std::atoi(many));
}
// The first of them; FILUM_FIRST_OUTLINE.
inline unsigned first_outline() {
    const char* first = std::getenv("FILUM_FIRST_OUTLINE");
    return first == nullptr ? 0 : static_cast<unsigned>(std::atoi(first));
}

} // namespace filum::test
