#include "surfpath/fexa.hpp"

#include "base/error.hpp"
#include "geodesic/isolines.hpp"
#include "surfpath/rows/boustrophedon.hpp"
#include "surfpath/rows/winding.hpp"
#include "surfpath/rules/rules.hpp"
#include "surfpath/seed_side.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surfpath {

namespace {

// the seed is a straight line if it deviates from one by less than this share of its size
constexpr double kStraight = 1e-4;
constexpr double kSteepest = 20; // largest 1 / slope: the surface is almost parallel to the plane there

// Change of height per mm along the triangle.
double slope(const Surface& s, std::uint32_t t, std::span<const double> height) {
    const auto& [a, b, c] = s.triangles[t];
    const Vec3 &p = s.vertices[a], u = s.vertices[b] - p, v = s.vertices[c] - p, n = cross(u, v);
    return norm(1 / dot(n, n) * cross(n, (height[c] - height[a]) * u - (height[b] - height[a]) * v));
}

// Converts between the height above the plane and the distance along the surface from the plane, averaged over the
// section of the surface at each height.
class HeightScale {
  public:
    HeightScale(const Surface& s, const SeedSides& sides, std::uint32_t side, std::span<const double> height,
                double spacing)
        : bin_(rules::kGrain * spacing) {
        std::vector<double> rise, length;
        for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
            if (sides.of[t] != side) continue;
            const auto& [a, b, c] = s.triangles[t];
            const auto [lo, hi] = std::minmax({height[a], height[b], height[c]});
            const double steep = std::min(kSteepest, 1 / std::max(1e-9, slope(s, t, height)));
            // The triangle's sections have a mean length of its area divided by its extent across them.
            const auto first = static_cast<std::size_t>(std::max(0.0, lo / bin_));
            const auto last = static_cast<std::size_t>(std::max(0.0, hi / bin_));
            if (last >= rise.size()) {
                rise.resize(last + 1, 0);
                length.resize(last + 1, 0);
            }
            const double share = surface::area(s, t) / static_cast<double>(last - first + 1);
            for (std::size_t i = first; i <= last; ++i) {
                rise[i] += share;
                length[i] += share / steep;
            }
        }
        way_.push_back(0);
        double ratio = 1;
        for (std::size_t i = 0; i < rise.size(); ++i) {
            if (length[i] > 0) ratio = rise[i] / length[i];
            way_.push_back(way_.back() + bin_ * ratio);
        }
    }

    [[nodiscard]] double distance(double height) const {
        const double x = std::clamp(height / bin_, 0.0, static_cast<double>(way_.size() - 1));
        const auto i = std::min(static_cast<std::size_t>(x), way_.size() - 2);
        return way_[i] + (x - static_cast<double>(i)) * (way_[i + 1] - way_[i]);
    }

    [[nodiscard]] double height(double distance) const {
        const auto after = std::upper_bound(way_.begin(), way_.end(), distance);
        const auto i =
            std::clamp<std::ptrdiff_t>(after - way_.begin(), 1, static_cast<std::ptrdiff_t>(way_.size() - 1));
        const double a = way_[static_cast<std::size_t>(i - 1)], b = way_[static_cast<std::size_t>(i)];
        return bin_ * (static_cast<double>(i - 1) + (b > a ? (distance - a) / (b - a) : 0));
    }

  private:
    double bin_;
    std::vector<double> way_; // mm along the surface, per height in steps of bin_
};

// The area on which rows are farther apart than the spacing may change, because the surface is almost parallel to the
// plane there.
struct RowGaps {
    double area = 0, most = 0; // mm2; the greatest distance of rows, in spacings
    Vec3 at;                   // a vertex where rows are farthest apart
};
void find_gaps(const Surface& s, const SeedSides& sides, std::uint32_t side, std::span<const double> height,
               const HeightScale& spread, double spacing, RowGaps& out) {
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        if (sides.of[t] != side) continue;
        const auto& [a, b, c] = s.triangles[t];
        const double way = spread.distance((height[a] + height[b] + height[c]) / 3);
        const double rise = spread.height(way + spacing / 2) - spread.height(std::max(0.0, way - spacing / 2));
        const double gap = rise / std::max(1e-9, slope(s, t, height)) / spacing;
        if (gap <= 1 + rules::kGive) continue;
        out.area += surface::area(s, t);
        if (gap > out.most) {
            out.most = gap;
            out.at = s.vertices[a];
        }
    }
}

} // namespace

