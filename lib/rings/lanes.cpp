#include "rings/lanes.hpp"

#include "polygon/clip.hpp"
#include "rings/level.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace filum::rings {

namespace {

constexpr double kLeastShare = 1.0 / 2000; // of a region: in small ones smaller voids count
// Beads are so much wider than their lanes, that no seam opens between them when a machine rounds its numbers.
constexpr double kOverlap = 1.0 / 512;

// A closed bead.
struct Bead {
    std::span<const Vec2> points;
    std::span<const double> width;

    [[nodiscard]] std::size_t size() const { return points.size(); }
};

class Thinning {
  public:
    Thinning(Bead bead, double tolerance, double least) : bead_(bead), tolerance_(tolerance), least_(least) {}

    // Adds the points that stay, moved such that each chord has as much of the line on its left as on its right: beads
    // side by side stay so on average.
    void run(std::vector<Vec2>& points, std::vector<double>& width) const {
        std::vector<std::size_t> kept;
        for (std::size_t a = 0; a < bead_.size(); a = farthest(a)) kept.push_back(a);
        if (kept.size() < 3) kept = {0, bead_.size() / 3, 2 * bead_.size() / 3}; // no line there and back
        const std::size_t n = kept.size();
        std::vector<double> aside(n); // of the line from each chord, to the left, mm
        for (std::size_t k = 0; k < n; ++k) aside[k] = mean_aside(kept[k], k + 1 < n ? kept[k + 1] : bead_.size());
        std::vector<Vec2> moved(n);
        for (std::size_t k = 0; k < n; ++k)
            moved[k] = vertex(kept[(k + n - 1) % n], kept[k], kept[(k + 1) % n], aside[(k + n - 1) % n], aside[k]);
        for (std::size_t k = 0; k < n; ++k) {
            const std::size_t next = (k + 1) % n;
            points.push_back(moved[k]);
            width.push_back(bead_.width[kept[k]]);
            divide(moved[k], moved[next], bead_.width[kept[k]], bead_.width[kept[next]], points, width);
        }
    }

  private:
    // A point that the chord from a may run to; beyond it there is none near by.
    [[nodiscard]] std::size_t farthest(std::size_t a) const {
        std::size_t step = 1;
        while (a + 2 * step <= bead_.size() && within(a, a + 2 * step)) step *= 2;
        std::size_t lo = a + step, hi = std::min(a + 2 * step, bead_.size() + 1); // hi is too far
        while (hi - lo > 1) {
            const std::size_t middle = lo + (hi - lo) / 2;
            (within(a, middle) ? lo : hi) = middle;
        }
        return lo;
    }
    // Whether all points between a and b lie on the chord, and the bead's edges on its.
    [[nodiscard]] bool within(std::size_t a, std::size_t b) const {
        const Vec2 p = bead_.points[a], q = bead_.points[b % bead_.size()];
        const double wa = bead_.width[a], wb = bead_.width[b % bead_.size()], l2 = geom::norm2(q - p);
        for (std::size_t i = a + 1; i < b; ++i) {
            const double off = std::min(tolerance_, bead_.width[i] / 8);
            const double t = l2 > 0 ? std::clamp(dot(bead_.points[i] - p, q - p) / l2, 0.0, 1.0) : 0;
            if (geom::norm2(geom::lerp(p, q, t) - bead_.points[i]) > off * off) return false;
            const double wider = std::min(2 * tolerance_, bead_.width[i] / 16);
            if (std::abs(bead_.width[i] - std::lerp(wa, wb, t)) > wider) return false;
        }
        return true;
    }
    // Mean distance of the line from the chord between a and b, to the left, mm.
    [[nodiscard]] double mean_aside(std::size_t a, std::size_t b) const {
        const Vec2 p = bead_.points[a], q = bead_.points[b % bead_.size()];
        double area = 0;
        for (std::size_t i = a; i < b; ++i)
            area += cross(bead_.points[i] - p, bead_.points[(i + 1) % bead_.size()] - p);
        const double l2 = geom::norm2(q - p);
        return l2 > 0 ? std::clamp(-area / 2 / std::sqrt(l2), -tolerance_, tolerance_) : 0;
    }
    // The point at i for chords from h and to j that are moved aside.
    [[nodiscard]] Vec2 vertex(std::size_t h, std::size_t i, std::size_t j, double before, double after) const {
        const Vec2 p = bead_.points[i], along = bead_.points[j] - bead_.points[h];
        const double l = geom::norm(along);
        return l > 0 ? p + ((before + after) / 2 / l) * geom::left_of(along) : p;
    }
    // Points between a and b where a machine that lays the whole way with one width would lay more than `least_` aside.
    void divide(Vec2 a, Vec2 b, double wa, double wb, std::vector<Vec2>& points, std::vector<double>& width) const {
        const int parts = static_cast<int>(std::ceil(std::sqrt(std::abs(wb - wa) * geom::distance(a, b) / 8 / least_)));
        for (int k = 1; k < parts; ++k) {
            const double t = static_cast<double>(k) / parts;
            points.push_back(geom::lerp(a, b, t));
            width.push_back(std::lerp(wa, wb, t));
        }
    }

