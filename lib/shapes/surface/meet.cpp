#include "surface/meet.hpp"

#include "geom/bvh.hpp"
#include "geom/segment.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <tuple>

namespace filum::surface {

namespace {

using geom::Box3;
using Corners = std::array<Vec3, 3>;

constexpr double kNear = 0.05;        // mean edges: distance at which a rim touches a mesh
constexpr double kSpotsPerEdge = 4;   // sample points of rims per mean edge
constexpr double kStraight = 0.87;    // cosine of the sharpest bend within a touching stretch, 30 degrees
constexpr int kHalvings = 30;         // bisections between two sample points to find where a touching stretch ends
constexpr double kDegenerate = 1e-12; // longest sides squared: twice the area below which a triangle is degenerate

Box3 around(std::initializer_list<Vec3> points, double margin) { return geom::grown(geom::box_of(points), margin); }

Corners corners(const std::vector<Vec3>& v, const Triangle& t) { return {v[t[0]], v[t[1]], v[t[2]]}; }

// Unit normal; (0, 0, 0) if the triangle has no area.
Vec3 normal_of(const Corners& c) {
    const Vec3 n = cross(c[1] - c[0], c[2] - c[0]);
    const double l = norm(n), side = std::max({distance(c[0], c[1]), distance(c[1], c[2]), distance(c[2], c[0])});
    return l > kDegenerate * side * side ? 1 / l * n : Vec3{};
}

// Clips a-b, which is in the plane of the triangle, to the triangle. Returns false if less than `least` remains.
bool clip(const Corners& t, const Vec3& normal, double least, Vec3& a, Vec3& b) {
    double from = 0, to = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 side = t[(k + 1) % 3] - t[k];
        const Vec3 inwards = 1 / norm(side) * cross(normal, side);
        double u = dot(a - t[k], inwards), v = dot(b - t[k], inwards);
        if (std::abs(u) <= least) u = 0;
        if (std::abs(v) <= least) v = 0;
        if (u < 0 && v < 0) return false;
        if (u < 0) from = std::max(from, u / (u - v));
        if (v < 0) to = std::min(to, u / (u - v));
    }
    if (!((to - from) * distance(a, b) > least)) return false;
    const Vec3 way = b - a;
    b = a + to * way;
    a = a + from * way;
    return true;
}

// Area of the intersection of two triangles in one plane (Sutherland, Hodgman 1974); the normal is that of the first.
double common_area(const Corners& t, const Vec3& normal, const Corners& other) {
    std::vector<Vec3> polygon(other.begin(), other.end()), next;
    for (std::size_t k = 0; k < 3 && !polygon.empty(); ++k) {
        const Vec3 inwards = cross(normal, t[(k + 1) % 3] - t[k]);
        next.clear();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
            const double u = dot(a - t[k], inwards), v = dot(b - t[k], inwards);
            if (u >= 0) next.push_back(a);
            if (u * v < 0) next.push_back(a + u / (u - v) * (b - a));
        }
        polygon.swap(next);
    }
    Vec3 sum;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        sum = sum + cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return norm(sum) / 2;
}

bool less(const Vec3& p, const Vec3& q) { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); }

class Intersector {
  public:
    Intersector(const Surface& s, const mesh::Mesh& other, double near) : surface_(s), other_(other), near_(near) {
        slack_ = kInPlane * norm(geom::box_of(s.vertices).size());
        double edge = 0, count = 0;
        std::vector<Box3> boxes;
        for (const auto& t : other.triangles) {
            const Corners c = corners(other.vertices, t);
            boxes.push_back(geom::grown(geom::box_of(c), slack_));
            for (std::size_t k = 0; k < 3; ++k) {
                edge += distance(c[k], c[(k + 1) % 3]);
                ++count;
            }
        }
        edge_ = std::max(mean_edge(s), count > 0 ? edge / count : 0);
        if (near_ == 0) near_ = kNear * edge_;
        tree_ = std::make_unique<geom::Bvh>(std::move(boxes));
    }

