#include "surfpath/fine.hpp"

#include "surface/curve/walk.hpp"
#include "surface/finer.hpp"

#include <algorithm>

namespace filum::surfpath {

namespace {

constexpr std::size_t kMostFine = 500'000; // triangles
constexpr double kCrumb = 1e-9;            // of a segment: less of it is none

// The part of a segment that lies in a triangle of its plane: where along it that begins and ends.
struct Clip {
    double from = 0, to = 1;
    std::uint32_t triangle = 0;
};

Clip clip(const Surface& s, std::uint32_t triangle, const Vec3& a, const Vec3& b) {
    const auto u = surface::curve::barycentric(s, {triangle, a}), v = surface::curve::barycentric(s, {triangle, b});
    Clip out{0, 1, triangle};
    for (std::size_t k = 0; k < 3; ++k) {
        if (u[k] < 0 && v[k] <= 0) return {1, 0, triangle};
        if (v[k] < 0 && u[k] <= 0) return {1, 0, triangle};
        if (u[k] < 0) out.from = std::max(out.from, u[k] / (u[k] - v[k]));
        if (v[k] < 0) out.to = std::min(out.to, u[k] / (u[k] - v[k]));
    }
    return out;
}

// The segment in pieces, each in one of the triangles: none twice, even where it runs between two of them.
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
        if (!(clips[i].to > done + kCrumb)) continue;
        done = clips[i].to;
        const Vec3 to = done > 1 - kCrumb ? g.b : g.a + done * (g.b - g.a);
        out.segments.push_back({clips[i].triangle, at, to});
        at = to;
    }
    if (clips.empty()) out.segments.push_back({first, g.a, g.b}); // a point, or beside all by rounding
}

} // namespace

Fine fine(const surface::Sheet& sheet, double edge) {
    auto finer = surface::finer(sheet.surface, edge, kMostFine);
    Fine out{{std::move(finer.surface), {}, {}, {}, {}, {}, {}}, std::move(finer.parent)};
    out.sheet.sources.vertices = sheet.sources.vertices;
    for (const surface::Segment& g : sheet.sources.segments) {
        const auto [first, last] = std::equal_range(out.parent.begin(), out.parent.end(), g.triangle);
        cut(out.sheet.surface, g, static_cast<std::uint32_t>(first - out.parent.begin()),
            static_cast<std::uint32_t>(last - out.parent.begin()), out.sheet.sources);
    }
    return out;
}

void back(Plan& plan, const Fine& fine) {
    for (Stroke& stroke : plan.strokes)
        for (Piece& piece : stroke.pieces)
            for (Place& p : piece.line.places) p.triangle = fine.parent[p.triangle];
}

} // namespace filum::surfpath
