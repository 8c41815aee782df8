#include "surface/flange.hpp"

#include "geom/angle.hpp"
#include "geom/bvh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <span>

namespace filum::surface {

namespace {

constexpr double kPartOfRoom = 0.5;  // of the way to the middle between rims
constexpr double kFan = 30;          // degrees between neighbouring directions about a corner, at most
constexpr double kSample = 0.25;     // of the depth, between points of the rims
constexpr double kLeastDepth = 0.01; // of the depth: less is no flange
constexpr std::size_t kBands = 2;
constexpr double kStraightOn = 0.5 * std::numbers::sqrt2; // cosine: a lid is nearer to straight on than to upright

// Where a strip of the flange begins or ends: a vertex of a rim, and a direction out from it.
struct Station {
    std::uint32_t vertex = 0;
    Vec3 out; // unit
};

// Square to the side of a rim, along the surface and away from it.
Vec3 outwards(const Surface& s, std::uint32_t h) {
    return geom::unit(cross(s.vertices[s.head(h)] - s.vertices[s.tail(h)], normal(s, h / 3)), {});
}

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

struct RimPoint {
    Vec3 at;
    std::uint32_t vertex = kNone; // none: between two
};

std::vector<RimPoint> rim_points(const Surface& s, double apart) {
    std::vector<RimPoint> out;
    for (const Rim& rim : s.rims)
        for (const std::uint32_t h : rim.sides) {
            const Vec3 &a = s.vertices[s.tail(h)], &b = s.vertices[s.head(h)];
            const double parts = std::ceil(distance(a, b) / apart);
            for (double k = 0; k < parts; ++k) out.push_back({a + k / parts * (b - a), k > 0 ? kNone : s.tail(h)});
        }
    return out;
}

// How deep the flange may be out from places of the rims.
class Room {
  public:
    Room(const Surface& s, double depth)
        : depth_(depth), points_(rim_points(s, kSample * depth)), tree_(geom::Bvh(boxes())) {}

    // Half the radius of the greatest ball that touches the rim at the station and has no point of it inside; at most
    // the depth.  Of a rim the points count, not the sides between: they stand for a smooth line.
    [[nodiscard]] double at(const Vec3& p, const Station& from) const {
        double radius = depth_ / kPartOfRoom;
        tree_.near(p, 2 * radius, [&](std::uint32_t i) {
            const Vec3 to = points_[i].at - p;
            if (norm(to) == 0 && points_[i].vertex != from.vertex) radius = 0; // rims that touch
            if (const double ahead = dot(to, from.out); ahead > kAhead * norm(to))
                radius = std::min(radius, dot(to, to) / (2 * ahead));
            return 2 * radius;
        });
        return kPartOfRoom * radius;
    }

  private:
    static constexpr double kAhead = 1e-6; // of the distance: what is no farther ahead lies beside

    [[nodiscard]] std::vector<geom::Box3> boxes() const {
        std::vector<geom::Box3> out;
        out.reserve(points_.size());
        for (const RimPoint& p : points_) out.push_back({p.at, p.at});
        return out;
    }

    double depth_;
    std::vector<RimPoint> points_;
    geom::Bvh tree_;
};

class Builder {
  public:
    Builder(const Surface& s, double near, double depth)
        : s_(s), share_{near / depth, 1}, depth_(depth), room_(s, depth), vertices_(s.vertices),
          triangles_(s.triangles), far_(s.triangles.size(), 0), least_(depth) {
        for (std::uint32_t v = 0; v < s.vertices.size(); ++v) root_.push_back(v);
    }

    Flanged built() {
        for (const Rim& rim : s_.rims) add(rim);
        Flanged out;
        out.surface = assemble(std::move(vertices_), triangles_, joined());
        out.part = static_cast<std::uint32_t>(s_.triangles.size());
        out.root = std::move(root_);
        out.far = std::move(far_);
        out.least = least_;
        out.least_at = least_at_;
        out.lids = std::move(lids_);
        return out;
    }

  private:
    using Column = std::array<std::uint32_t, kBands + 1>; // vertices from the rim outwards

