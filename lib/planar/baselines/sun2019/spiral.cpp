#include "baselines/sun2019/spiral.hpp"

#include "baselines/sun2019/contour_graph.hpp"
#include "geom/principal_axis.hpp"
#include "polygon/inset.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::baselines::sun2019 {

using geom::Vec2;

namespace {

// The place on a ring `along` mm behind vertex `vertex`, which may be beyond the edge.
Vec2 walk(const Ring& ring, std::size_t vertex, double along, std::size_t* stop = nullptr) {
    for (std::size_t guard = 0; guard <= ring.size(); ++guard, ++vertex) {
        const Vec2 a = ring[vertex % ring.size()], b = ring[(vertex + 1) % ring.size()];
        const double length = geom::distance(a, b);
        if (stop != nullptr) *stop = vertex;
        if (along <= length) return length > 0 ? geom::lerp(a, b, along / length) : a;
        along -= length;
    }
    return ring[vertex % ring.size()];
}

// The ring as an open line, counter-clockwise, without `gap` mm around its vertex `at`.
Ring opened(const Ring& ring, std::size_t at, double gap) {
    const double length = polygon::perimeter(ring);
    gap = std::min(gap, length / 3);
    std::size_t first = 0, last = 0;
    Ring out{walk(ring, at, gap / 2, &first)};
    const Vec2 end = walk(ring, at, length - gap / 2, &last);
    for (std::size_t k = first + 1; k <= last; ++k) out.push_back(ring[k % ring.size()]);
    out.push_back(end);
    return out;
}

std::size_t nearest_vertex(std::span<const Vec2> points, Vec2 p) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (geom::norm2(points[i] - p) < geom::norm2(points[best] - p)) best = i;
    return best;
}

// One path over a chain of contours: odd ones inwards, even ones back (section 3.2, Figure 5a).
Ring chain_path(const std::vector<const Ring*>& chain, std::size_t start, double gap) {
    std::vector<Ring> lanes;
    std::size_t at = start;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        if (i > 0) at = nearest_vertex(*chain[i], (*chain[i - 1])[at]);
        lanes.push_back(opened(*chain[i], at, gap));
    }
    Ring path;
    for (std::size_t i = 0; i < lanes.size(); i += 2) path.insert(path.end(), lanes[i].begin(), lanes[i].end());
    for (std::size_t i = lanes.size() / 2; i-- > 0;)
        path.insert(path.end(), lanes[2 * i + 1].rbegin(), lanes[2 * i + 1].rend());
    return path;
}

// Inserts the child's path into the parent's, between two neighbouring vertices.
void insert(Ring& parent, const Ring& child) {
    const Vec2 a = child.front(), b = child.back();
    const std::size_t near = nearest_vertex(parent, geom::lerp(a, b, 0.5));
    double best = std::numeric_limits<double>::infinity();
    std::size_t at = 0;
    bool reversed = false;
    for (const std::size_t first : {near, near - 1}) {
        if (first >= parent.size() || first + 1 >= parent.size()) continue;
        const Vec2 p = parent[first], q = parent[first + 1];
        const double forth = geom::distance(p, a) + geom::distance(b, q);
        const double back = geom::distance(p, b) + geom::distance(a, q);
        if (std::min(forth, back) >= best) continue;
        best = std::min(forth, back);
        at = first;
        reversed = back < forth;
    }
    const auto place = parent.begin() + static_cast<std::ptrdiff_t>(at) + 1;
    if (reversed)
        parent.insert(place, child.rbegin(), child.rend());
    else
        parent.insert(place, child.begin(), child.end());
}

// The chain that starts at `node`: contours with one child each, and the one that ends it.
std::vector<int> chain_from(const std::vector<Node>& nodes, int node) {
    std::vector<int> chain{node};
    while (nodes[static_cast<std::size_t>(chain.back())].children.size() == 1)
        chain.push_back(nodes[static_cast<std::size_t>(chain.back())].children[0]);
    return chain;
}

// The path of a chain and of everything below it; children first. An explicit stack is used, since chains nest as
// deeply as the tree branches.
Ring path_below(const std::vector<Ring>& rings, const std::vector<Node>& nodes, int root, std::size_t start,
                double gap) {
    struct Visit {
        std::vector<int> chain;
        std::size_t next = 0; // index of the child to be inserted
        Ring path;
    };
    std::vector<Visit> stack;
    const auto enter = [&](int node, std::size_t at) {
        Visit v{chain_from(nodes, node), 0, {}};
        std::vector<const Ring*> chain;
        for (const int c : v.chain) chain.push_back(&rings[static_cast<std::size_t>(c)]);
        v.path = chain_path(chain, at, gap);
        stack.push_back(std::move(v));
    };
    enter(root, start);
    while (true) {
        Visit& v = stack.back();
        const auto& children = nodes[static_cast<std::size_t>(v.chain.back())].children;
        if (v.next < children.size()) {
            const int child = children[v.next++];
            enter(child, nodes[static_cast<std::size_t>(child)].start);
            continue;
        }
        Ring done = std::move(v.path);
        stack.pop_back();
        if (stack.empty()) return done;
        insert(stack.back().path, done);
    }
}

// The vertex nearest to where the axis of greatest variance of all samples leaves the outer contour (Figure 6).
std::size_t pca_start(const std::vector<Ring>& rings) {
    Ring all;
    for (const Ring& ring : rings) all.insert(all.end(), ring.begin(), ring.end());
    const auto at = geom::leaves(geom::principal_axis(all), rings.front());
    return at ? nearest_vertex(rings.front(), *at) : 0;
}

// The vertex `shift` mm along the ring from `at`.
std::size_t shifted(const Ring& ring, std::size_t at, double shift) {
    const double length = polygon::perimeter(ring);
    const double along = shift - std::floor(shift / length) * length;
    std::size_t stop = at;
    walk(ring, at, along, &stop);
    return stop % ring.size();
}

} // namespace

std::vector<toolpath::Curve> spiral(const polygon::Loops& region, const SpiralOptions& o, Notes& notes) {
    const double first = o.first * o.offset;
    polygon::note_unplaced(region, polygon::inset(polygon::inset(region, first), -first), o.offset, notes);
    const auto rings = contours(region, o);
    std::vector<toolpath::Curve> out;
    if (rings.empty()) return out;
    const auto nodes = tree(rings.size(), adjacency(rings, o.threshold * o.offset));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].parent >= 0) continue;
        const std::size_t start = i == 0 ? shifted(rings[0], pca_start(rings), o.start_shift) : 0;
        auto path = path_below(rings, nodes, static_cast<int>(i), start, o.offset);
        out.push_back({false, std::move(path), {o.offset}});
    }
    return out;
}

fill::Reuse filler(const SpiralOptions& options) {
    const auto of_layer = [shift = options.start_shift](std::uint32_t layer) { return shift * layer; };
    const auto lay = [options, of_layer](const polygon::Region& region, Notes& notes) {
        SpiralOptions here = options;
        here.start_shift = of_layer(region.layer);
        return spiral(region.loops, here, notes);
    };
    return {[lay](const polygon::Region& region, Notes& notes) { return fill::fill_by(lay, region, notes); }, of_layer};
}

} // namespace filum::baselines::sun2019
