#include "metrics/surface/area.hpp"

#include "geodesic/query.hpp"
#include "metrics/surface/rows.hpp"
#include "parallel/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace filum::metrics::surface {

namespace {

using filum::surface::kNone;

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr double kSameWidth = 1.02;
constexpr std::size_t kMostClasses = 64;
constexpr double kFirstRow = 1.0 / 8, kLastRow = 1.0 / 128; // of the widest bead
// The most rows of one pass, beside one per triangle; some seconds of work. Rows are integrated exactly along their
// length, so wider rows make the area less certain but not biased.
constexpr double kMostRows = 2e6;

// The class of each segment; classes by ascending width.
std::vector<std::uint32_t> classify(const std::vector<double>& width) {
    std::vector<double> sorted = width;
    std::sort(sorted.begin(), sorted.end());
    const double ratio = std::max(kSameWidth, std::pow(sorted.back() / sorted.front(), 1.0 / (kMostClasses - 1)));
    std::vector<double> begins;
    for (const double w : sorted)
        if (begins.empty() || w > begins.back() * ratio) begins.push_back(w);
    std::vector<std::uint32_t> out;
    out.reserve(width.size());
    for (const double w : width)
        out.push_back(
            static_cast<std::uint32_t>(std::upper_bound(begins.begin(), begins.end(), w) - begins.begin() - 1));
    return out;
}

// Sums of one task.
struct Sweep {
    double covered = 0, strip = 0, strip_covered = 0;
    double void_radius = 0;
    Vec3 void_at{};
};

class Sweeper {
  public:
    Sweeper(const Ground& g, const PathField& f, const geodesic::ExactField* rims, double strip, double row)
        : ground_(g), surface_(g.finer.surface), field_(f), rims_(rims), strip_(strip), row_(row) {}

    void sweep(std::uint32_t t, Sweep& out) {
        const std::uint32_t h = 3 * t;
        const Vec3 &tail = surface_.vertices[surface_.tail(h)], &head = surface_.vertices[surface_.head(h)],
                   &top = surface_.vertices[surface_.tail(filum::surface::prev(h))];
        const double base = distance(tail, head), height = norm(cross(head - tail, top - tail)) / base;
        const auto n = static_cast<std::size_t>(std::max(1.0, std::ceil(height / row_)));
        std::vector<Rows> rows;
        for (const auto& c : field_.classes) rows.emplace_back(surface_, c.field, t, c.width / 2);
        std::optional<Rows> edge;
        if (rims_ != nullptr && near_rim(t)) edge.emplace(surface_, *rims_, t, strip_);
        for (std::size_t i = 0; i < n; ++i) {
            const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
            const Vec3 a = tail + u * (top - tail), b = head + u * (top - head);
            const double area = (1 - u) * base * height / static_cast<double>(n);
            parts_.clear();
            for (const Rows& r : rows) r.below(a, b, parts_);
            unite(parts_);
            out.covered += area * total(parts_);
            if (edge) {
                strip_parts_.clear();
                edge->below(a, b, strip_parts_);
                unite(strip_parts_);
                out.strip += area * total(strip_parts_);
                out.strip_covered += area * total(common(parts_, strip_parts_));
            }
            find_void(t, a, b, out);
        }
    }

  private:
    [[nodiscard]] bool near_rim(std::uint32_t t) const {
        double least = kFar, longest = 0;
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            least = std::min(least, rims_->distance[surface_.tail(h)]);
            longest = std::max(longest, rims_->unfolding->frame[h].length);
        }
        return least <= strip_ + longest;
    }
    // Clearance at the middle of every uncovered part of a row.
    void find_void(std::uint32_t t, const Vec3& a, const Vec3& b, Sweep& out) const {
        double from = 0;
        for (std::size_t i = 0; i <= parts_.size(); ++i) {
            const double to = i < parts_.size() ? parts_[i].lo : 1;
            if (to - from > 1e-6) {
                const Vec3 p = a + (from + to) / 2 * (b - a);
                const double free = clearance(ground_, field_, t, p);
                if (free > out.void_radius && free < kFar) {
                    out.void_radius = free;
                    out.void_at = p;
                }
            }
            if (i < parts_.size()) from = parts_[i].hi;
        }
    }

    const Ground& ground_;
    const Surface& surface_;
    const PathField& field_;
    const geodesic::ExactField* rims_;
    double strip_, row_;
    std::vector<Interval> parts_, strip_parts_;
};

std::optional<geodesic::ExactField> rim_field(const Surface& s, double strip) {
    if (s.rims.empty()) return std::nullopt;
    return geodesic::exact(s, filum::surface::rim_sources(s), strip);
}

// The least height of rows, mm, so that there are at most kMostRows.
double least_row(const Surface& s) {
    double heights = 0;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const Vec3 &tail = s.vertices[s.tail(3 * t)], &head = s.vertices[s.head(3 * t)];
        heights += 2 * filum::surface::area(s, t) / distance(tail, head);
    }
    return heights / kMostRows;
}

