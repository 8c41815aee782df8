#include "laminate/thickness.hpp"

#include "geom/angle.hpp"
#include "parallel/parallel.hpp"
#include "surface/curve/line.hpp"
#include "surface/directions/rosy.hpp"
#include "surfpath/stretches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace filum::laminate {

namespace {

using surfpath::Stretch;
using surfpath::Stretches;

constexpr double kPart = 1.0 / 3;     // of a bead's width, between points
constexpr std::size_t kPoints = 1024; // of a piece of work
constexpr double kHundredth = 0.01;
constexpr double kAlong = 15; // degrees: what is farther off turns
constexpr double kFar = std::numeric_limits<double>::infinity();

std::vector<double> areas(const Surface& s) {
    std::vector<double> out(s.vertices.size(), 0);
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t)
        for (const std::uint32_t v : s.triangles[t]) out[v] += surface::area(s, t) / 3;
    return out;
}

// Points of one surface carried to another of the same vertices and triangles.
class Carried {
  public:
    Carried(const Surface& base, const surface::Finer& finer) : at_(finer.surface.vertices.size()) {
        for (std::uint32_t t = 0; t < finer.parent.size(); ++t)
            for (const std::uint32_t v : finer.surface.triangles[t])
                at_[v] = weights(base, finer.parent[t], finer.surface.vertices[v]);
    }
    [[nodiscard]] Vec3 point(const Surface& to, std::size_t v) const {
        const auto& c = at_[v].corners;
        const auto& w = at_[v].weight;
        return w[0] * to.vertices[c[0]] + w[1] * to.vertices[c[1]] + w[2] * to.vertices[c[2]];
    }
    [[nodiscard]] std::uint32_t triangle(std::size_t v) const { return at_[v].triangle; }

  private:
    struct At {
        std::uint32_t triangle = 0;
        surface::Triangle corners{}; // of the base; a surface that is turned over has them in another order
        std::array<double, 3> weight{};
    };
    static At weights(const Surface& s, std::uint32_t t, const Vec3& p) {
        const auto& c = s.triangles[t];
        const Vec3 n = cross(s.vertices[c[1]] - s.vertices[c[0]], s.vertices[c[2]] - s.vertices[c[0]]);
        At out{t, c, {}};
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 &a = s.vertices[c[(k + 1) % 3]], &b = s.vertices[c[(k + 2) % 3]];
            out.weight[k] = dot(cross(a - p, b - p), n) / norm2(n);
        }
        return out;
    }
    std::vector<At> at_;
};

// The direction asked for where the surface's normal is `n`; none where the reference stands upright.
std::optional<Vec3> asked(const Laid& ply, const Vec3& n) {
    constexpr double kUpright = 1e-6; // of its length: what is left of it says nothing
    const auto z = surface::directions::doubled(ply.reference, n);
    if (!(std::abs(z) > kUpright * norm2(ply.reference))) return std::nullopt;
    return surface::directions::direction(std::polar(1.0, 2 * ply.turn) * z, n);
}

double degrees_between(const Vec3& a, const Vec3& b) {
    const double angle = geom::angle(a, b);
    return geom::degrees(std::min(angle, geom::kDegree * 180 - angle));
}

// Of stretches that are not turns, how far each is off what is asked; nan where nothing is, or of a turn.
std::vector<double> off_asked(const Laid& ply, std::span<const Stretch> all) {
    const auto normals = surface::curve::vertex_normals(ply.ground);
    std::vector<double> out;
    out.reserve(all.size());
    std::size_t i = 0;
    for (const auto& stroke : ply.plan.strokes)
        for (const auto& piece : stroke.pieces)
            for (std::size_t k = 0; k + 1 < piece.line.size(); ++k, ++i) {
                const Vec3 n = surface::curve::normal_at(ply.ground, normals, piece.line.places[k]);
                const Vec3 way = all[i].b - all[i].a, flat = way - dot(way, n) * n; // chords of facets leave the plane
                const auto to = asked(ply, n);
                out.push_back(piece.hairpin || !to || !(norm(flat) > 0) ? std::nan("") : degrees_between(flat, *to));
            }
    return out;
}

// A bead near a point: where along all paths, and how much of what the point stands for lies under it.
struct Over {
    double way = 0, share = 0;
};

// How many beads lie over a point: places that are more than a width of way apart count each, by the greatest share.
double passes(std::vector<Over>& found, double width) {
    std::sort(found.begin(), found.end(), [](const Over& a, const Over& b) { return a.way < b.way; });
    double sum = 0, most = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        most = std::max(most, found[i].share);
        if (i + 1 < found.size() && found[i + 1].way - found[i].way <= width) continue;
        sum += most;
        most = 0;
    }
    return sum;
}

