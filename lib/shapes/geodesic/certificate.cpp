#include "geodesic/certificate.hpp"

#include "base/number.hpp"

namespace filum::geodesic {

namespace {

// The gradient's length of a function that is linear on the triangle, and the triangle's area.
struct Slope {
    double size, area;
};
Slope slope(const Vec3& a, const Vec3& b, const Vec3& c, double fa, double fb, double fc) {
    const Vec3 u = b - a, v = c - a, n = cross(u, v);
    const double double_area = norm(n);
    const Vec3 g = (fb - fa) * cross(v, n) - (fc - fa) * cross(u, n);
    return {norm(g) / (double_area * double_area), double_area / 2};
}

} // namespace

SlopeError slope_error(const Surface& s, std::span<const double> distance) {
    struct Part {
        double error, area;
    };
    std::vector<Part> parts;
    SlopeError out;
    for (const auto& [a, b, c] : s.triangles) {
        const double fa = distance[a], fb = distance[b], fc = distance[c];
        if (!std::isfinite(fa + fb + fc)) continue;
        const Slope g = slope(s.vertices[a], s.vertices[b], s.vertices[c], fa, fb, fc);
        parts.push_back({std::abs(g.size - 1), g.area});
        out.area += g.area;
    }
    if (parts.empty()) return out;
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.error < b.error; });
    double below = 0;
    std::size_t bin = 0;
    for (const Part& p : parts) {
        while (bin < std::size(SlopeError::kBounds) && p.error >= SlopeError::kBounds[bin]) ++bin;
        out.share[bin] += p.area / out.area;
        out.mean += p.error * p.area / out.area;
        if (below < 0.99 * out.area) out.p99 = p.error;
        below += p.area;
    }
    return out;
}

double excess(const Surface& s, std::span<const double> distance) {
    double out = 0;
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        const double a = distance[s.tail(h)], b = distance[s.head(h)];
        if (!std::isfinite(a) || !std::isfinite(b)) continue;
        out = std::max(out, std::abs(a - b) - surface::side_length(s, h));
    }
    return out;
}

DistanceError distance_error(std::span<const double> truth, std::span<const double> distance) {
    constexpr double kNearest = 0.02; // share of the farthest: the relative error of nearer vertices is not meaningful
    DistanceError out;
    for (const double d : truth)
        if (std::isfinite(d)) out.known = std::max(out.known, d);
    std::vector<double> errors;
    for (std::size_t v = 0; v < truth.size(); ++v)
        if (std::isfinite(truth[v]) && truth[v] > kNearest * out.known)
            errors.push_back(std::abs(distance[v] - truth[v]) / truth[v]);
    out.vertices = errors.size();
    if (errors.empty()) return out;
    std::sort(errors.begin(), errors.end());
    for (const double e : errors) out.mean += e / static_cast<double>(errors.size());
    out.p99 = errors[(errors.size() - 1) * 99 / 100];
    out.largest = errors.back();
    return out;
}

Facts certificate(const Surface& s, std::span<const double> distance) {
    double farthest = 0, reached = 0;
    for (const double d : distance)
        if (std::isfinite(d)) {
            farthest = std::max(farthest, d);
            ++reached;
        }
    const SlopeError e = slope_error(s, distance);
    Facts out{{"", "reached", reached, "vertices"},
              {"", "unreached", static_cast<double>(distance.size()) - reached, "vertices"},
              {"", "farthest-vertex", farthest, "mm"},
              {"", "excess", excess(s, distance), "mm"},
              {"", "slope-error-mean", e.mean, ""},
              {"", "slope-error-p99", e.p99, ""}};
    double below = 0;
    for (std::size_t i = 0; i < std::size(SlopeError::kBounds); ++i) {
        below += e.share[i];
        out.push_back({"", "slope-error-below-" + shortest_text(SlopeError::kBounds[i]), below, "of the area"});
    }
    return out;
}

} // namespace filum::geodesic
