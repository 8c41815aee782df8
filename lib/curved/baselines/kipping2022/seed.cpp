#include "baselines/kipping2022/seed.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace filum::baselines::kipping2022 {

namespace {

constexpr double kFlat = 1e-5;  // extents of the sources: tolerance of planes and lines
constexpr double kJoint = 1e-6; // mm between ends of segments that meet

Points ends(const surface::Sources& sources) {
    Points out;
    for (const auto& segment : sources.segments) {
        out.push_back(segment.a);
        out.push_back(segment.b);
    }
    return out;
}

// The ends of segments sorted by place.
class SegmentEnds {
  public:
    explicit SegmentEnds(const Points& points) : points_(points), order_(points.size()) {
        for (std::uint32_t i = 0; i < order_.size(); ++i) order_[i] = i;
        std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
            return points[a].x != points[b].x ? points[a].x < points[b].x : a < b;
        });
    }

    // The lowest other end at the place of `end` that belongs to an unused segment; kNone if there is none.
    [[nodiscard]] std::uint32_t meets(std::uint32_t end, const std::vector<char>& taken) const {
        const Vec3& p = points_[end];
        auto i = std::lower_bound(order_.begin(), order_.end(), p.x - kJoint,
                                  [&](std::uint32_t a, double x) { return points_[a].x < x; });
        std::uint32_t best = surface::kNone;
        for (; i != order_.end() && points_[*i].x <= p.x + kJoint; ++i)
            if (taken[*i / 2] == 0 && *i < best && distance(points_[*i], p) <= kJoint) best = *i;
        return best;
    }

  private:
    const Points& points_;
    std::vector<std::uint32_t> order_;
};

} // namespace

std::optional<surface::Plane> plane_of(const Surface& s, const surface::Sources& sources) {
    const Points points = ends(sources);
    if (points.empty()) return {};
    const auto farthest = [&](auto&& from) {
        return *std::max_element(points.begin(), points.end(),
                                 [&](const Vec3& a, const Vec3& b) { return from(a) < from(b); });
    };
    const Vec3 one = farthest([&](const Vec3& p) { return distance(p, points[0]); });
    const Vec3 other = farthest([&](const Vec3& p) { return distance(p, one); });
    const double extent = distance(one, other);
    if (!(extent > 0)) return {};
    const Vec3 axis = 1 / extent * (other - one);
    const auto aside = [&](const Vec3& p) { return norm(cross(axis, p - one)); };
    const Vec3 third = farthest(aside);
    Vec3 within = third - one; // in the plane, beside the axis
    if (aside(third) <= kFlat * extent) {
        within = {};
        for (const auto& segment : sources.segments)
            within = within + distance(segment.a, segment.b) * surface::normal(s, segment.triangle);
    }
    const Vec3 normal = cross(axis, within);
    if (!(norm(normal) > 0)) return {};
    const surface::Plane plane{1 / norm(normal) * normal, dot(normal, one) / norm(normal)};
    for (const Vec3& p : points)
        if (std::abs(dot(plane.normal, p) - plane.offset) > kFlat * extent) return {};
    return plane;
}

std::optional<std::vector<double>> signed_distances(const Surface& s, std::span<const double> phi,
                                                    const surface::Plane& plane, double spacing) {
    std::vector<double> out = surface::sides(s, plane);
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        const std::uint32_t a = s.tail(h), b = s.head(h);
        const double near = spacing + 2 * distance(s.vertices[a], s.vertices[b]);
        if (out[a] * out[b] < 0 && std::isfinite(phi[a]) && std::min(phi[a], phi[b]) > near) return {};
    }
    for (std::size_t v = 0; v < out.size(); ++v) out[v] = out[v] < 0 ? -phi[v] : phi[v];
    return out;
}

std::vector<SeedLine> seed_lines(const surface::Sources& sources) {
    const Points points = ends(sources);
    const SegmentEnds all(points);
    std::vector<char> taken(sources.segments.size(), 0);
    std::vector<SeedLine> out;
    for (std::uint32_t i = 0; i < taken.size(); ++i) {
        if (taken[i] != 0) continue;
        taken[i] = 1;
        std::array<Points, 2> ways; // from the segment's first end, and from its second one
        for (const std::uint32_t side : {0U, 1U}) {
            ways[side].push_back(points[2 * i + side]);
            std::uint32_t end = 2 * i + side;
            for (std::uint32_t to = all.meets(end, taken); to != surface::kNone; to = all.meets(end, taken)) {
                taken[to / 2] = 1;
                end = to ^ 1U;
                ways[side].push_back(points[end]);
            }
        }
        SeedLine line;
        line.points.assign(ways[0].rbegin(), ways[0].rend());
        line.points.insert(line.points.end(), ways[1].begin(), ways[1].end());
        line.closed = line.points.size() > 3 && distance(line.points.front(), line.points.back()) <= kJoint;
        if (line.closed) line.points.pop_back();
        if (length(line.points, line.closed) > 0) out.push_back(std::move(line));
    }
    return out;
}

} // namespace filum::baselines::kipping2022
