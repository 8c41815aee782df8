#include "surface/rim_room.hpp"

#include "geom/angle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::surface {

namespace {

constexpr double kPartOfRoom = 0.5; // share of the way to the middle between rims
constexpr double kFan = 30;         // degrees: largest angle between neighbouring directions around a corner
constexpr double kSample = 0.25;    // depths between sample points of the rims
constexpr double kAhead = 1e-6;     // distances: points no farther ahead than this are beside the station

const Vec3& begin_of(const Surface& s, const Rim& rim, std::size_t side) {
    return s.vertices[s.tail(rim.sides[side % rim.sides.size()])];
}

double distance_to(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 d = b - a;
    const double t = norm2(d) > 0 ? std::clamp(dot(p - a, d) / norm2(d), 0.0, 1.0) : 0;
    return distance(p, a + t * d);
}

// The farthest side at which an edge that starts with side `first` can end; sides continue to be numbered past the
// last one.
std::size_t edge_end(const Surface& s, const Rim& rim, std::size_t first, double tolerance, double longest) {
    const Vec3& a = begin_of(s, rim, first);
    std::size_t end = first + 1;
    for (; end < rim.sides.size(); ++end) {
        const Vec3& b = begin_of(s, rim, end + 1);
        if (distance(a, b) > longest) break;
        for (std::size_t k = first + 1; k <= end; ++k)
            if (distance_to(begin_of(s, rim, k), a, b) > tolerance) return end;
    }
    return end;
}

Outline::Edge edge_between(const Surface& s, const Rim& rim, std::size_t first, std::size_t end) {
    Vec3 up;
    for (std::size_t k = first; k < end; ++k)
        up = up + distance(begin_of(s, rim, k), begin_of(s, rim, k + 1)) * normal(s, rim.sides[k] / 3);
    up = geom::unit(up, {});
    return {first, up, geom::unit(cross(begin_of(s, rim, end) - begin_of(s, rim, first), up), {})};
}

// Adds the directions at the vertex between two edges: several around a convex corner, otherwise the bisector; `along`
// where the edges coincide, as in a crack.
void add_stations(std::uint32_t vertex, std::size_t edge, const Outline::Edge& before, const Outline::Edge& after,
                  const Vec3& along, std::vector<Station>& to) {
    const Vec3 &a = before.out, &b = after.out;
    const double turn = geom::angle(a, b);
    const bool corner = dot(cross(a, b), before.up + after.up) > 0 && turn > geom::radians(kFan);
    const auto parts = corner ? static_cast<std::size_t>(std::ceil(turn / geom::radians(kFan))) : 0;
    const Vec3 aside = cross(geom::unit(cross(a, b), {}), a);
    if (!corner) to.push_back({vertex, edge, geom::unit(a + b, along)});
    for (std::size_t k = 0; corner && k <= parts; ++k) {
        const double w = turn * static_cast<double>(k) / static_cast<double>(parts);
        to.push_back({vertex, edge, std::cos(w) * a + std::sin(w) * aside});
    }
}

Outline outline_of(const Surface& s, const Rim& rim, double tolerance, double longest) {
    Outline out;
    for (std::size_t first = 0, end = 0; first < rim.sides.size(); first = end) {
        end = edge_end(s, rim, first, tolerance, longest);
        out.edges.push_back(edge_between(s, rim, first, end));
    }
    const std::size_t n = out.edges.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Outline::Edge &before = out.edges[(i + n - 1) % n], &after = out.edges[i], &next = out.edges[(i + 1) % n];
        const Vec3 along = geom::unit(begin_of(s, rim, next.side) - begin_of(s, rim, after.side), after.out);
        add_stations(s.tail(rim.sides[after.side]), i, before, after, along, out.stations);
    }
    return out;
}

} // namespace

RimRoom::RimRoom(const Surface& s, double depth, double tolerance)
    : s_(s), depth_(depth), tolerance_(tolerance), tree_(geom::Bvh(boxes())) {}

void RimRoom::add(const Rim& rim, const Outline& outline) {
    for (std::size_t i = 0; i < outline.edges.size(); ++i) {
        const auto& next = outline.edges[(i + 1) % outline.edges.size()];
        const std::uint32_t from = s_.tail(rim.sides[outline.edges[i].side]), to = s_.tail(rim.sides[next.side]);
        const Vec3 &a = s_.vertices[from], &b = s_.vertices[to];
        const auto edge = static_cast<std::uint32_t>(edges_.size());
        edges_.push_back({a, b, outline.edges[i].out, from, to});
        const double parts = std::ceil(distance(a, b) / (kSample * depth_));
        points_.push_back({a, edge});
        for (double k = 1; k < parts; ++k) points_.push_back({a + k / parts * (b - a), edge});
    }
}

// Creates the points and returns their boxes.
std::vector<geom::Box3> RimRoom::boxes() {
    for (const Rim& rim : s_.rims) add(rim, outlines_.emplace_back(outline_of(s_, rim, tolerance_, kSample * depth_)));
    std::vector<geom::Box3> out;
    out.reserve(points_.size());
    for (const Point& p : points_) out.push_back({p.at, p.at});
    return out;
}

double RimRoom::radius(const Station& from, const Point& other) const {
    constexpr double kAny = std::numeric_limits<double>::infinity();
    const Vec3& p = s_.vertices[from.vertex];
    const Edge& edge = edges_[other.edge];
    const bool own = edge.from == from.vertex || edge.to == from.vertex, faces = dot(edge.out, from.out) < 0;
    if (own && !(other.at == edge.a && edge.to == from.vertex)) return kAny;
    if (!own && faces && distance_to(p, edge.a, edge.b) < tolerance_) return 0;
    const Vec3 to = other.at - p;
    const double ahead = dot(to, from.out) - (faces ? 0 : tolerance_);
    return ahead > kAhead * norm(to) ? dot(to, to) / (2 * ahead) : kAny;
}

double RimRoom::at(const Station& from) const {
    double least = depth_ / kPartOfRoom;
    tree_.near(s_.vertices[from.vertex], 2 * least, [&](std::uint32_t i) {
        least = std::min(least, radius(from, points_[i]));
        return 2 * least;
    });
    return kPartOfRoom * least;
}

} // namespace filum::surface
