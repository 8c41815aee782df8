#include "surfpath/plan/refined.hpp"

#include "surface/curve/transfer.hpp"
#include "surface/curve/walk.hpp"
#include "surface/finer.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace filum::surfpath::plan {

namespace {

// The part of a segment that lies in a triangle of the same plane, from parameter `from` to `to`.
struct Clip {
    double from = 0, to = 1;
    std::uint32_t triangle = 0;
};

Clip clip(const Surface& s, std::uint32_t triangle, const Vec3& a, const Vec3& b) {
    auto u = surface::curve::barycentric(s, {triangle, a}), v = surface::curve::barycentric(s, {triangle, b});
    for (auto* w : {&u, &v}) // a point on a side counts as inside
        for (double& x : *w) x = std::abs(x) < rules::kRounding ? 0 : x;
    Clip out{0, 1, triangle};
    for (std::size_t k = 0; k < 3; ++k) {
        if (u[k] < 0 && v[k] <= 0) return {1, 0, triangle};
        if (v[k] < 0 && u[k] <= 0) return {1, 0, triangle};
        if (u[k] < 0) out.from = std::max(out.from, u[k] / (u[k] - v[k]));
        if (v[k] < 0) out.to = std::min(out.to, u[k] / (u[k] - v[k]));
    }
    return out;
}

// Splits a segment at the triangles first to last - 1. Every part goes to one triangle, also where it runs along an
// edge.
void cut(const Surface& s, const surface::Segment& g, std::uint32_t first, std::uint32_t last, surface::Sources& out) {
    std::vector<Clip> clips;
    for (std::uint32_t t = first; t < last; ++t)
        if (const Clip c = clip(s, t, g.a, g.b); c.to > c.from) clips.push_back(c);
    std::sort(clips.begin(), clips.end(), [](const Clip& x, const Clip& y) {
        return x.from != y.from ? x.from < y.from : x.triangle < y.triangle;
    });
    double done = 0;
    Vec3 at = g.a;
    for (std::size_t i = 0; i < clips.size(); ++i) {
        if (!(clips[i].to > done + rules::kRounding)) continue;
        done = clips[i].to;
        const Vec3 to = done > 1 - rules::kRounding ? g.b : g.a + done * (g.b - g.a);
        out.segments.push_back({clips[i].triangle, at, to});
        at = to;
    }
    if (clips.empty()) out.segments.push_back({first, g.a, g.b}); // a point, or outside all triangles by rounding
}

auto xyz(const Vec3& p) { return std::tuple(p.x, p.y, p.z); }

// New numbers of the vertices, sorted by position. Vertices at the same position are sorted by the triangles around
// them.
std::vector<std::uint32_t> by_place(const Surface& s) {
    std::vector<Vec3> about(s.vertices.size());
    for (std::uint32_t v = 0; v < about.size(); ++v)
        surface::each_outgoing(s, v, [&](std::uint32_t h) {
            const auto& [a, b, c] = s.triangles[h / 3];
            about[v] = about[v] + s.vertices[a] + s.vertices[b] + s.vertices[c];
        });
    std::vector<std::uint32_t> order(about.size()), out(about.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto p = xyz(s.vertices[a]), q = xyz(s.vertices[b]);
        return p != q ? p < q : std::tuple(xyz(about[a]), a) < std::tuple(xyz(about[b]), b);
    });
    for (std::uint32_t i = 0; i < order.size(); ++i) out[order[i]] = i;
    return out;
}

// The same sheet with vertices, triangles and sources sorted by position, so that equal surfaces get equal paths for
// any order in the file.
RefinedSheet ordered(const surface::Sheet& given) {
    const Surface& s = given.surface;
    const auto number = by_place(s);
    std::vector<std::array<std::uint32_t, 4>> named; // corners, the smallest number first, and the half-edge from it
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        const std::array<std::uint32_t, 4> t{number[s.tail(h)], number[s.head(h)], number[s.tail(surface::prev(h))], h};
        if (t[0] < t[1] && t[0] < t[2]) named.push_back(t);
    }
    std::sort(named.begin(), named.end());
    RefinedSheet out;
    out.vertex.resize(number.size());
    for (std::uint32_t v = 0; v < number.size(); ++v) out.vertex[number[v]] = v;
    std::vector<std::uint32_t> now(s.twin.size()), twin(s.twin.size()), place(s.triangles.size());
    std::vector<Vec3> vertices(s.vertices.size());
    std::vector<mesh::Triangle> triangles;
    for (std::size_t v = 0; v < number.size(); ++v) vertices[number[v]] = s.vertices[v];
    for (std::uint32_t t = 0; t < named.size(); ++t) {
        const std::uint32_t h = named[t][3];
        triangles.push_back({named[t][0], named[t][1], named[t][2]});
        out.parent.push_back(h / 3);
        place[h / 3] = t;
        now[h] = 3 * t;
        now[surface::next(h)] = 3 * t + 1;
        now[surface::prev(h)] = 3 * t + 2;
    }
    for (std::uint32_t h = 0; h < now.size(); ++h)
        twin[now[h]] = s.twin[h] == surface::kNone ? surface::kNone : now[s.twin[h]];
    out.sheet.surface = surface::assemble(std::move(vertices), std::move(triangles), std::move(twin));
    auto& from = out.sheet.sources;
    for (const std::uint32_t v : given.sources.vertices) from.vertices.push_back(number[v]);
    for (const surface::Segment& g : given.sources.segments) from.segments.push_back({place[g.triangle], g.a, g.b});
    std::sort(from.vertices.begin(), from.vertices.end());
    std::sort(from.segments.begin(), from.segments.end(), [](const auto& x, const auto& y) {
        return std::tuple(xyz(x.a), xyz(x.b), x.triangle) < std::tuple(xyz(y.a), xyz(y.b), y.triangle);
    });
    return out;
}

} // namespace

RefinedSheet refined(const surface::Sheet& given, double edge) {
    auto [sheet, parent, vertex] = ordered(given);
    auto finer = surface::finer(sheet.surface, edge, rules::kMostPieces);
    RefinedSheet out{{std::move(finer.surface), {}, {}, {}, {}, {}, {}}, std::move(finer.parent), std::move(vertex)};
    out.sheet.sources.vertices = sheet.sources.vertices;
    for (const surface::Segment& g : sheet.sources.segments) {
        const auto [first, last] = std::equal_range(out.parent.begin(), out.parent.end(), g.triangle);
        cut(out.sheet.surface, g, static_cast<std::uint32_t>(first - out.parent.begin()),
            static_cast<std::uint32_t>(last - out.parent.begin()), out.sheet.sources);
    }
    for (std::uint32_t& p : out.parent) p = parent[p];
    return out;
}

std::vector<surface::Field> on_refined(const surface::Sheet& given, std::span<const surface::Field> fields,
                                       const RefinedSheet& refined) {
    if (refined.sheet.surface.vertices.size() > refined.vertex.size())
        return surface::curve::transferred(given.surface, fields, refined.sheet.surface);
    std::vector<surface::Field> out;
    for (const surface::Field& field : fields) out.push_back(surface::picked(field, refined.vertex));
    return out;
}

void to_parents(Plan& plan, const RefinedSheet& refined) {
    for (Stroke& stroke : plan.strokes)
        for (Section& piece : stroke.sections)
            for (Place& p : piece.line.places) p.triangle = refined.parent[p.triangle];
}

} // namespace filum::surfpath::plan
