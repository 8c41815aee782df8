#include "surfpath/plan/least_strokes.hpp"

#include "geodesic/exact.hpp"
#include "geom/disjoint_sets.hpp"
#include "geom/point_grid.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace filum::surfpath::plan {

namespace {

using surface::kNone;

std::uint32_t component(const Surface& s, std::uint32_t vertex) { return s.component[s.outgoing[vertex] / 3]; }

// One vertex per component; distances are measured from all of them at once.
using Roots = std::vector<std::uint32_t>;

// Distance per vertex; 1-Lipschitz along the surface, also where the computation was cut short: places farther than
// that count as just so far.
std::vector<double> distances(const Surface& s, const Roots& roots) {
    auto out = geodesic::exact_distances(s, {roots, {}}, std::numeric_limits<double>::infinity(), rules::kMostSteps);
    for (double& d : out.distance) d = std::min(d, out.known);
    return std::move(out.distance);
}

// Per component the vertex with the greatest `value`; ties: the first.
template <class Value>
Roots greatest(const Surface& s, const Value& value) {
    Roots out(s.components, kNone);
    for (std::uint32_t v = 0; v < s.vertices.size(); ++v) {
        std::uint32_t& best = out[component(s, v)];
        if (best == kNone || value(v) > value(best)) best = v;
    }
    return out;
}

// Whether rims are within two spacings of each other at places that are farther apart along the rim than cut_length.
// This is necessary for a dead end: its area is less than the fibre for the way in and back, which is twice its depth
// times the spacing; so some level of it is shorter than two spacings. Such a level ends at rims. (It may also be a
// loop around a tube; those are not searched, and the bound is then 0.)
bool has_narrows(const Surface& s, const StrokeBoundOptions& o) {
    struct RimPosition {
        std::size_t rim;
        double along;
    };
    std::vector<Vec3> points;
    std::vector<RimPosition> at;
    std::vector<double> length;
    double all = 0;
    for (const auto& rim : s.rims)
        for (const std::uint32_t h : rim.sides) all += surface::side_length(s, h);
    const double step = std::max(o.spacing / 2, all / rules::kMostPieces), reach = 2 * o.spacing + step;
    for (const auto& rim : s.rims) {
        double along = 0;
        for (const std::uint32_t h : rim.sides) {
            const Vec3 a = s.vertices[s.tail(h)], b = s.vertices[s.head(h)];
            const double l = surface::side_length(s, h), parts = std::ceil(l / step);
            for (double k = 0; k < parts; ++k) {
                points.push_back(a + k / parts * (b - a));
                at.push_back({length.size(), along + l * k / parts});
            }
            along += l;
        }
        length.push_back(along);
    }
    const geom::PointGrid<Vec3> grid(points, reach);
    bool found = false;
    for (std::size_t i = 0; i < points.size() && !found; ++i)
        grid.near(points[i], 1, [&](std::uint32_t j) {
            if (found || distance(points[i], points[j]) > reach) return;
            const double way = std::abs(at[i].along - at[j].along);
            found = at[i].rim != at[j].rim || std::min(way, length[at[i].rim] - way) > o.cut_length;
        });
    return found;
}

// A connected component of the superlevel set {distance > level}, while the level falls.
struct SuperlevelPart {
    double top = 0;       // mm: its greatest distance
    double area = 0;      // mm2 of its triangles
    std::size_t ends = 0; // disjoint dead ends in it
};

// Number of disjoint dead ends per component; of nested dead ends only the smallest counts.
std::vector<std::size_t> dead_ends(const Surface& s, std::span<const double> distance, const StrokeBoundOptions& o) {
    std::vector<std::uint32_t> order(s.vertices.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return distance[a] != distance[b] ? distance[a] > distance[b] : a < b;
    });
    // Triangles at the border of a superlevel set lie outside it by up to half an edge, and strokes need only come
    // within half a spacing of the top.
    const double slack = surface::longest_edge(s) / 2 + o.spacing / 2;
    geom::DisjointSets sets(order.size());
    std::vector<SuperlevelPart> parts(order.size());
    std::vector<char> in(order.size(), 0), counted(s.triangles.size(), 0);
    std::vector<std::size_t> out(s.components, 0);
    for (const std::uint32_t v : order) {
        in[v] = 1;
        SuperlevelPart all{distance[v]};
        std::uint32_t root = v;
        surface::each_outgoing(s, v, [&](std::uint32_t h) {
            if (counted[h / 3] == 0) all.area += surface::area(s, h / 3);
            counted[h / 3] = 1;
            for (const std::uint32_t other : s.triangles[h / 3]) {
                if (in[other] == 0) continue;
                const std::uint32_t its = sets.root(other);
                if (!sets.unite(root, its)) continue;
                all = {std::max(all.top, parts[its].top), all.area + parts[its].area, all.ends + parts[its].ends};
                root = sets.root(v);
            }
        });
        const double there_and_back = 2 * (all.top - distance[v] - slack);
        if (all.ends == 0 && there_and_back - all.area / o.spacing > o.cut_length) {
            all.ends = 1;
            ++out[component(s, v)];
        }
        parts[root] = all;
    }
    return out;
}

} // namespace

std::size_t least_strokes(const Surface& s, std::span<const char> covered, const StrokeBoundOptions& o) {
    std::vector<std::size_t> ends(s.components, 0);
    if (o.dead_ends && has_narrows(s, o)) {
        const auto first = distances(s, greatest(s, [](std::uint32_t) { return 0; }));
        const auto far = distances(s, greatest(s, [&](std::uint32_t v) { return first[v]; }));
        const auto back = distances(s, greatest(s, [&](std::uint32_t v) { return far[v]; }));
        const auto middle = distances(s, greatest(s, [&](std::uint32_t v) { return -std::max(far[v], back[v]); }));
        for (const auto* distance : {&far, &middle}) {
            const auto found = dead_ends(s, *distance, o);
            for (std::size_t c = 0; c < ends.size(); ++c) ends[c] = std::max(ends[c], found[c]);
        }
    }
    std::size_t out = 0;
    for (std::size_t c = 0; c < ends.size(); ++c)
        if (covered[c] != 0) out += std::max<std::size_t>(1, (ends[c] + 1) / 2);
    return out;
}

void report_cuts_bound(const Surface& s, const StrokeBoundOptions& o, Plan& plan) {
    std::vector<char> covered(s.components, 0);
    for (const Stroke& stroke : plan.strokes)
        for (const Section& piece : stroke.sections)
            if (piece.line.size() > 0) covered[s.component[piece.line.places[0].triangle]] = 1;
    const auto least = least_strokes(s, covered, o);
    plan.facts.push_back({"", "cuts-bound", least > 0 ? static_cast<double>(least - 1) : 0, ""});
}

} // namespace filum::surfpath::plan