Sweep swept(const Ground& ground, const PathField& field, const geodesic::ExactField* rims, double strip, double row,
            int threads) {
    const std::size_t n = ground.finer.surface.triangles.size();
    std::vector<Sweep> parts((n + kGrain - 1) / kGrain);
    parallel::for_chunks(n, kGrain, threads, [&](std::size_t begin, std::size_t end) {
        Sweeper sweeper(ground, field, rims, strip, row);
        for (std::size_t t = begin; t < end; ++t) sweeper.sweep(static_cast<std::uint32_t>(t), parts[begin / kGrain]);
    });
    Sweep sum;
    for (const Sweep& p : parts) {
        sum.covered += p.covered;
        sum.strip += p.strip;
        sum.strip_covered += p.strip_covered;
        if (p.void_radius > sum.void_radius) {
            sum.void_radius = p.void_radius;
            sum.void_at = p.void_at;
        }
    }
    return sum;
}

} // namespace

PathField path_field(const Ground& ground, const Shadow& shadow) {
    PathField out;
    if (shadow.segments.empty()) return out;
    const auto of = classify(shadow.width);
    const std::uint32_t classes = *std::max_element(of.begin(), of.end()) + 1;
    for (std::uint32_t c = 0; c < classes; ++c) {
        filum::surface::Sources sources;
        double sum = 0, weight = 0;
        for (std::size_t i = 0; i < of.size(); ++i) {
            if (of[i] != c) continue;
            const double l = distance(shadow.segments[i].a, shadow.segments[i].b) + 1e-12;
            sources.segments.push_back(shadow.segments[i]);
            sum += shadow.width[i] * l;
            weight += l;
        }
        if (!sources.empty()) out.classes.push_back({sum / weight, geodesic::exact(ground.finer.surface, sources)});
    }
    return out;
}

double clearance(const Ground& ground, const PathField& field, std::uint32_t triangle, const Vec3& p) {
    double least = kFar;
    for (const auto& c : field.classes)
        least = std::min(least, geodesic::distance_at(ground.finer.surface, c.field, triangle, p) - c.width / 2);
    return least;
}

Area measure_area(const Ground& ground, const PathField& field, double strip_width, int threads, double stable) {
    const Surface& s = ground.finer.surface;
    Area out;
    double widest = 0;
    for (const auto& c : field.classes) widest = std::max(widest, c.width);
    std::vector<double> nearest(s.vertices.size(), kFar);
    for (const auto& c : field.classes)
        for (std::size_t v = 0; v < nearest.size(); ++v)
            nearest[v] = std::min(nearest[v], c.field.distance[v] - c.width / 2);
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const double area = filum::surface::area(s, t);
        out.surface += area;
        if (nearest[s.triangles[t][0]] == kFar) out.unreached += area;
    }
    if (field.classes.empty()) return out;
    const auto rims = rim_field(s, strip_width);
    Sweep sum;
    double before = -kFar;
    const double least = least_row(s);
    for (out.row = std::max(kFirstRow * widest, least);; out.row /= 2) {
        sum = swept(ground, field, rims ? &*rims : nullptr, strip_width, out.row, threads);
        if (std::abs(sum.covered - before) < stable * out.surface || out.row / 2 < std::max(kLastRow * widest, least))
            break;
        before = sum.covered;
    }
    out.covered = sum.covered;
    out.strip = sum.strip;
    out.strip_covered = sum.strip_covered;
    out.void_radius = sum.void_radius;
    out.void_at = sum.void_at;
    for (std::size_t v = 0; v < nearest.size(); ++v)
        if (nearest[v] > out.void_radius && nearest[v] < kFar) {
            out.void_radius = nearest[v];
            out.void_at = s.vertices[v];
        }
    return out;
}

double paper_area_fraction(const Ground& ground, std::span<const Sample> samples, double d, int threads) {
    const Surface& s = ground.finer.surface;
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        points.push_back(samples[i].a);
        if (i + 1 == samples.size() || !(samples[i + 1].a == samples[i].b)) points.push_back(samples[i].b);
    }
    filum::surface::Sources sources;
    sources.segments.resize(points.size());
    parallel::for_chunks(points.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const filum::surface::curve::Place at = ground.fine_foot(points[i], {});
            sources.segments[i] = {at.triangle, at.point, at.point};
        }
    });
    if (sources.empty()) return 0;
    const auto field = geodesic::exact(s, sources, 2 * d);
    double all = 0, open = 0;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto& c = s.triangles[t];
        const double area = filum::surface::area(s, t);
        all += area;
        if (std::min({field.distance[c[0]], field.distance[c[1]], field.distance[c[2]]}) > d) open += area;
    }
    return 1 - open / all;
}

} // namespace filum::metrics::surface
