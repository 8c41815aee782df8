#include "surfpath/seed_side.hpp"

#include "geodesic/isolines.hpp"
#include "geodesic/query.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surfpath {

using geom::Vec3;
using surface::Isoline;
using surface::kNone;
using surface::Surface;

FarRim far_rim(const Surface& s, const SeedSides& sides, std::uint32_t side, std::span<const double> distance,
               double spacing) {
    double far = 0;
    FarRim out;
    for (int round = 0; round < 2; ++round)
        for (const auto& rim : s.rims)
            for (const std::uint32_t h : rim.sides) {
                const double a = distance[s.tail(h)], b = distance[s.head(h)], c = distance[s.tail(surface::prev(h))];
                const Vec3 &p = s.vertices[s.tail(h)], &q = s.vertices[s.head(h)];
                const double l = geom::distance(p, q), mid = (a + b) / 2;
                if (sides.of[h / 3] != side || !(std::abs(a - b) <= rules::kAlong * l) || !(c < mid)) continue;
                if (round == 0)
                    far = std::max(far, mid);
                else if (mid > far - 1.5 * spacing) {
                    out.rim.segments.push_back({h / 3, p, q});
                    out.mean += l * mid;
                    out.length += l;
                }
            }
    if (out.length > 0) out.mean /= out.length;
    return out;
}

namespace {

// Determines the side on which an isoline lies. If the isoline only runs through triangles that contain the seed, the
// side is that of a corner which lies on the same side of the seed segment.
class SideClassifier {
  public:
    SideClassifier(const Surface& s, const SeedSides& sides, const surface::Sources& seed)
        : surface_(s), sides_(sides), at_(s.vertices.size(), kNone) {
        for (std::uint32_t t = 0; t < s.triangles.size(); ++t)
            if (sides.of[t] != kNone)
                for (const std::uint32_t v : s.triangles[t]) at_[v] = sides.of[t];
        for (const auto& g : seed.segments)
            if (g.triangle < s.triangles.size()) seed_.push_back(g);
        std::stable_sort(seed_.begin(), seed_.end(), by_triangle);
    }

    [[nodiscard]] std::uint32_t operator()(const Isoline& line) const {
        std::vector<std::uint32_t> count(sides_.count, 0);
        for (const std::uint32_t t : line.triangles)
            if (sides_.of[t] != kNone) ++count[sides_.of[t]];
        if (std::all_of(count.begin(), count.end(), [](std::uint32_t n) { return n == 0; }))
            for (std::size_t i = 0; i < line.triangles.size(); ++i)
                if (const auto side = beside_seed(line.triangles[i], line.points[i]); side != kNone) ++count[side];
        const auto most = std::max_element(count.begin(), count.end());
        return most == count.end() || *most == 0 ? kNone : static_cast<std::uint32_t>(most - count.begin());
    }

  private:
    static bool by_triangle(const surface::Segment& a, const surface::Segment& b) { return a.triangle < b.triangle; }

    [[nodiscard]] std::uint32_t beside_seed(std::uint32_t t, const Vec3& p) const {
        const auto g = std::lower_bound(seed_.begin(), seed_.end(), surface::Segment{t, {}, {}}, by_triangle);
        if (g == seed_.end() || g->triangle != t) return kNone;
        const Vec3 across = cross(surface::normal(surface_, t), g->b - g->a);
        for (const std::uint32_t v : surface_.triangles[t])
            if (at_[v] != kNone && dot(across, surface_.vertices[v] - g->a) * dot(across, p - g->a) > 0) return at_[v];
        return kNone;
    }

    const Surface& surface_;
    const SeedSides& sides_;
    std::vector<std::uint32_t> at_; // per vertex: the side of a triangle there
    std::vector<surface::Segment> seed_;
};

// The distance from the seed, divided by the sum of the distances from seed and far rim, times the mean distance
// between these: its level sets adapt gradually from the seed to the far rim.
class BlendedDistance {
  public:
    BlendedDistance(const Surface& s, const geodesic::ExactField& seed, const geodesic::ExactField& end, double mean)
        : surface_(s), seed_(seed), end_(end), mean_(mean) {
        for (std::size_t v = 0; v < s.vertices.size(); ++v) value_.push_back(share(seed.distance[v], end_.distance[v]));
    }

    // Whether level sets at equal steps are about equally far apart everywhere on the side.
    [[nodiscard]] bool even(const SeedSides& sides, std::uint32_t side) const {
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
            if (sides.of[t] == side)
                for (const std::uint32_t v : surface_.triangles[t])
                    if (std::abs(seed_.distance[v] + end_.distance[v] - mean_) > rules::kGive * mean_) return false;
        return true;
    }

    [[nodiscard]] std::vector<Isoline> lines(std::span<const double> levels) const {
        const geodesic::Inside at = [&](std::uint32_t t, const Vec3& p) { return this->at(t, p); };
        auto out = geodesic::isolines(
            surface_, value_, levels,
            [&](std::uint32_t h, double level, std::vector<double>& x) { cross(h, level, x); }, at);
        for (Isoline& line : out) geodesic::refine(surface_, line, at, rules::kOff);
        return out;
    }

