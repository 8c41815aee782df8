#include "metrics/surface/map.hpp"

#include "geom/angle.hpp"
#include "geom/bvh.hpp"
#include "geom/segment.hpp"
#include "metrics/surface/ground.hpp"
#include "metrics/surface/load.hpp"
#include "parallel/parallel.hpp"
#include "surface/curve/walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace filum::metrics::surface {

namespace {

using filum::surface::curve::Locator;
using filum::surface::curve::Place;

constexpr double kPart = 1.0 / 3;     // of a bead's width: greatest distance of points
constexpr std::size_t kPoints = 1024; // points per task of a thread
constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr double kUpright = 1e-6; // of the reference's length: a shorter projection has no direction

// A straight segment of a ply.
struct Bead {
    Vec3 a, b, normal; // its ends; from the surface to the tool, (0, 0, 0) if unknown
    double way = 0;    // mm from the start of the path, with 1 km between chains
    double width = 0, height = 0;
    double off = kEndless; // degrees from the requested direction; infinite without a request
};

std::vector<double> areas(const Surface& s) {
    std::vector<double> out(s.vertices.size(), 0);
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t)
        for (const std::uint32_t v : s.triangles[t]) out[v] += filum::surface::area(s, t) / 3;
    return out;
}

// Where the vertices of the finer surface are on the base.
std::vector<Place> vertex_places(const filum::surface::FinerSurface& finer) {
    std::vector<Place> out(finer.surface.vertices.size());
    for (std::uint32_t t = 0; t < finer.parent.size(); ++t)
        for (const std::uint32_t v : finer.surface.triangles[t]) out[v] = {finer.parent[t], finer.surface.vertices[v]};
    return out;
}

// The middles of the points' areas on the base, which extend by `half` mm: those of vertices on a rim lie so far
// inside.
std::vector<Place> area_middles(const Surface& base, const filum::surface::FinerSurface& finer, double half) {
    std::vector<Place> out = vertex_places(finer);
    if (!std::isfinite(half)) return out; // there are no beads
    const Surface& s = finer.surface;
    const Locator locator(base);
    const auto inwards = [&](std::uint32_t h) { // from a side of a rim
        return geom::unit(cross(filum::surface::normal(s, h / 3), s.vertices[s.head(h)] - s.vertices[s.tail(h)]), {});
    };
    for (const auto& rim : s.rims)
        for (std::size_t i = 0; i < rim.sides.size(); ++i) {
            const std::uint32_t h = rim.sides[i], before = rim.sides[i > 0 ? i - 1 : rim.sides.size() - 1];
            const Vec3 in = inwards(before), on = inwards(h);
            // `half` mm from both sides; at a sharp corner not as far as that takes
            const Vec3 p = s.vertices[s.tail(h)] + half / std::max(0.5, 1 + dot(in, on)) * (in + on);
            const Place found = locator.nearest(p, filum::surface::normal(s, h / 3));
            if (found.triangle != filum::surface::kNone) out[s.tail(h)] = found;
        }
    return out;
}

// Transfers points and values from the base to surfaces with the same triangles.
class PointTransfer {
  public:
    PointTransfer(const Surface& base, const std::vector<Place>& places) {
        for (const Place& place : places)
            at_.push_back(
                {place.triangle, base.triangles[place.triangle], filum::surface::curve::barycentric(base, place)});
    }
    [[nodiscard]] Vec3 point(const Surface& to, std::size_t v) const {
        const auto& [triangle, c, w] = at_[v];
        return w[0] * to.vertices[c[0]] + w[1] * to.vertices[c[1]] + w[2] * to.vertices[c[2]];
    }
    [[nodiscard]] double value(std::span<const double> of, std::size_t v) const {
        const auto& [triangle, c, w] = at_[v];
        return w[0] * of[c[0]] + w[1] * of[c[1]] + w[2] * of[c[2]];
    }
    [[nodiscard]] std::uint32_t triangle(std::size_t v) const { return at_[v].triangle; }

  private:
    struct Barycentric {
        std::uint32_t triangle = 0;
        mesh::Triangle corners{}; // of the base; a surface that is turned over has another order
        std::array<double, 3> weight{};
    };
    std::vector<Barycentric> at_;
};

std::vector<Bead> beads_of(const Fibres& fibres, std::uint32_t layer) {
    constexpr double kApart = 1e6; // mm
    std::vector<Bead> out;
    double begin = 0;
    for (const Fibre& c : fibres.all) {
        for (std::size_t i = 0; i < c.width.size(); ++i)
            if (c.layer[i] == layer)
                out.push_back({c.points[i], c.points[i + 1], geom::unit(c.axes[i] + c.axes[i + 1], Vec3{}),
                               begin + c.along[i], c.width[i], c.height[i]});
        begin += c.length() + kApart;
    }
    return out;
}