surface::Plane plane_of(const Surface& s, const surface::Sources& seed) {
    if (seed.segments.empty())
        throw Error(Exit::bad_input, "needs a seed curve; run geodesic --source plane:NX,NY,NZ,D first");
    const Vec3 a = seed.segments.front().a;
    Vec3 b = a, upright, best;
    double far = 0, most = 0;
    for (const auto& g : seed.segments) {
        upright = upright + distance(g.a, g.b) * surface::normal(s, g.triangle);
        for (const Vec3& p : {g.a, g.b})
            if (distance(a, p) > far) {
                far = distance(a, p);
                b = p;
            }
    }
    for (const auto& g : seed.segments)
        for (const Vec3& p : {g.a, g.b})
            if (const Vec3 n = cross(b - a, p - a); norm(n) > most) {
                most = norm(n);
                best = n;
            }
    if (!(most > kStraight * far * far)) best = cross(b - a, upright);
    if (!(norm(best) > 0)) throw Error(Exit::bad_input, "the seed curve has no direction");
    const Vec3 n = 1 / norm(best) * best;
    for (const auto& g : seed.segments)
        for (const Vec3& p : {g.a, g.b})
            if (std::abs(dot(n, p - a)) > rules::kSamePoint * std::max(1.0, far))
                throw Error(Exit::bad_input,
                            "the seed curve is not in a plane; run geodesic --source plane:NX,NY,NZ,D first");
    return {n, dot(n, a)};
}

Plan fexa(const surface::Sheet& sheet, const Options& o) {
    const Surface& s = sheet.surface;
    const auto height = surface::sides(s, o.plane ? *o.plane : plane_of(s, sheet.sources));
    SeedSides sides{std::vector<std::uint32_t>(s.triangles.size()), 2};
    for (std::size_t t = 0; t < s.triangles.size(); ++t) {
        const auto& [a, b, c] = s.triangles[t];
        sides.of[t] = height[a] + height[b] + height[c] >= 0 ? 0 : 1;
    }
    std::vector<rows::UnclippedLine> raw;
    RowGaps gaps;
    for (std::uint32_t side = 0; side < 2; ++side) {
        const double sign = side == 0 ? 1 : -1;
        std::vector<double> above(height), way;
        for (double& h : above) h *= sign;
        const HeightScale spread(s, sides, side, above, o.spacing);
        for (const double h : above) way.push_back(h > 0 ? spread.distance(h) : h);
        const FarRim rim = far_rim(s, sides, side, way, o.spacing);
        const double d = step(rim, o.spacing), end = *std::max_element(way.begin(), way.end());
        std::vector<double> at = levels(end, d > 0 ? d : o.spacing);
        for (double& level : at) level = spread.height(level);
        add(raw, geodesic::isolines(s, above, at), sign);
        find_gaps(s, sides, side, above, spread, d > 0 ? d : o.spacing, gaps);
    }
    rows::leave_out(raw, o.beyond);
    rows::TurnOptions turns = rows::turn_options(o.spacing, o.least_radius, o.turns == RowTurns::hairpin);
    turns.staggered = o.beyond.empty();
    rows::Rows all =
        rows::rows(s, raw, {o.spacing / 2, 2 * turns.least_radius, turns.least_radius, rules::kMostGive * o.spacing});
    rows::wind(s, all, o.spacing, true);
    Plan out = rows::boustrophedon(s, all, turns);
    if (gaps.area > 0) out.notes.push_back({NoteCode::rows_apart, gaps.area, 1, -1, gaps.at.x, gaps.at.y, gaps.at.z});
    return out;
}

} // namespace filum::surfpath