  private:
    [[nodiscard]] double share(double a, double b) const { return a + b > 0 ? mean_ * a / (a + b) : 0; }

    [[nodiscard]] double at(std::uint32_t t, const Vec3& p) const {
        return share(geodesic::distance_at(surface_, seed_, t, p), geodesic::distance_at(surface_, end_, t, p));
    }

    // Where an edge crosses the level, by regula falsi (Illinois).
    void cross(std::uint32_t h, double level, std::vector<double>& out) const {
        out.clear();
        const Vec3 &a = surface_.vertices[surface_.tail(h)], &b = surface_.vertices[surface_.head(h)];
        double fa = value_[surface_.tail(h)] - level, fb = value_[surface_.head(h)] - level, x0 = 0, x1 = 1, x = 0;
        if ((fa < 0) == (fb < 0)) return;
        for (int i = 0, last = 0; i < 20; ++i) {
            x = x0 + fa / (fa - fb) * (x1 - x0);
            const double f = at(h / 3, a + x * (b - a)) - level;
            if (std::abs(f) < rules::kTiny) break;
            if ((f < 0) == (fa < 0)) {
                x0 = x;
                fa = f;
                if (last == 1) fb /= 2;
                last = 1;
            } else {
                x1 = x;
                fb = f;
                if (last == 2) fa /= 2;
                last = 2;
            }
        }
        out.push_back(std::clamp(x, 1e-9, 1 - 1e-9) * geom::distance(a, b));
    }

    const Surface& surface_;
    const geodesic::ExactField &seed_, &end_;
    double mean_;
    std::vector<double> value_;
};

} // namespace

double step(const FarRim& rim, double spacing) {
    const double d = rim.mean / std::max(1.0, std::round(rim.mean / spacing));
    return rim.length >= rules::kBeside * spacing && std::abs(d / spacing - 1) <= rules::kGive ? d : 0;
}

std::vector<double> levels(double end, double step) {
    std::vector<double> out;
    for (double i = 0; (i + 0.5) * step < end; ++i) out.push_back((i + 0.5) * step);
    return out;
}

SeedSides seed_sides(const Surface& s, const surface::Sources& seed) {
    std::vector<char> on_seed(s.triangles.size(), 0);
    for (const auto& g : seed.segments) on_seed[g.triangle] = 1;
    SeedSides out{std::vector<std::uint32_t>(s.triangles.size(), kNone), 0};
    std::vector<std::uint32_t> stack;
    for (std::uint32_t first = 0; first < s.triangles.size(); ++first) {
        if (on_seed[first] || out.of[first] != kNone) continue;
        stack.assign(1, first);
        out.of[first] = out.count;
        while (!stack.empty()) {
            const std::uint32_t t = stack.back();
            stack.pop_back();
            for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
                const std::uint32_t twin = s.twin[h];
                if (twin == kNone || on_seed[twin / 3] || out.of[twin / 3] != kNone) continue;
                out.of[twin / 3] = out.count;
                stack.push_back(twin / 3);
            }
        }
        ++out.count;
    }
    return out;
}

std::vector<std::vector<Isoline>> side_rows(const Surface& s, const Surface& closed, const geodesic::ExactField& field,
                                            const surface::Sources& seed, double spacing, bool fitted) {
    const SeedSides sides = seed_sides(s, seed);
    std::vector<double> tip(sides.count, 0);
    for (std::size_t t = 0; t < s.triangles.size(); ++t)
        if (const std::uint32_t side = sides.of[t]; side != kNone)
            for (const std::uint32_t v : s.triangles[t])
                if (std::isfinite(field.distance[v])) tip[side] = std::max(tip[side], field.distance[v]);
    std::vector<FarRim> rims;
    // of all sides, because a field per side would cost a propagation each; the nearest one counts
    surface::Sources ends;
    for (std::uint32_t side = 0; side < sides.count; ++side) {
        rims.push_back(fitted ? far_rim(s, sides, side, field.distance, spacing) : FarRim{});
        const auto& rim = rims.back().rim.segments;
        if (step(rims.back(), spacing) > 0) ends.segments.insert(ends.segments.end(), rim.begin(), rim.end());
    }
    const auto end = ends.empty() ? geodesic::ExactField{} : geodesic::exact(closed, ends);
    const SideClassifier side_of(s, sides, seed);
    std::vector<std::vector<Isoline>> out(sides.count);
    for (std::uint32_t side = 0; side < sides.count; ++side) {
        const double d = step(rims[side], spacing);
        if (d > 0)
            if (const BlendedDistance between(s, field, end, rims[side].mean); between.even(sides, side))
                out[side] = between.lines(levels(rims[side].mean, d));
        if (out[side].empty()) out[side] = geodesic::isolines(s, field, levels(tip[side], d > 0 ? d : spacing));
        std::erase_if(out[side], [&](const Isoline& l) { return side_of(l) != side; });
    }
    return out;
}

} // namespace filum::surfpath
