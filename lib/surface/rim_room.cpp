#include "surface/rim_room.hpp"

#include "geom/angle.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surface {

namespace {

constexpr double kPartOfRoom = 0.5; // of the way to the middle between rims
constexpr double kFan = 30;         // degrees between neighbouring directions about a corner, at most
constexpr double kSample = 0.25;    // of the depth, between points of the rims
constexpr double kAhead = 1e-6;     // of the distance: what is no farther ahead lies beside

// The directions at the vertex between two sides of a rim: several about a corner that sticks out, else the middle one.
void add_stations(const Surface& s, std::uint32_t before, std::uint32_t after, std::vector<Station>& to) {
    const std::uint32_t v = s.tail(after);
    const Vec3 a = outwards(s, before), b = outwards(s, after), n = normal(s, before / 3) + normal(s, after / 3);
    const double turn = geom::angle(a, b);
    const bool corner = dot(cross(a, b), n) > 0 && turn > geom::radians(kFan);
    const auto parts = corner ? static_cast<std::size_t>(std::ceil(turn / geom::radians(kFan))) : 0;
    const Vec3 aside = cross(geom::unit(cross(a, b), n), a);
    if (!corner) to.push_back({v, geom::unit(a + b, a)});
    for (std::size_t k = 0; corner && k <= parts; ++k) {
        const double w = turn * static_cast<double>(k) / static_cast<double>(parts);
        to.push_back({v, std::cos(w) * a + std::sin(w) * aside});
    }
}

} // namespace

Vec3 outwards(const Surface& s, std::uint32_t h) {
    return geom::unit(cross(s.vertices[s.head(h)] - s.vertices[s.tail(h)], normal(s, h / 3)), {});
}

std::vector<Station> stations(const Surface& s, const Rim& rim) {
    std::vector<Station> out;
    for (std::size_t i = 0; i < rim.sides.size(); ++i)
        add_stations(s, rim.sides[(i + rim.sides.size() - 1) % rim.sides.size()], rim.sides[i], out);
    return out;
}

RimRoom::RimRoom(const Surface& s, double depth)
    : s_(s), depth_(depth), points_(points(s, kSample * depth)), tree_(geom::Bvh(boxes())) {}

std::vector<RimRoom::Point> RimRoom::points(const Surface& s, double apart) {
    std::vector<Point> out;
    for (const Rim& rim : s.rims)
        for (const std::uint32_t h : rim.sides) {
            const Vec3 &a = s.vertices[s.tail(h)], &b = s.vertices[s.head(h)];
            const double parts = std::ceil(distance(a, b) / apart);
            out.push_back({a, s.tail(h), s.tail(h)});
            for (double k = 1; k < parts; ++k) out.push_back({a + k / parts * (b - a), s.tail(h), s.head(h)});
        }
    return out;
}

std::vector<geom::Box3> RimRoom::boxes() const {
    std::vector<geom::Box3> out;
    out.reserve(points_.size());
    for (const Point& p : points_) out.push_back({p.at, p.at});
    return out;
}

double RimRoom::at(const Station& from) const {
    const Vec3& p = s_.vertices[from.vertex];
    double radius = depth_ / kPartOfRoom;
    tree_.near(p, 2 * radius, [&](std::uint32_t i) {
        const Point& other = points_[i];
        if (other.from == from.vertex || other.to == from.vertex) return 2 * radius;
        const Vec3 to = other.at - p;
        if (norm(to) == 0) radius = 0; // rims that touch
        if (const double ahead = dot(to, from.out); ahead > kAhead * norm(to))
            radius = std::min(radius, dot(to, to) / (2 * ahead));
        return 2 * radius;
    });
    return kPartOfRoom * radius;
}

} // namespace filum::surface
