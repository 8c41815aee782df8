#include "infill/cells.hpp"

#include "polygon/clip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace filum::infill {

namespace {

using geom::Vec2;
using polygon::Pattern;

constexpr double kBeyond = 1;     // mm that cells reach beyond the area
constexpr double kNearest = 1.25; // bead widths: nearer lines leave no cell between them
constexpr int kSteps = 32;        // points per wave
constexpr double kWave = 2.4;     // spacings per wave length, see docs/algorithms/infill.md
constexpr double kTau = 2 * std::numbers::pi;

// The box of the points in a frame with the x axis along `along`.
geom::Box2 box_along(const Loops& area, Vec2 along) {
    const Vec2 across = geom::left_of(along);
    geom::Box2 box{{1e300, 1e300}, {-1e300, -1e300}};
    for (const Vec2 p : area.points) {
        const Vec2 q{dot(p, along), dot(p, across)};
        box.lo = {std::min(box.lo.x, q.x), std::min(box.lo.y, q.y)};
        box.hi = {std::max(box.hi.x, q.x), std::max(box.hi.y, q.y)};
    }
    return box;
}

// The positions of rows: one every spacing and, if no gap may be wider than o.gap, others between them. The first and
// last of these keep o.gap / 2 from the rows that continue below and carry them. That distance is at least kNearest
// beads and at most a third of the spacing. The distance between those two is divided evenly by an odd number.
//
// So each spacing has an odd number of steps, and even cells continue in even ones. No two lines are so near that the
// cell between them would be too narrow.
class Ruler {
  public:
    explicit Ruler(const Lines& o) : spacing_(o.spacing) {
        const double least = kNearest * o.bead_width, third = o.spacing / 3;
        at_.push_back(0);
        if (o.gap > 0 && o.spacing > o.gap + o.bead_width && third >= least) {
            const double first = std::min(third, std::max(least, o.gap / 2)), rest = o.spacing - 2 * first;
            const int most = odd_below(rest / least), wanted = odd_above(rest / (o.gap + o.bead_width));
            const int steps = std::max(1, std::min(most, wanted));
            for (int k = 0; k <= steps; ++k) at_.push_back(first + rest * k / steps);
        }
        at_.push_back(o.spacing);
        steps_ = static_cast<double>(at_.size() - 1);
    }
    // The position of line j, mm.
    [[nodiscard]] double place(double j) const {
        const double whole = std::floor(j / steps_);
        return whole * spacing_ + at_[static_cast<std::size_t>(j - whole * steps_)];
    }
    // The inverse of place(), linear between lines.
    [[nodiscard]] double line(double v) const {
        const double whole = std::floor(v / spacing_), rest = v - whole * spacing_;
        const auto next = std::upper_bound(at_.begin() + 1, at_.end() - 1, rest);
        const auto k = static_cast<double>(next - at_.begin() - 1);
        return whole * steps_ + k + (rest - *(next - 1)) / (*next - *(next - 1));
    }

  private:
    static int odd_above(double x) { return 2 * static_cast<int>(std::ceil((x - 1) / 2)) + 1; }
    static int odd_below(double x) { return 2 * static_cast<int>(std::floor((x - 1) / 2)) + 1; }