    void add(const Rim& rim) {
        std::vector<Station> stations;
        for (std::size_t i = 0; i < rim.sides.size(); ++i)
            add_stations(s_, rim.sides[(i + rim.sides.size() - 1) % rim.sides.size()], rim.sides[i], stations);
        if (!rim.outer && narrow(stations) && close(rim)) return;
        std::vector<Column> columns;
        columns.reserve(stations.size());
        for (const Station& now : stations) columns.push_back(column(now));
        for (std::size_t i = 0; i < columns.size(); ++i) strip(columns[i], columns[(i + 1) % columns.size()]);
    }

    // Whether the depth is found nowhere along the rim.
    [[nodiscard]] bool narrow(std::span<const Station> stations) const {
        return std::none_of(stations.begin(), stations.end(),
                            [&](const Station& from) { return room_.at(s_.vertices[from.vertex], from) >= depth_; });
    }

    // Puts a lid on the hole, if one can lie there.
    bool close(const Rim& rim) {
        Vec3 middle, sum; // twice the area, as a vector
        for (const std::uint32_t h : rim.sides) middle = middle + s_.vertices[s_.tail(h)];
        middle = 1 / static_cast<double>(rim.sides.size()) * middle;
        for (const std::uint32_t h : rim.sides) sum = sum + twice_area(h, middle);
        Lid lid{static_cast<std::uint32_t>(vertices_.size()), middle, 0};
        for (const std::uint32_t h : rim.sides) {
            const Vec3 own = twice_area(h, middle);
            if (!(dot(own, sum) > 0) || !(dot(own, normal(s_, h / 3)) > kStraightOn * norm(own))) return false;
            lid.area += norm(own) / 2;
        }
        vertices_.push_back(middle);
        root_.push_back(s_.tail(rim.sides[0]));
        for (const std::uint32_t h : rim.sides) triangle({s_.head(h), s_.tail(h), lid.vertex}, 0);
        lids_.push_back(lid);
        return true;
    }

    // Of the lid's triangle beside the side of a rim.
    [[nodiscard]] Vec3 twice_area(std::uint32_t h, const Vec3& middle) const {
        return cross(s_.vertices[s_.tail(h)] - s_.vertices[s_.head(h)], middle - s_.vertices[s_.head(h)]);
    }

    Column column(const Station& from) {
        const Vec3& p = s_.vertices[from.vertex];
        double deep = room_.at(p, from);
        if (deep < kLeastDepth * depth_) deep = 0;
        if (deep < least_) {
            least_ = deep;
            least_at_ = p;
        }
        Column out{};
        out.fill(from.vertex);
        for (std::size_t k = 0; deep > 0 && k < kBands; ++k) {
            out[k + 1] = static_cast<std::uint32_t>(vertices_.size());
            vertices_.push_back(p + share_[k] * deep * from.out);
            root_.push_back(from.vertex);
        }
        return out;
    }

    // Between two columns, the first of which lies behind along the rim.
    void strip(const Column& a, const Column& b) {
        for (std::size_t k = 0; k < kBands; ++k) {
            triangle({b[k], a[k], a[k + 1]}, k);
            triangle({b[k], a[k + 1], b[k + 1]}, k);
        }
    }

    void triangle(const Triangle& t, std::size_t band) {
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
        triangles_.push_back(t);
        far_.push_back(band > 0 ? 1 : 0);
    }

    [[nodiscard]] std::vector<std::uint32_t> joined() const {
        std::vector<std::uint32_t> twin = s_.twin;
        twin.resize(3 * triangles_.size(), kNone);
        const auto ends = [&](std::uint32_t h) {
            return std::pair(triangles_[h / 3][h % 3], triangles_[h / 3][(h + 1) % 3]);
        };
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> open;
        for (std::uint32_t h = 0; h < twin.size(); ++h)
            if (twin[h] == kNone) open.emplace(ends(h), h);
        for (const auto& [way, h] : open)
            if (const auto other = open.find({way.second, way.first}); other != open.end()) twin[h] = other->second;
        return twin;
    }

    const Surface& s_;
    std::array<double, kBands> share_; // of the depth, where bands end
    double depth_;
    Room room_;
    std::vector<Vec3> vertices_;
    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> root_;
    std::vector<char> far_;
    double least_;
    Vec3 least_at_;
    std::vector<Lid> lids_;
};

} // namespace

Flanged flanged(const Surface& s, double near, double depth) { return Builder(s, near, depth).built(); }

} // namespace filum::surface
