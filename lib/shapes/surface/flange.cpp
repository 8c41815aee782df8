#include "surface/flange.hpp"

#include "surface/rim_room.hpp"
#include "surface/ring_triangles.hpp"

#include <algorithm>
#include <array>

namespace filum::surface {

namespace {

constexpr double kTolerance = 0.1;  // depths of the first band: tolerance for rough rims
constexpr double kLeastDepth = 0.2; // depths of the first band: a shallower flange is left out
constexpr std::size_t kBands = 2;

struct FlangeTriangle {
    Triangle corners;
    char far = 0;
};
using Strip = std::vector<FlangeTriangle>; // between two columns

class FlangeBuilder {
  public:
    FlangeBuilder(const Surface& s, double near, double depth)
        : s_(s), near_(near), room_(s, depth, kTolerance * near), vertices_(s.vertices), least_(depth) {
        for (std::uint32_t v = 0; v < s.vertices.size(); ++v) root_.push_back(v);
    }

    FlangedSurface built() {
        Strip all;
        for (std::size_t rim = 0; rim < s_.rims.size(); ++rim)
            for (const Strip& strip : strips(s_.rims[rim], room_.outline(rim)))
                all.insert(all.end(), strip.begin(), strip.end());
        FlangedSurface out;
        out.far.assign(s_.triangles.size(), 0);
        std::vector<Triangle> triangles;
        for (const FlangeTriangle& t : all) {
            triangles.push_back(t.corners);
            out.far.push_back(t.far);
        }
        drop_unused(triangles);
        out.surface = grown(s_, std::move(vertices_), triangles);
        out.root = std::move(root_);
        out.least = least_;
        out.least_at = least_at_;
        return out;
    }

  private:
    // A row of vertices from the rim outwards; where the flange is shallower the last ones are equal.
    struct Column {
        std::array<std::uint32_t, kBands + 1> vertices{};
        std::size_t edge = 0; // the edge of the outline that begins there
        double deep = 0;
    };

    Column column(const Station& from) {
        const Vec3& p = s_.vertices[from.vertex];
        Column out{{from.vertex, from.vertex, from.vertex}, from.edge, room_.at(from)};
        if (out.deep < kLeastDepth * near_) out.deep = 0;
        see(out.deep, from.vertex);
        const double ends[] = {std::min(near_, out.deep), out.deep};
        for (std::size_t k = 0, before = 0; k < kBands; before = k++) {
            out.vertices[k + 1] = out.vertices[k];
            if (!(ends[k] > (k == 0 ? 0 : ends[before]))) continue;
            out.vertices[k + 1] = static_cast<std::uint32_t>(vertices_.size());
            vertices_.push_back(p + ends[k] * from.out);
            root_.push_back(from.vertex);
        }
        return out;
    }

    // The strips along the rim. Those of a fan around a convex corner depend on each other: all are left out if one of
    // them, or of their neighbours, cannot be placed.
    std::vector<Strip> strips(const Rim& rim, const Outline& outline) {
        std::vector<Column> columns;
        for (const Station& from : outline.stations) columns.push_back(column(from));
        const std::size_t n = columns.size();
        const auto at = [&](std::size_t i) -> const Column& { return columns[i % n]; };
        const auto about_corner = [&](std::size_t i) { return at(i).vertices[0] == at(i + 1).vertices[0]; };
        std::vector<Strip> out;
        for (std::size_t i = 0; i < n; ++i) out.push_back(strip(rim, outline, at(i), at(i + 1)));
        for (std::size_t i = 0, last = 0; i < n; i = last + 1) {
            last = i;
            while (about_corner(last) && last < i + n) ++last;
            bool lie = !out[(i + n - 1) % n].empty();
            for (std::size_t k = i; k <= last; ++k) lie = lie && !out[k % n].empty();
            for (std::size_t k = i; k < last && !lie; ++k) out[k % n].clear();
        }
        for (std::size_t i = 0; i < n; ++i)
            if (out[i].empty()) see(0, at(i).vertices[0]);
        return out;
    }

    // Records the depth of the flange at the vertex.
    void see(double deep, std::uint32_t vertex) {
        if (!(deep < least_)) return;
        least_ = deep;
        least_at_ = s_.vertices[vertex];
    }

    // The strip between two consecutive columns along the rim; empty if a triangle of it would be turned over.
    [[nodiscard]] Strip strip(const Rim& rim, const Outline& outline, const Column& a, const Column& b) const {
        if (a.deep == 0 && b.deep == 0) return {};
        Strip out = first_band(rim, outline.edges[a.edge].side, outline.edges[b.edge].side, a, b);
        const auto add = [&](const Triangle& t) {
            if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) out.push_back({t, 1});
        };
        for (std::size_t k = 1; k < kBands && !out.empty(); ++k) {
            add({b.vertices[k], a.vertices[k], a.vertices[k + 1]});
            add({b.vertices[k], a.vertices[k + 1], b.vertices[k + 1]});
        }
        const Vec3& up = outline.edges[a.edge].up;
        const bool lies = std::all_of(out.begin(), out.end(), [&](const FlangeTriangle& t) {
            const Vec3 &p = vertices_[t.corners[0]], &q = vertices_[t.corners[1]], &r = vertices_[t.corners[2]];
            return dot(cross(q - p, r - p), up) > 0;
        });
        return lies ? out : Strip{};
    }

    // The strip between the first vertices of the columns and the rim, which may have further vertices in between.
    [[nodiscard]] Strip first_band(const Rim& rim, std::size_t from, std::size_t to, const Column& a,
                                   const Column& b) const {
        std::vector<std::uint32_t> ring{a.vertices[0]};
        for (std::size_t k = from; k != to; k = (k + 1) % rim.sides.size()) ring.push_back(s_.head(rim.sides[k]));
        for (const std::uint32_t v : {b.vertices[1], a.vertices[1]})
            if (v != ring.back() && v != ring.front()) ring.push_back(v);
        std::vector<Vec3> points;
        for (const std::uint32_t v : ring) points.push_back(vertices_[v]);
        Strip out;
        for (const auto& [p, q, r] : ring_triangles(points)) out.push_back({{ring[p], ring[q], ring[r]}, 0});
        return out;
    }

    // Removes vertices of columns that no triangle uses.
    void drop_unused(std::vector<Triangle>& triangles) {
        std::vector<std::uint32_t> now(vertices_.size(), kNone);
        for (std::uint32_t v = 0; v < s_.vertices.size(); ++v) now[v] = v;
        for (const Triangle& t : triangles)
            for (const std::uint32_t v : t) now[v] = v;
        std::uint32_t count = 0;
        for (std::uint32_t v = 0; v < now.size(); ++v) {
            if (now[v] == kNone) continue;
            vertices_[count] = vertices_[v];
            root_[count] = root_[v];
            now[v] = count++;
        }
        vertices_.resize(count);
        root_.resize(count);
        for (Triangle& t : triangles)
            for (std::uint32_t& v : t) v = now[v];
    }

    const Surface& s_;
    double near_;
    RimRoom room_;
    std::vector<Vec3> vertices_;
    std::vector<std::uint32_t> root_;
    double least_;
    Vec3 least_at_;
};

} // namespace

FlangedSurface flanged(const Surface& s, double near, double depth) {
    SurfaceWithLids whole = with_lids(s, depth, kTolerance * near);
    FlangedSurface out = FlangeBuilder(whole.surface, near, depth).built();
    out.part = static_cast<std::uint32_t>(s.triangles.size());
    out.lids = std::move(whole.lids);
    return out;
}

} // namespace filum::surface
