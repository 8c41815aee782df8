#include "polygon/clusters.hpp"

#include "geom/disjoint_sets.hpp"
#include "polygon/segments.hpp"

#include <algorithm>
#include <cmath>

namespace filum::polygon {

namespace {

using geom::Segment;

constexpr std::size_t kOnePiece = 2000; // points that one operation takes in a millisecond or two
constexpr double kFrameGap = 1;         // mm between a cluster with its reach and the frames around it

// The loops of all inputs, numbered one input after the other.
struct AllLoops {
    std::vector<Segment> edges;
    std::vector<std::uint32_t> loop;  // of each edge
    std::vector<std::uint32_t> input; // of each loop

    explicit AllLoops(std::span<const Loops> inputs) {
        for (std::uint32_t i = 0; i < inputs.size(); ++i) {
            const auto more = segments(inputs[i]);
            edges.insert(edges.end(), more.begin(), more.end());
            for (std::size_t l = 0; l < inputs[i].size(); ++l) {
                loop.insert(loop.end(), inputs[i][l].size(), static_cast<std::uint32_t>(input.size()));
                input.push_back(i);
            }
        }
    }
};

// The cluster of each loop, and their number.
std::size_t find_clusters(const AllLoops& all, double reach, std::vector<std::uint32_t>& cluster) {
    geom::DisjointSets sets(all.input.size());
    const geom::SegmentGrid grid(all.edges, geom::cell_for(all.edges, reach), reach);
    for (std::uint32_t e = 0; e < all.edges.size() && sets.sets() > 1; ++e) {
        const Segment& s = all.edges[e];
        grid.along(s.a, s.b, [&](std::uint32_t f) {
            if (f <= e || all.loop[e] == all.loop[f]) return;
            if (sets.root(all.loop[e]) == sets.root(all.loop[f])) return;
            const Segment& t = all.edges[f];
            if (geom::segment_distance(s.a, s.b, t.a, t.b) <= reach) sets.unite(all.loop[e], all.loop[f]);
        });
    }
    return sets.number(cluster);
}

struct Cluster {
    std::vector<Loops> inputs;
    std::vector<int> winding; // of the loops of each input outside the cluster
    Box2 box;
};

// Counts how often the edges of other clusters wind around each cluster: the edges that a ray to the right from a point
// of the cluster crosses upwards, less those that it crosses downwards.
void count_winding(const AllLoops& all, const std::vector<std::uint32_t>& cluster, std::vector<Cluster>& clusters) {
    struct Probe {
        Vec2 p;
        std::uint32_t cluster;
    };
    std::vector<Probe> probes;
    for (std::uint32_t e = 0; e < all.edges.size(); ++e)
        if (const std::uint32_t c = cluster[all.loop[e]]; c == probes.size()) probes.push_back({all.edges[e].a, c});
    std::sort(probes.begin(), probes.end(), [](const Probe& a, const Probe& b) { return a.p.y < b.p.y; });
    const auto below = [](const Probe& probe, double y) { return probe.p.y < y; };
    for (std::uint32_t e = 0; e < all.edges.size(); ++e) {
        const auto [a, b] = all.edges[e];
        const double high = std::max(a.y, b.y);
        auto at = std::lower_bound(probes.begin(), probes.end(), std::min(a.y, b.y), below);
        for (; at != probes.end() && at->p.y < high; ++at) {
            if (at->cluster == cluster[all.loop[e]]) continue;
            if (a.x + (b.x - a.x) * (at->p.y - a.y) / (b.y - a.y) <= at->p.x) continue;
            clusters[at->cluster].winding[all.input[all.loop[e]]] += b.y > a.y ? 1 : -1;
        }
    }
}

void add_frame(Loops& out, Box2 box, double by, bool positive) {
    box.lo = box.lo - Vec2{by, by};
    box.hi = box.hi + Vec2{by, by};
    std::vector<Vec2> frame{box.lo, {box.hi.x, box.lo.y}, box.hi, {box.lo.x, box.hi.y}};
    if (!positive) std::reverse(frame.begin(), frame.end());
    out.add(frame);
}

// Adds the result for one cluster without the outlines of its frames.
void add_result(Cluster cluster, double reach, const Operation& operation, Loops& out) {
    for (std::size_t i = 0; i < cluster.inputs.size(); ++i) // frames never touch each other
        for (int k = 0; k < std::abs(cluster.winding[i]); ++k)
            add_frame(cluster.inputs[i], cluster.box, (k + 1) * (2 * reach + kFrameGap), cluster.winding[i] > 0);
    const Loops result = operation(cluster.inputs);
    const double most = reach + kFrameGap / 2;
    for (std::size_t l = 0; l < result.size(); ++l) {
        const Box2 box = bounds(result[l]);
        if (box.lo.x >= cluster.box.lo.x - most && box.lo.y >= cluster.box.lo.y - most &&
            box.hi.x <= cluster.box.hi.x + most && box.hi.y <= cluster.box.hi.y + most)
            out.add(result[l]);
    }
}

} // namespace

Loops clustered(std::span<const Loops> inputs, double reach, const Operation& operation) {
    std::size_t points = 0, loops = 0;
    for (const Loops& a : inputs) {
        points += a.points.size();
        loops += a.size();
    }
    if (points <= kOnePiece || loops < 2) return operation(inputs);
    const AllLoops all(inputs);
    std::vector<std::uint32_t> cluster;
    const std::size_t n = find_clusters(all, reach, cluster);
    if (n < 2) return operation(inputs);
    std::vector<Cluster> clusters(n, {std::vector<Loops>(inputs.size()), std::vector<int>(inputs.size(), 0), {}});
    for (std::size_t i = 0, l = 0; i < inputs.size(); ++i)
        for (std::size_t k = 0; k < inputs[i].size(); ++k, ++l) {
            clusters[cluster[l]].inputs[i].add(inputs[i][k]);
            for (const Vec2 p : inputs[i][k]) clusters[cluster[l]].box.add(p);
        }
    count_winding(all, cluster, clusters);
    Loops out;
    for (Cluster& c : clusters) add_result(std::move(c), reach, operation, out);
    return out;
}

} // namespace filum::polygon