// The direction requested at a place with that normal; (0, 0, 0) if none is.
Vec3 requested_at(const Bed& bed, const Place& at, const Vec3& n) {
    if (bed.asked.field != nullptr) return direction(bed.ground, *bed.asked.field, at);
    const Vec3& r = bed.asked.reference;
    const Vec3 flat = r - dot(r, n) * n;
    if (!(norm(flat) > kUpright * norm(r))) return {};
    return std::cos(bed.asked.turn) * flat + std::sin(bed.asked.turn) * cross(n, flat);
}

double degrees_between(const Vec3& a, const Vec3& b) {
    const double angle = geom::angle(a, b);
    return geom::degrees(std::min(angle, geom::kDegree * 180 - angle));
}

// Sets the deviation of each bead; appends those that count to `to`.
void judge(const Bed& bed, std::vector<Bead>& beads, std::vector<Weighted>& to, int threads) {
    const Locator near(bed.ground);
    const auto normals = filum::surface::curve::vertex_normals(bed.ground);
    std::vector<char> counts(beads.size(), 0);
    parallel::for_chunks(beads.size(), kPoints, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Bead& b = beads[i];
            const Vec3 middle = 0.5 * (b.a + b.b);
            Place foot = near.nearest(middle, b.normal);
            if (foot.triangle == filum::surface::kNone) foot = near.nearest(middle);
            if (b.normal == Vec3{}) b.normal = filum::surface::normal(bed.ground, foot.triangle);
            const Vec3 n = filum::surface::curve::normal_at(bed.ground, normals, foot), way = b.b - b.a;
            const Vec3 flat = way - dot(way, n) * n, to_follow = requested_at(bed, foot, n);
            if (!(norm(to_follow) > 0) || !(norm(flat) > 0)) continue;
            b.off = degrees_between(flat, to_follow);
            const auto w = filum::surface::curve::barycentric(bed.ground, foot);
            double edge = bed.edge.empty() ? -1 : 0;
            for (std::size_t k = 0; k < 3 && !bed.edge.empty(); ++k)
                edge += w[k] * bed.edge[bed.ground.triangles[foot.triangle][k]];
            counts[i] = edge < 0 && !past_rim(bed.ground, foot, middle, b.width) ? 1 : 0;
        }
    });
    for (std::size_t i = 0; i < beads.size(); ++i)
        if (counts[i] != 0) to.push_back({beads[i].off, distance(beads[i].a, beads[i].b)});
}

// A bead near a point: its position along the path, and the fraction of the point's area that it covers.
struct BeadPass {
    double way = 0, share = 0;
};

// The number of beads over a point: coverages more than a width apart along the path are separate beads, each with its
// greatest coverage.
double passes(std::vector<BeadPass>& found, double width) {
    std::sort(found.begin(), found.end(), [](const BeadPass& a, const BeadPass& b) { return a.way < b.way; });
    double sum = 0, most = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        most = std::max(most, found[i].share);
        if (i + 1 < found.size() && found[i + 1].way - found[i].way <= width) continue;
        sum += most;
        most = 0;
    }
    return sum;
}

// A point of a ply.
struct MapPoint {
    Vec3 p, middle, normal; // of the ground; middle: of the point's area
    double extent = 0;      // mm, of its area
};

// Sets passes, clearance and deviation at a point, number v.
void look(const std::vector<Bead>& beads, const geom::Bvh& tree, const MapPoint& at, double widest, std::size_t v,
          PlyMap& out) {
    const Vec3 &p = at.p, &m = at.middle, &n = at.normal;
    std::vector<BeadPass> found;
    double least = out.clearance[v];
    tree.visit(geom::grown({p, p}, 1.5 * widest), [&](std::uint32_t i) {
        const Bead& l = beads[i];
        if (!(dot(n, l.normal) > 0)) return;
        const auto nearest = [&](const Vec3& q) { return geom::nearest_parameter(l.a, l.b, q); };
        const auto off = [&](const Vec3& q, double t) { return distance(q, l.a + t * (l.b - l.a)); };
        // a point's area extends halfway to its neighbours
        const double t = nearest(m), share = (l.width / 2 - off(m, t)) / at.extent + 0.5;
        if (share > 0) found.push_back({l.way + t * distance(l.a, l.b), std::min(1.0, share)});
        const double d = off(p, nearest(p));
        if (!(d - l.width / 2 < least)) return;
        least = d - l.width / 2;
        out.deviation[v] = l.off;
    });
    out.clearance[v] = least;
    out.passes[v] = passes(found, out.width);
}