    double spacing_, steps_ = 1;
    std::vector<double> at_; // positions within one spacing, both ends included
};

Loops even_rows(const Loops& area, const Lines& o) {
    const Vec2 along{std::cos(o.direction), std::sin(o.direction)}, across = geom::left_of(along);
    const auto box = box_along(area, along);
    const Ruler ruler(o);
    Loops out;
    for (double k = 2 * std::floor(ruler.line(box.lo.y) / 2); ruler.place(k) < box.hi.y; k += 2) {
        const double v0 = ruler.place(k), v1 = ruler.place(k + 1), u0 = box.lo.x - kBeyond, u1 = box.hi.x + kBeyond;
        const Vec2 corners[] = {u0 * along + v0 * across, u1 * along + v0 * across, u1 * along + v1 * across,
                                u0 * along + v1 * across};
        out.add(corners);
    }
    return out;
}

// The spacing of even lines with no gap wider than o.gap.
double near_enough(const Lines& o) {
    if (!(o.gap > 0)) return o.spacing;
    const double parts = std::ceil(o.spacing / (o.gap + o.bead_width));
    return o.spacing / (2 * std::floor(parts / 2) + 1); // odd, so that all lines of the plain spacing remain
}

// The cells where sin x cos y + sin y cos z + sin z cos x, a gyroid, is below 0. They are strips that wind along x if
// every line of the layer has one y for each x. Else they wind along y: exchanging the axes keeps the form of the
// equation.
Loops even_waves(const Loops& area, const Lines& o) {
    const double scale = kTau / (kWave * near_enough(o)), z = scale * o.z;
    const bool along_x = std::abs(std::cos(z)) >= std::abs(std::sin(z));
    const auto flat = box_along(area, {1, 0});
    const double t0 = scale * ((along_x ? flat.lo.x : flat.lo.y) - kBeyond);
    const double t1 = scale * ((along_x ? flat.hi.x : flat.hi.y) + kBeyond);
    const double v0 = scale * (along_x ? flat.lo.y : flat.lo.x), v1 = scale * (along_x ? flat.hi.y : flat.hi.x);
    // the two branches of the line at t; the gyroid is below zero between them
    const auto branches = [&](double t) -> Vec2 {
        const double a = along_x ? std::sin(t) : std::sin(z), b = along_x ? std::cos(z) : std::cos(t);
        const double c = along_x ? -std::sin(z) * std::cos(t) : -std::sin(t) * std::cos(z);
        const double middle = std::atan2(b, a), half = std::acos(std::clamp(c / std::hypot(a, b), -1.0, 1.0));
        return {middle + half, middle + kTau - half};
    };
    const auto place = [&](double t, double v) {
        return along_x ? Vec2{t / scale, v / scale} : Vec2{v / scale, t / scale};
    };
    const double step = kTau / kSteps;
    const auto first = static_cast<std::int64_t>(std::floor(t0 / step)),
               last = static_cast<std::int64_t>(std::ceil(t1 / step));
    Loops out;
    for (double k = std::floor(v0 / kTau) - 2; k * kTau < v1 + kTau; ++k) {
        for (std::int64_t i = first; i <= last; ++i) {
            const double t = static_cast<double>(i) * step;
            out.points.push_back(place(t, branches(t).x + k * kTau));
        }
        for (std::int64_t i = last; i >= first; --i) {
            const double t = static_cast<double>(i) * step;
            out.points.push_back(place(t, branches(t).y + k * kTau));
        }
        if (!along_x) std::reverse(out.points.end() - 2 * (last - first + 1), out.points.end());
        out.close();
    }
    return out;
}

// Bands along the rim, from every odd line to the next one. Without further lines (Ruler), line k lies k - 1/2 spacings
// inside the rim. So lines are evenly spaced, with half a spacing between the rim and the first of them.
Loops even_bands(const Lines& o) {
    const Ruler ruler(o);
    const auto inside = [&](double line) {
        return polygon::offset(*o.rim, std::min(0.0, o.spacing / 2 - ruler.place(line)), polygon::kBeadArc);
    };
    Loops out;
    for (double j = 1;; j += 2) { // line 0 lies half a spacing outside the rim
        if (ruler.place(j + 1) <= o.spacing / 2) continue;
        const Loops band = inside(j);
        if (band.empty()) return out;
        const Loops hole = inside(j + 1);
        out.add(hole.empty() ? band : polygon::subtract(band, hole));
    }
}

// The length of the parts of 0 .. u whose floor is even; negative for negative u.
double even_part(double u) {
    const double n = std::floor(u / 2);
    return n + std::min(u - 2 * n, 1.0);
}

double even_length_rows(const Loops& area, const Lines& o) {
    const Vec2 along{std::cos(o.direction), std::sin(o.direction)}, across = geom::left_of(along);
    const Ruler ruler(o);
    double out = 0;
    for (std::size_t l = 0; l < area.size(); ++l) {
        const auto loop = area[l];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec2 p = loop[i], q = loop[i + 1 == loop.size() ? 0 : i + 1];
            const double a = dot(p, across), b = dot(q, across), u = ruler.line(a), v = ruler.line(b);
            const double sign = v > u ? 1 : -1;
            for (double k = std::ceil(std::min(u, v)); k < std::max(u, v); ++k) // line k enters or leaves here
                out += sign * dot(geom::lerp(p, q, (ruler.place(k) - a) / (b - a)), along);
            const double even = v != u ? (even_part(v) - even_part(u)) / (v - u)
                                       : (static_cast<std::int64_t>(std::floor(u)) % 2 == 0 ? 1 : 0);
            out += even * geom::distance(p, q);
        }
    }
    return out;
}

} // namespace

Loops even_cells(const Loops& area, const Lines& o) {
    if (area.empty()) return {}; // an empty area has no box
    if (o.pattern == Pattern::wave) return even_waves(area, o);
    return o.pattern == Pattern::concentric ? even_bands(o) : even_rows(area, o);
}

double even_length(const Loops& area, const Lines& o) {
    if (o.pattern == Pattern::rows) return even_length_rows(area, o);
    const double endless = polygon::signed_area(area) / near_enough(o);
    // on average, waves follow half of the outline
    return o.pattern == Pattern::wave ? endless + length(area) / 2 : endless;
}

} // namespace filum::infill
