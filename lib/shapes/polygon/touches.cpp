#include "polygon/touches.hpp"

#include "geom/segment_grid.hpp"
#include "polygon/inside_test.hpp"
#include "polygon/segments.hpp"
#include "polygon/simple.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace filum::polygon {

namespace {

// A vertex on the grid.
struct Vertex {
    std::int64_t x, y;
    friend bool operator==(const Vertex&, const Vertex&) = default;
};

Vertex vertex(Vec2 p) { return {std::llround(p.x * kGridPerMm), std::llround(p.y * kGridPerMm)}; }

struct VertexHash {
    std::size_t operator()(const Vertex& v) const {
        const auto x = static_cast<std::uint64_t>(v.x), y = static_cast<std::uint64_t>(v.y);
        std::uint64_t h = (x * 0x9E3779B97F4A7C15ULL) ^ (y * 0xC2B2AE3D27D4EB4FULL);
        h ^= h >> 32U;
        return static_cast<std::size_t>(h * 0xD6E8FEB86659FD93ULL);
    }
};

// Whether p lies on the edge a-b, but not at its ends.
bool lies_inside(const Vertex& a, const Vertex& b, const Vertex& p) {
    if (p == a || p == b) return false;
    if (p.x < std::min(a.x, b.x) || p.x > std::max(a.x, b.x) || p.y < std::min(a.y, b.y) || p.y > std::max(a.y, b.y))
        return false;
    return static_cast<__int128>(b.x - a.x) * (p.y - a.y) == static_cast<__int128>(b.y - a.y) * (p.x - a.x);
}

// A vertex that lies on an edge of its own loop.
struct Touch {
    std::uint32_t edge;
    double along; // squared distance from the edge's begin
    Vec2 at;
};

// All touches, sorted by edge and along each edge.
std::vector<Touch> touches(const Loops& a) {
    const auto edges = segments(a);
    double length = 0;
    for (const auto& e : edges) length += geom::distance(e.a, e.b);
    const geom::SegmentGrid grid(edges, std::max(kGridStep, length / static_cast<double>(edges.size())));
    std::vector<Touch> out;
    for (std::size_t l = 0; l < a.size(); ++l)
        for (const Vec2 p : a[l]) {
            const Vertex v = vertex(p);
            const std::size_t before = out.size();
            const Vec2 margin{kGridStep, kGridStep};
            grid.near(p - margin, p + margin, [&](std::uint32_t e) {
                if (e < a.start[l] || e >= a.start[l + 1]) return;
                if (!lies_inside(vertex(edges[e].a), vertex(edges[e].b), v)) return;
                for (std::size_t k = before; k < out.size(); ++k)
                    if (out[k].edge == e) return; // found in another cell already
                out.push_back({e, geom::norm2(p - edges[e].a), p});
            });
        }
    std::sort(out.begin(), out.end(), [](const Touch& s, const Touch& t) {
        return s.edge < t.edge || (s.edge == t.edge && s.along < t.along);
    });
    return out;
}

// Adds the loop, split into loops that pass no vertex twice.
void add_parted(const std::vector<Vec2>& loop, Loops& out) {
    std::vector<Vec2> open; // the points since the last closed loop, none of them twice
    std::unordered_map<Vertex, std::size_t, VertexHash> place(2 * loop.size());
    const auto close = [&](std::size_t from) {
        if (open.size() - from >= 3) out.add(std::span(open).subspan(from));
        for (std::size_t k = from; k < open.size(); ++k) place.erase(vertex(open[k]));
        open.resize(from);
    };
    for (const Vec2 p : loop) {
        const auto [it, fresh] = place.try_emplace(vertex(p), open.size());
        if (!fresh) {
            const std::size_t from = it->second;
            close(from);
            place.emplace(vertex(p), open.size());
        }
        open.push_back(p);
    }
    close(0);
}

} // namespace

Loops parted_at_touches(const Loops& a) {
    if (a.points.empty()) return a;
    const std::vector<Touch> all = touches(a);
    auto touch = all.begin();
    Loops out;
    std::vector<Vec2> loop;
    for (std::size_t l = 0; l < a.size(); ++l) {
        loop.clear();
        for (std::uint32_t i = a.start[l]; i < a.start[l + 1]; ++i) {
            loop.push_back(a.points[i]);
            for (; touch != all.end() && touch->edge == i; ++touch) loop.push_back(touch->at);
        }
        add_parted(loop, out);
    }
    return out;
}

std::optional<std::vector<int>> nesting_of_touching(const Loops& a) {
    constexpr double kSomewhere = 0.381966; // golden section, because rows and squares touch edges at simple fractions
    struct Outline {
        Box2 box;
        double area;
        Vec2 point; // on the longest edge, where other loops rarely touch it
        std::optional<InsideTest> inside;
    };
    std::vector<Outline> all;
    for (std::size_t l = 0; l < a.size(); ++l) {
        const auto loop = a[l];
        Outline o{bounds(loop), signed_area(loop), {}, {}};
        double longest = -1;
        for (std::size_t j = 0, k = loop.size() - 1; j < loop.size(); k = j++)
            if (const double length = geom::norm2(loop[j] - loop[k]); length > longest) {
                longest = length;
                o.point = geom::lerp(loop[k], loop[j], kSomewhere);
            }
        all.push_back(std::move(o));
    }
    std::vector<int> within(a.size(), -1);
    for (std::size_t l = 0; l < a.size(); ++l) {
        double smallest = std::numeric_limits<double>::infinity();
        for (std::size_t m = 0; m < a.size(); ++m) {
            const double area = std::abs(all[m].area);
            const Vec2 p = all[l].point;
            const Box2& box = all[m].box;
            if (m == l || area >= smallest || area <= std::abs(all[l].area) || p.x < box.lo.x || p.x > box.hi.x ||
                p.y < box.lo.y || p.y > box.hi.y)
                continue;
            if (!all[m].inside) {
                Loops one;
                one.add(a[m]);
                all[m].inside.emplace(one);
            }
            if (!(*all[m].inside)(p)) continue;
            smallest = area;
            within[l] = static_cast<int>(m);
        }
    }
    for (std::size_t l = 0; l < a.size(); ++l)
        if ((all[l].area > 0) == (within[l] >= 0 && all[static_cast<std::size_t>(within[l])].area > 0))
            return std::nullopt;
    return within;
}

} // namespace filum::polygon