// The points of all maps, and the middles of their areas.
struct MapPoints {
    PointTransfer points, middles;
    std::size_t count = 0;
    double extent = 0; // mm: that of their areas
};

PlyMap map_of(const Fibres& fibres, const Bed& bed, const MapPoints& all, int threads) {
    const std::size_t points = all.count;
    auto beads = beads_of(fibres, bed.layer);
    PlyMap out;
    judge(bed, beads, out.off, threads);
    std::vector<Weighted> widths, heights;
    std::vector<geom::Box3> boxes;
    double widest = 0;
    for (const Bead& b : beads) {
        const double length = distance(b.a, b.b);
        widths.push_back({b.width, length});
        heights.push_back({b.height, length});
        boxes.push_back(geom::box_of(std::array{b.a, b.b}));
        widest = std::max(widest, b.width);
    }
    out.width = beads.empty() ? 0 : quantile(widths, 0.5);
    out.height = beads.empty() ? 0 : quantile(heights, 0.5);
    out.inside.assign(points, 1);
    if (!bed.edge.empty()) out.edge.assign(points, 0);
    out.passes.assign(points, 0);
    out.deviation.assign(points, kEndless);
    out.clearance.assign(points, widest);
    const geom::Bvh tree(boxes);
    parallel::for_chunks(points, kPoints, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            if (!bed.edge.empty()) {
                out.edge[v] = all.points.value(bed.edge, v);
                out.inside[v] = std::clamp(0.5 - out.edge[v] / (kPart * out.width), 0.0, 1.0);
            }
            const Vec3 normal = filum::surface::normal(bed.ground, all.points.triangle(v));
            look(beads, tree, {all.points.point(bed.ground, v), all.middles.point(bed.ground, v), normal, all.extent},
                 widest, v, out);
        }
    });
    return out;
}

// Means of the values within `reach` mm, by area.
std::vector<double> averaged(const Surface& s, std::span<const double> area, std::span<const double> values,
                             double reach, int threads) {
    std::vector<geom::Box3> boxes;
    boxes.reserve(values.size());
    for (const Vec3& p : s.vertices) boxes.push_back({p, p});
    const geom::Bvh tree(boxes);
    const auto normals = filum::surface::curve::vertex_normals(s);
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

} // namespace

Map map(const Surface& base, const Fibres& fibres, std::span<const Bed> beds, int threads) {
    double narrowest = kEndless;
    for (const Fibre& c : fibres.all)
        for (const double w : c.width) narrowest = std::min(narrowest, w);
    Map out{filum::surface::finer(base, kPart * narrowest), {}, {}, {}, {}, {}};
    const Surface& s = out.ground.surface;
    const std::size_t n = s.vertices.size();
    out.area = areas(s);
    out.nominal.assign(n, 0);
    out.thickness.assign(n, 0);
    out.even.assign(n, 0);
    const MapPoints points{PointTransfer(base, vertex_places(out.ground)),
                           PointTransfer(base, area_middles(base, out.ground, kPart * narrowest / 2)), n,
                           kPart * narrowest};
    for (const Bed& bed : beds) {
        PlyMap& now = out.plies.emplace_back(map_of(fibres, bed, points, threads));
        now.amount = averaged(s, out.area, now.passes, now.width, threads);
        for (std::size_t v = 0; v < n; ++v) {
            out.nominal[v] += now.height * now.inside[v];
            out.thickness[v] += now.height * now.passes[v];
            out.even[v] += now.height * now.amount[v];
        }
    }
    return out;
}

std::vector<Weighted> weighed(std::span<const double> values, std::span<const double> area,
                              std::span<const double> weight) {
    std::vector<Weighted> out;
    for (std::size_t v = 0; v < values.size(); ++v) {
        const double w = weight.empty() ? area[v] : area[v] * weight[v];
        if (std::isfinite(values[v]) && w > 0) out.push_back({values[v], w});
    }
    return out;
}

double share_beyond(const PlyMap& ply, std::span<const double> area, double more) {
    double sum = 0, total = 0;
    for (std::size_t v = 0; v < area.size(); ++v) {
        total += area[v] * ply.inside[v];
        sum += area[v] * ply.inside[v] * std::clamp(ply.passes[v] - more, 0.0, 1.0);
    }
    return total > 0 ? sum / total : 0;
}

} // namespace filum::metrics::surface
