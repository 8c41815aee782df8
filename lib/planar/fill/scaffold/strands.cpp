#include "fill/scaffold/strands.hpp"

#include "geom/polyline.hpp"
#include "geom/segment.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace filum::fill::scaffold {

namespace {

// A place on the boundary: its loop, and its position there, counted in edges from the first point.
struct OnLoop {
    std::size_t loop = 0;
    double at = 0;
    Vec2 point;
    std::uint32_t node = 0;
};

std::vector<std::vector<OnLoop>> hits(const Loops& area, std::span<const double> y) {
    std::vector<std::vector<OnLoop>> out(y.size());
    for (std::size_t l = 0; l < area.size(); ++l) {
        const auto loop = area[l];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
            const double lo = std::min(a.y, b.y), hi = std::max(a.y, b.y);
            for (auto r = std::lower_bound(y.begin(), y.end(), lo); r != y.end() && *r < hi; ++r) {
                const double t = (*r - a.y) / (b.y - a.y);
                out[static_cast<std::size_t>(r - y.begin())].push_back(
                    {l, static_cast<double>(i) + t, {a.x + t * (b.x - a.x), *r}});
            }
        }
    }
    for (auto& row : out)
        std::sort(row.begin(), row.end(), [](const OnLoop& p, const OnLoop& q) { return p.point.x < q.point.x; });
    return out;
}

// The place nearest to p on the loops that carry nodes. Tie: the first.
std::optional<OnLoop> nearest(const Loops& area, std::span<const char> used, Vec2 p) {
    std::optional<OnLoop> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t l = 0; l < area.size(); ++l) {
        const auto loop = area[l];
        for (std::size_t i = 0; used[l] != 0 && i < loop.size(); ++i) {
            const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
            const double t = geom::nearest_parameter(a, b, p);
            const Vec2 q = geom::lerp(a, b, t);
            if (const double d = geom::distance(p, q); d < least)
                least = d, best = OnLoop{l, static_cast<double>(i) + t, q};
        }
    }
    return best;
}

Arc arc_between(std::span<const Vec2> loop, const OnLoop& a, const OnLoop& b) {
    Arc out{a.node, b.node, {a.point}, 0};
    const auto n = static_cast<double>(loop.size());
    const double end = b.at > a.at || (b.at == a.at && b.node > a.node) ? b.at : b.at + n;
    for (double k = std::floor(a.at) + 1; k < end; k += 1)
        out.line.push_back(loop[static_cast<std::size_t>(k) % loop.size()]);
    out.line.push_back(b.point);
    out.length = geom::length(out.line);
    return out;
}

void cut_loops(const Loops& area, std::vector<OnLoop> places, StrandGraph& out) {
    std::sort(places.begin(), places.end(), [](const OnLoop& p, const OnLoop& q) {
        return std::tie(p.loop, p.at, p.node) < std::tie(q.loop, q.at, q.node);
    });
    out.arcs_at.resize(out.node.size());
    for (std::size_t first = 0, last = 0; first < places.size(); first = last) {
        while (last < places.size() && places[last].loop == places[first].loop) ++last;
        for (std::size_t i = first; i < last; ++i) {
            const OnLoop &a = places[i], &b = places[i + 1 < last ? i + 1 : first];
            const auto arc = static_cast<std::uint32_t>(out.arcs.size());
            out.arcs.push_back(arc_between(area[a.loop], a, b));
            out.arcs_at[a.node][1] = out.arcs_at[b.node][0] = arc;
        }
    }
}

} // namespace

StrandGraph strand_graph(const Loops& area, std::span<const double> y, double shortest, std::optional<Vec2> start) {
    StrandGraph out;
    std::vector<OnLoop> places;
    std::vector<char> used(area.size(), 0);
    for (const auto& row : hits(area, y))
        for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
            if (row[i + 1].point.x - row[i].point.x < shortest) continue;
            for (OnLoop end : {row[i], row[i + 1]}) {
                end.node = static_cast<std::uint32_t>(out.node.size());
                used[end.loop] = 1;
                out.node.push_back(end.point);
                places.push_back(end);
            }
            ++out.strands;
        }
    if (start)
        if (auto place = nearest(area, used, *start)) {
            place->node = static_cast<std::uint32_t>(out.node.size());
            out.node.push_back(place->point);
            out.start = place->node;
            places.push_back(*place);
        }
    cut_loops(area, std::move(places), out);
    return out;
}

} // namespace filum::fill::scaffold