    Bead bead_;
    double tolerance_, least_;
};

Rings with_fewer_points(const Rings& all, double tolerance, double least) {
    Rings out;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::size_t first = all.start[i], n = all.start[i + 1] - first;
        Thinning({{all.points.data() + first, n}, {all.width.data() + first, n}}, tolerance, least)
            .run(out.points, out.width);
        out.start.push_back(static_cast<std::uint32_t>(out.points.size()));
        out.lane.push_back(all.lane[i]);
    }
    return out;
}

} // namespace

FirstLanes first_lanes(const Loops& region, const LaneOptions& o) {
    const double area = polygon::signed_area(region), width = o.width * (1 - kOverlap);
    const double flows = kLeastVoid * width * width, least = std::min(flows, kLeastShare * area);
    const double fine = o.tolerance / 4;
    const Beading b = beading(medial_axis(sites_of(region, o.tolerance / 2), fine, kWallSlope), width, least);
    FirstLanes out{with_fewer_points(rings(b, o.most, flows, fine), fine, least), {}};
    for (double& w : out.lanes.width) w /= 1 - kOverlap;
    if (o.most > 0) out.rest = polygon::split(beyond(b, o.most, fine)).part;
    std::erase_if(out.rest, [&](const Loops& part) { return polygon::signed_area(part) <= flows; });
    return out;
}

Rings lanes(const Loops& region, const LaneOptions& o) { return first_lanes(region, o).lanes; }

std::vector<toolpath::Curve> curves_of(const Rings& rings) {
    std::vector<toolpath::Curve> out;
    for (std::size_t i = 0; i < rings.size(); ++i)
        out.push_back({true,
                       {rings.points.begin() + rings.start[i], rings.points.begin() + rings.start[i + 1]},
                       {rings.width.begin() + rings.start[i], rings.width.begin() + rings.start[i + 1]}});
    return out;
}

double laid_area(const Rings& rings) {
    double out = 0;
    for (std::size_t r = 0; r < rings.size(); ++r)
        for (std::uint32_t i = rings.start[r]; i < rings.start[r + 1]; ++i) {
            const std::uint32_t j = i + 1 == rings.start[r + 1] ? rings.start[r] : i + 1;
            out += (rings.width[i] + rings.width[j]) / 2 * geom::distance(rings.points[i], rings.points[j]);
        }
    return out;
}

toolpath::Curve with_fewer_points(const toolpath::Curve& bead, double tolerance, double least_void) {
    toolpath::Curve out{bead.closed, {}, {}};
    Thinning({bead.points, bead.width}, tolerance, least_void).run(out.points, out.width);
    return out;
}

} // namespace filum::rings