    Intersection run() {
        for (const Rim& rim : surface_.rims) touch(rim);
        const std::vector<Segment> rims = out_.segments;
        std::vector<Box3> boxes;
        for (const Segment& s : rims) boxes.push_back(around({s.a, s.b}, 0));
        const geom::Bvh along(std::move(boxes));
        const auto beside = [&](const Vec3& p) {
            bool found = false;
            along.visit(around({p}, 2 * near_), [&](std::uint32_t i) {
                found = found || geom::distance(nearest_on(rims[i], p), p) <= 2 * near_;
            });
            return found;
        };
        for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) cross_triangle(t);
        for (const Segment& s : found_)
            if (!beside(s.a) || !beside(s.b)) out_.segments.push_back(s);
        sort_out(rims.size());
        return std::move(out_);
    }

  private:
    static Vec3 nearest_on(const Segment& s, const Vec3& p) {
        return s.a + geom::nearest_parameter(s.a, s.b, p) * (s.b - s.a);
    }

    [[nodiscard]] bool touches(const Vec3& p) const {
        bool found = false;
        tree_->visit(around({p}, near_), [&](std::uint32_t i) {
            const Corners c = corners(other_.vertices, other_.triangles[i]);
            found = found || distance(nearest_in(c[0], c[1], c[2], p), p) <= near_;
        });
        return found;
    }

    // Adds the stretches of the rim that run along the mesh. Stretches that merely pass it are too short.
    void touch(const Rim& rim) {
        std::vector<Segment> near;
        for (const std::uint32_t h : rim.sides) touch(h, near);
        std::vector<std::vector<Segment>> runs;
        for (const Segment& s : near) {
            if (runs.empty() || !goes_on(runs.back().back(), s)) runs.emplace_back();
            runs.back().push_back(s);
        }
        if (runs.size() > 1 && goes_on(runs.back().back(), runs.front().front())) { // across the rim's start
            runs.back().insert(runs.back().end(), runs.front().begin(), runs.front().end());
            runs.erase(runs.begin());
        }
        for (const auto& run : runs) {
            double length = 0;
            for (const Segment& s : run) length += distance(s.a, s.b);
            if (length <= edge_) continue;
            out_.segments.insert(out_.segments.end(), run.begin(), run.end());
            out_.touching += length;
        }
    }

    // Whether `next` continues `s` without a sharp bend; behind a corner the rim soon leaves the mesh.
    static bool goes_on(const Segment& s, const Segment& next) {
        const Vec3 u = s.b - s.a, v = next.b - next.a;
        return s.b == next.a && dot(u, v) > kStraight * norm(u) * norm(v);
    }

    void touch(std::uint32_t h, std::vector<Segment>& near) const {
        const Vec3 a = surface_.vertices[surface_.tail(h)], b = surface_.vertices[surface_.head(h)];
        const auto n = static_cast<int>(std::ceil(kSpotsPerEdge * distance(a, b) / edge_)) + 1;
        Vec3 p = a;
        bool from = touches(p);
        for (int i = 1; i <= n; ++i) {
            const Vec3 q = i < n ? a + static_cast<double>(i) / n * (b - a) : b;
            const bool to = touches(q);
            if (from && to)
                near.push_back({h / 3, p, q});
            else if (from)
                near.push_back({h / 3, p, last(p, q)});
            else if (to)
                near.push_back({h / 3, last(q, p), q});
            p = q;
            from = to;
        }
    }

    // The last touching place between p, which touches the mesh, and q, which does not.
    [[nodiscard]] Vec3 last(Vec3 p, Vec3 q) const {
        for (int i = 0; i < kHalvings; ++i) {
            const Vec3 m = 0.5 * (p + q);
            (touches(m) ? p : q) = m;
        }
        return p;
    }

    void cross_triangle(std::uint32_t t) {
        const Corners c = corners(surface_.vertices, surface_.triangles[t]);
        const Vec3 n = normal_of(c);
        if (n == Vec3{}) return;
        tree_->visit(around({c[0], c[1], c[2]}, slack_), [&](std::uint32_t i) {
            const Corners o = corners(other_.vertices, other_.triangles[i]);
            double side[3];
            for (std::size_t k = 0; k < 3; ++k) {
                side[k] = dot(o[k] - c[0], n);
                if (std::abs(side[k]) <= slack_) side[k] = 0;
            }
            if (side[0] == 0 && side[1] == 0 && side[2] == 0) return lie_flush(t, c, n, o);
            Vec3 ends[2];
            int found = 0;
            for (std::size_t k = 0; k < 3 && found < 2; ++k) {
                const std::size_t next = (k + 1) % 3;
                if (side[k] == 0)
                    ends[found++] = o[k];
                else if (side[k] * side[next] < 0)
                    ends[found++] = o[k] + side[k] / (side[k] - side[next]) * (o[next] - o[k]);
            }
            if (found == 2) add(t, c, n, ends[0], ends[1], cross(normal_of(o), n));
        });
    }

    // Two triangles in one plane: adds the edges of either inside the other.
    void lie_flush(std::uint32_t t, const Corners& c, const Vec3& n, const Corners& o) {
        const Vec3 up = normal_of(o);
        if (up == Vec3{}) return;
        for (std::size_t k = 0; k < 3; ++k) {
            add(t, c, n, o[k], o[(k + 1) % 3], {});
            Vec3 a = c[k], b = c[(k + 1) % 3];
            if (clip(o, up, slack_, a, b)) add(t, c, n, a, b, {});
        }
        out_.flush += common_area(c, n, o);
    }

    // Adds the part of a-b inside the triangle, directed along `way`.
    void add(std::uint32_t t, const Corners& c, const Vec3& n, Vec3 a, Vec3 b, const Vec3& way) {
        a = a - dot(a - c[0], n) * n;
        b = b - dot(b - c[0], n) * n;
        if (less(b, a)) std::swap(a, b); // the same direction for all triangles that share it
        if (!clip(c, n, slack_, a, b)) return;
        if (dot(b - a, way) < 0) std::swap(a, b);
        found_.push_back({t, a, b});
    }

    // Whether the segment is on an inner edge; then the triangle on the other side has it, too.
    [[nodiscard]] bool on_inner_side(const Segment& s) const {
        for (std::uint32_t h = 3 * s.triangle; h < 3 * s.triangle + 3; ++h) {
            const Segment side{0, surface_.vertices[surface_.tail(h)], surface_.vertices[surface_.head(h)]};
            if (surface_.twin[h] != kNone && distance(nearest_on(side, s.a), s.a) <= slack_ &&
                distance(nearest_on(side, s.b), s.b) <= slack_)
                return true;
        }
        return false;
    }

    // Sorts segments by triangle and removes duplicates.
    void sort_out(std::size_t rims) {
        auto& all = out_.segments;
        const auto key = [](const Segment& s) { // independent of the direction
            const Vec3 &p = less(s.a, s.b) ? s.a : s.b, &q = less(s.a, s.b) ? s.b : s.a;
            return std::tie(s.triangle, p.x, p.y, p.z, q.x, q.y, q.z);
        };
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(rims);
        std::stable_sort(begin, all.end(), [&](const Segment& x, const Segment& y) { return key(x) < key(y); });
        all.erase(std::unique(begin, all.end(), [&](const Segment& x, const Segment& y) { return key(x) == key(y); }),
                  all.end());
        for (std::size_t i = rims; i < all.size(); ++i)
            out_.crossing += distance(all[i].a, all[i].b) / (on_inner_side(all[i]) ? 2 : 1);
        std::stable_sort(all.begin(), all.end(),
                         [](const Segment& x, const Segment& y) { return x.triangle < y.triangle; });
    }

    const Surface& surface_;
    const mesh::Mesh& other_;
    double near_, edge_ = 0, slack_ = 0;
    std::unique_ptr<geom::Bvh> tree_;
    std::vector<Segment> found_;
    Intersection out_;
};

} // namespace

Intersection meet(const Surface& s, const mesh::Mesh& other, double near) { return Intersector(s, other, near).run(); }

} // namespace filum::surface
