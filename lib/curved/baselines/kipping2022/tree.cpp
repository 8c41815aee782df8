#include "baselines/kipping2022/tree.hpp"

#include "base/error.hpp"
#include "baselines/kipping2022/path.hpp"
#include "geom/disjoint_sets.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace filum::baselines::kipping2022 {

namespace {

constexpr double kOuter = 1.5; // d: largest distance of the outermost contour from its rim

// The least distance between points of the two contours.
double gap(const Node& a, const Node& b) {
    const bool swap = a.points().size() > b.points().size();
    const Node &few = swap ? b : a, &many = swap ? a : b;
    double out = std::numeric_limits<double>::infinity();
    for (const Vec3& p : few.points()) out = std::min(out, many.cloud.nearest(p, out).distance);
    return out;
}

struct Edge {
    double weight;
    std::uint32_t a, b; // a < b
    friend bool operator<(const Edge& x, const Edge& y) {
        return std::tie(x.weight, x.a, x.b) < std::tie(y.weight, y.a, y.b);
    }
};

// All pairs of contours of one component at neighbouring levels.
std::vector<Edge> edges(const std::vector<Node>& nodes) {
    std::vector<Edge> out;
    for (std::uint32_t a = 0; a < nodes.size(); ++a)
        for (std::uint32_t b = a + 1; b < nodes.size(); ++b) {
            if (nodes[b].contour.level > nodes[a].contour.level + 1) break;
            if (nodes[b].contour.level == nodes[a].contour.level || nodes[a].component != nodes[b].component) continue;
            out.push_back({gap(nodes[a], nodes[b]), a, b});
        }
    std::sort(out.begin(), out.end());
    return out;
}

// Kruskal's minimum spanning trees.
void span(std::vector<Node>& nodes) {
    geom::DisjointSets sets(nodes.size());
    for (const Edge& e : edges(nodes)) {
        if (!sets.unite(e.a, e.b)) continue;
        nodes[e.a].neighbours.push_back(e.b);
        nodes[e.b].neighbours.push_back(e.a);
    }
    for (Node& n : nodes) std::sort(n.neighbours.begin(), n.neighbours.end());
}

// The outermost contour of every component; kNone where there is none.
std::vector<std::uint32_t> outermost(const Surface& s, const std::vector<Node>& nodes, double spacing) {
    std::vector<std::uint32_t> best(s.components, surface::kNone);
    std::vector<std::pair<bool, double>> rank(s.components, {false, -1});
    std::vector<Points> rims(s.components);
    for (const surface::Rim& rim : s.rims)
        if (rim.outer)
            for (const std::uint32_t h : rim.sides) rims[rim.component].push_back(s.vertices[s.tail(h)]);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        const Node& n = nodes[i];
        if (n.contour.level != nodes.front().contour.level) break;
        double near = std::numeric_limits<double>::infinity();
        for (const Vec3& p : rims[n.component]) near = std::min(near, n.cloud.nearest(p, near).distance);
        const std::pair<bool, double> now{near <= kOuter * spacing, length(n.points(), true)};
        if (now > rank[n.component]) {
            rank[n.component] = now;
            best[n.component] = i;
        }
    }
    return best;
}

std::vector<std::uint32_t> roots(const Surface& s, const std::vector<Node>& nodes, double spacing) {
    const auto outer = outermost(s, nodes, spacing);
    std::vector<std::uint32_t> out;
    std::vector<char> seen(nodes.size(), 0);
    const auto start = [&](std::uint32_t root) {
        out.push_back(root);
        std::vector<std::uint32_t> open{root};
        seen[root] = 1;
        while (!open.empty()) {
            const std::uint32_t n = open.back();
            open.pop_back();
            for (const std::uint32_t m : nodes[n].neighbours)
                if (seen[m]++ == 0) open.push_back(m);
        }
    };
    for (const std::uint32_t root : outer)
        if (root != surface::kNone) start(root);
    for (std::uint32_t n = 0; n < nodes.size(); ++n)
        if (seen[n] == 0) start(n);
    return out;
}

// Checks that rims are sources. Only middles of sides are tested, since distances by the heat method are not exactly 0
// at sources.
void check_rims(const surface::Sheet& sheet, const std::vector<double>& phi, double spacing) {
    const Surface& s = sheet.surface;
    if (s.rims.empty())
        throw Error(Exit::bad_input, "cannot lay rings on a closed surface: it has no rim; cut it open with "
                                     "geodesic --cut");
    const auto less = [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
    Points ends;
    for (const auto& segment : sheet.sources.segments) {
        ends.push_back(segment.a);
        ends.push_back(segment.b);
    }
    for (const std::uint32_t v : sheet.sources.vertices) ends.push_back(s.vertices[v]);
    std::sort(ends.begin(), ends.end(), less);
    for (const surface::Rim& rim : s.rims)
        for (const std::uint32_t h : rim.sides) {
            const std::uint32_t v = s.tail(h);
            if (phi[v] >= spacing && std::isfinite(phi[v]) &&
                !std::binary_search(ends.begin(), ends.end(), s.vertices[v], less))
                throw Error(Exit::usage, "the distance is not measured from all rims; run geodesic "
                                         "--source boundary first");
        }
}

} // namespace

Tree tree(const surface::Sheet& sheet, const std::vector<double>& phi, const Options& o, Notes& notes) {
    const Surface& s = sheet.surface;
    check_rims(sheet, phi, o.spacing);
    Tree out;
    for (auto& level : contours(s, phi, o.spacing, o.resample, notes))
        for (Contour& c : level) {
            if (!c.closed) {
                notes.push_back(lines_note(NoteCode::isocontour_at_rim, length(c.points, false), c.points[0]));
                continue;
            }
            geom::PointTree cloud(resampled(c.points, true, o.resample));
            c.points.clear();
            const std::uint32_t component = s.component[c.triangle];
            out.nodes.push_back({std::move(c), std::move(cloud), component});
        }
    if (out.nodes.empty())
        throw Error(Exit::usage, "there is no ring: no place is a spacing away from the rims; lower --spacing");
    span(out.nodes);
    out.roots = roots(s, out.nodes, o.spacing);
    return out;
}

} // namespace filum::baselines::kipping2022