PlyMap map_of(const Laid& ply, const Carried& carried, std::size_t points, int threads) {
    const Stretches lines(ply.ground, ply.plan);
    const auto off = off_asked(ply, lines.all());
    PlyMap out{
        std::vector<double>(points, 0), {}, std::vector<double>(points, kFar), std::vector<double>(points, ply.width)};
    parallel::for_chunks(points, kPoints, threads, [&](std::size_t begin, std::size_t end) {
        std::vector<Over> found;
        for (std::size_t v = begin; v < end; ++v) {
            found.clear();
            double least = 1.5 * ply.width;
            const Vec3 n = surface::normal(ply.ground, carried.triangle(v));
            lines.near(carried.point(ply.ground, v), n, least, [&](const Stretch& l, double d, double way) {
                const double share =
                    (ply.width / 2 - d) / (kPart * ply.width) + 0.5; // a point is as wide as to the next
                if (share > 0) found.push_back({way, std::min(1.0, share)});
                if (!(d < least)) return;
                least = d;
                const double angle = off[static_cast<std::size_t>(&l - lines.all().data())];
                out.deviation[v] = std::isnan(angle) ? kFar : angle;
            });
            out.clearance[v] = least - ply.width / 2;
            out.passes[v] = passes(found, ply.width);
        }
    });
    return out;
}

// Values averaged over what is within `reach` mm, by area.
std::vector<double> averaged(const Surface& s, std::span<const double> area, std::span<const double> values,
                             double reach, int threads) {
    std::vector<geom::Box3> boxes;
    boxes.reserve(values.size());
    for (const Vec3& p : s.vertices) boxes.push_back({p, p});
    const geom::Bvh tree(boxes);
    const auto normals = surface::curve::vertex_normals(s);
    std::vector<double> out(values.size());
    parallel::for_chunks(values.size(), kPoints, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            double sum = 0, weight = 0;
            tree.visit(geom::grown({s.vertices[v], s.vertices[v]}, reach), [&](std::uint32_t k) {
                if (distance(s.vertices[k], s.vertices[v]) > reach || !(dot(normals[k], normals[v]) > 0)) return;
                sum += area[k] * values[k];
                weight += area[k];
            });
            out[v] = sum / weight;
        }
    });
    return out;
}

Spread spread_by_weight(std::vector<std::pair<double, double>> all) {
    if (all.empty()) return {};
    const double low = surface::directions::percentile(all, kHundredth);
    const double median = surface::directions::percentile(all, 0.5);
    const double high = surface::directions::percentile(all, 1 - kHundredth);
    double sum = 0, total = 0;
    for (const auto& [value, weight] : all) {
        sum += weight * value;
        total += weight;
    }
    const auto [least, most] = std::minmax_element(all.begin(), all.end());
    return {sum / total, least->first, low, median, high, most->first};
}

} // namespace

Map map(const Surface& base, std::span<const Laid> plies, int threads) {
    double width = kFar;
    for (const Laid& p : plies) width = std::min(width, p.width);
    Map out{surface::finer(base, kPart * width), {}, {}, {}, {}};
    const Surface& s = out.ground.surface;
    out.area = areas(s);
    out.thickness.assign(s.vertices.size(), 0);
    out.even.assign(s.vertices.size(), 0);
    const Carried carried(base, out.ground);
    for (const Laid& ply : plies) {
        out.plies.push_back(map_of(ply, carried, s.vertices.size(), threads));
        PlyMap& now = out.plies.back();
        now.amount = averaged(s, out.area, now.passes, ply.width, threads);
        for (std::size_t v = 0; v < s.vertices.size(); ++v) {
            out.thickness[v] += ply.height * now.passes[v];
            out.even[v] += ply.height * now.amount[v];
        }
    }
    return out;
}

Spread spread_of(std::span<const double> values, std::span<const double> area) {
    std::vector<std::pair<double, double>> all;
    for (std::size_t v = 0; v < values.size(); ++v)
        if (std::isfinite(values[v])) all.emplace_back(values[v], area[v]);
    return spread_by_weight(std::move(all));
}

Deviation deviation(const Laid& ply) {
    const Stretches lines(ply.ground, ply.plan);
    const auto off = off_asked(ply, lines.all());
    std::vector<std::pair<double, double>> all;
    double near = 0, total = 0;
    for (std::size_t i = 0; i < off.size(); ++i) {
        if (std::isnan(off[i])) continue;
        const double length = distance(lines.all()[i].a, lines.all()[i].b);
        all.emplace_back(off[i], length);
        total += length;
        near += off[i] <= kAlong ? length : 0;
    }
    return {spread_by_weight(std::move(all)), total > 0 ? near / total : 0};
}

} // namespace filum::laminate
