#include "surface/lids.hpp"

#include "surface/rim_room.hpp"
#include "surface/ring_triangles.hpp"

#include <algorithm>
#include <numbers>
#include <span>

namespace filum::surface {

namespace {

// least cosine between a lid and the surface beside it: 45 degrees
constexpr double kStraightOn = 0.5 * std::numbers::sqrt2;
constexpr double kFacing = -0.5; // largest cosine between the sides of a notch: they open by less than 60 degrees

class LidBuilder {
  public:
    LidBuilder(const Surface& s, double depth, double tolerance) : s_(s), depth_(depth), room_(s, depth, tolerance) {}

    SurfaceWithLids made() {
        for (std::size_t rim = 0; rim < s_.rims.size(); ++rim) add(s_.rims[rim], room_.outline(rim));
        out_.surface = grown(s_, s_.vertices, triangles_);
        return std::move(out_);
    }

  private:
    void add(const Rim& rim, const Outline& outline) {
        const auto& all = outline.stations;
        std::vector<char> narrow;
        narrow.reserve(all.size());
        for (const Station& from : all) narrow.push_back(room_.at(from) < depth_ ? 1 : 0);
        const auto wide = static_cast<std::size_t>(std::find(narrow.begin(), narrow.end(), 0) - narrow.begin());
        if (wide < all.size())
            add_notches(rim, outline, narrow, wide);
        else if (!rim.outer)
            close(vertices(rim, 0, rim.sides.size() - 1), false);
    }

    // Adds notches: stretches of the outline without room, starting from a station that has room.
    void add_notches(const Rim& rim, const Outline& outline, std::span<const char> narrow, std::size_t wide) {
        const auto& all = outline.stations;
        for (std::size_t i = 1, first = 0; i <= all.size(); ++i) {
            if (narrow[(wide + i) % all.size()] != 0) {
                if (first == 0) first = i;
                continue;
            }
            const auto side = [&](std::size_t k) { return outline.edges[all[(wide + k) % all.size()].edge].side; };
            const std::size_t from = side(first), to = side(i - 1);
            if (first > 0 && from != to && faces_itself(outline, from, to)) close(vertices(rim, from, to), true);
            first = 0;
        }
    }

    // Whether the edge that turns most from the first one, and the edge that turns most from that, face each other, as
    // the two sides of a notch do.
    static bool faces_itself(const Outline& outline, std::size_t from, std::size_t to) {
        std::vector<Vec3> out;
        for (const auto& edge : outline.edges)
            if (from < to ? edge.side >= from && edge.side < to : edge.side >= from || edge.side < to)
                out.push_back(edge.out);
        const auto farthest = [&](const Vec3& way) {
            return *std::min_element(out.begin(), out.end(),
                                     [&](const Vec3& a, const Vec3& b) { return dot(a, way) < dot(b, way); });
        };
        const Vec3 one = farthest(out.front());
        return dot(one, farthest(one)) < kFacing;
    }

    // The vertices at which sides begin, from one side to another, both included.
    [[nodiscard]] std::vector<std::uint32_t> vertices(const Rim& rim, std::size_t from, std::size_t to) const {
        std::vector<std::uint32_t> out;
        for (std::size_t k = from;; k = (k + 1) % rim.sides.size()) {
            out.push_back(s_.tail(rim.sides[k]));
            if (k == to) return out;
        }
    }

    // Adds a lid on the ring of vertices, if possible. The last side of a notch is its mouth.
    void close(std::span<const std::uint32_t> ring, bool notch) {
        std::vector<Vec3> points;
        for (const std::uint32_t v : ring) points.push_back(s_.vertices[v]);
        const std::vector<Triangle> triangles = ring_triangles(points);
        if (triangles.empty() || !goes_on(ring, triangles) || holds_rim(ring, points, triangles)) return;
        Lid lid{ring.front(), {}, 0, notch};
        for (const auto& [a, b, c] : triangles) {
            const double own = norm(cross(points[b] - points[a], points[c] - points[a])) / 2;
            lid.area += own;
            lid.middle = lid.middle + own / 3 * (points[a] + points[b] + points[c]);
            triangles_.push_back({ring[a], ring[b], ring[c]});
        }
        lid.middle = 1 / lid.area * lid.middle;
        out_.lids.push_back(lid);
    }

    // Whether all triangles at the rim face the same way as the surface beside them.
    [[nodiscard]] bool goes_on(std::span<const std::uint32_t> ring, std::span<const Triangle> triangles) const {
        return std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
            const Vec3 &a = s_.vertices[ring[t[0]]], &b = s_.vertices[ring[t[1]]], &c = s_.vertices[ring[t[2]]];
            const Vec3 own = cross(b - a, c - a);
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t h = s_.outgoing[ring[t[(k + 1) % 3]]]; // the rim runs in the opposite direction
                if (s_.head(h) == ring[t[k]] && !(dot(own, normal(s_, h / 3)) > kStraightOn * norm(own))) return false;
            }
            return true;
        });
    }

    // Whether a vertex of a rim that is not a corner of the lid is inside it, in projection.
    [[nodiscard]] bool holds_rim(std::span<const std::uint32_t> ring, std::span<const Vec3> points,
                                 std::span<const Triangle> triangles) const {
        const geom::Box3 about = geom::box_of(points);
        const double reach = norm(about.size()) / 2; // what is farther from the box lies in no triangle's way
        for (const Rim& rim : s_.rims)
            for (const std::uint32_t h : rim.sides) {
                const std::uint32_t v = s_.tail(h);
                const Vec3& p = s_.vertices[v];
                if (geom::distance(about, p) > reach || std::find(ring.begin(), ring.end(), v) != ring.end()) continue;
                if (within(points, triangles, p)) return true;
            }
        return false;
    }

    static bool within(std::span<const Vec3> points, std::span<const Triangle> triangles, const Vec3& p) {
        return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
            const Vec3 n = cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3& a = points[t[k]];
                if (dot(cross(points[t[(k + 1) % 3]] - a, p - a), n) < 0) return false;
            }
            return true;
        });
    }

    const Surface& s_;
    double depth_;
    RimRoom room_;
    std::vector<Triangle> triangles_;
    SurfaceWithLids out_;
};

} // namespace

SurfaceWithLids with_lids(const Surface& s, double depth, double tolerance) {
    return LidBuilder(s, depth, tolerance).made();
}

} // namespace filum::surface
