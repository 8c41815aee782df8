#include "regions/nesting.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

namespace filum::regions {

namespace {

using geom::Vec2;

// Whether a is left of b, or below b if x is equal. All points are grid points: whole numbers below 1e12, exact in a
// double, and so are their differences.
bool before(Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

// The sign of orient(a, b, c), exact.
int side(Vec2 a, Vec2 b, Vec2 c) {
    const double l = (b.x - a.x) * (c.y - a.y), r = (b.y - a.y) * (c.x - a.x), d = l - r;
    if (std::abs(d) > 1e-15 * (std::abs(l) + std::abs(r))) return d > 0 ? 1 : -1;
    const auto whole = [](double v) { return static_cast<__int128>(static_cast<std::int64_t>(v)); };
    const __int128 e = whole(b.x - a.x) * whole(c.y - a.y) - whole(b.y - a.y) * whole(c.x - a.x);
    return e > 0 ? 1 : e < 0 ? -1 : 0;
}

// Whether the closed segments a-b and c-d share a point; each is given with its lesser end first.
bool touch(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const int p = side(a, b, c), q = side(a, b, d), r = side(c, d, a), s = side(c, d, b);
    if (p == 0 && q == 0) return !before(b, c) && !before(d, a); // collinear: do the intervals meet?
    return p * q <= 0 && r * s <= 0;
}

// An edge from `from` to its loop's next vertex; `lo` is its lesser end.
struct Edge {
    Vec2 lo, hi;
    std::uint32_t loop = 0;
    bool rightwards = false; // it runs from lo to hi
};

// An edge that the sweep line crosses. A chain of edges that continues to the right keeps its node; only the edge in it
// changes, not its place.
struct Node {
    mutable std::uint32_t edge;
};

struct Below {
    const std::vector<Edge>* edges;
    using is_transparent = void;
    [[nodiscard]] bool point_above(const Node& n, Vec2 p) const {
        const Edge& e = (*edges)[n.edge];
        return side(e.lo, e.hi, p) > 0;
    }
    bool operator()(const Node& n, Vec2 p) const { return point_above(n, p); }
    bool operator()(Vec2 p, const Node& n) const {
        const Edge& e = (*edges)[n.edge];
        return side(e.lo, e.hi, p) < 0;
    }
    // Compares two nodes, which happens only at insertion. Both edges cross the upright line through the newer one's
    // lesser end.
    bool operator()(const Node& m, const Node& n) const {
        const Edge &e = (*edges)[m.edge], &f = (*edges)[n.edge];
        if (e.lo == f.lo) return side(e.lo, e.hi, f.hi) > 0;
        return before(e.lo, f.lo) ? side(e.lo, e.hi, f.lo) > 0 : side(f.lo, f.hi, e.lo) < 0;
    }
};

class Sweep {
  public:
    explicit Sweep(const polygon::Loops& loops);
    std::optional<std::vector<int>> run();

  private:
    using Status = std::set<Node, Below>;
    bool open(std::uint32_t v);
    bool close(std::uint32_t v);
    bool pass(std::uint32_t in, std::uint32_t out);
    [[nodiscard]] bool clash(Status::iterator lower, Status::iterator upper) const;
    void place(std::uint32_t loop, Status::iterator at);

    std::vector<Vec2> point_;
    std::vector<Edge> edge_;              // edge i starts at point i
    std::vector<std::uint32_t> previous_; // the edge that ends at point i
    std::vector<double> area_;            // per loop; only its sign is used
    std::vector<int> parent_;
    std::vector<char> placed_;
    Status status_;
    std::vector<Status::iterator> where_; // per edge, while it is in the status
};

Sweep::Sweep(const polygon::Loops& loops) : status_(Below{&edge_}) {
    const std::size_t n = loops.points.size();
    point_.resize(n);
    for (std::size_t i = 0; i < n; ++i)
        point_[i] = {std::round(loops.points[i].x * 1e4), std::round(loops.points[i].y * 1e4)};
    edge_.resize(n);
    previous_.resize(n);
    where_.resize(n);
    for (std::uint32_t l = 0; l < loops.size(); ++l) {
        const std::uint32_t first = loops.start[l], last = loops.start[l + 1];
        for (std::uint32_t i = first; i < last; ++i) {
            const std::uint32_t next = i + 1 < last ? i + 1 : first;
            const bool right = before(point_[i], point_[next]);
            edge_[i] = {right ? point_[i] : point_[next], right ? point_[next] : point_[i], l, right};
            previous_[next] = i;
        }
        area_.push_back(polygon::signed_area(loops[l]));
    }
    parent_.assign(loops.size(), -1);
    placed_.assign(loops.size(), 0);
}

bool Sweep::clash(Status::iterator lower, Status::iterator upper) const {
    const Edge &a = edge_[lower->edge], &b = edge_[upper->edge];
    if (a.hi == b.hi && a.lo == b.lo) return true;
    if (a.lo == b.lo) return side(a.lo, a.hi, b.hi) == 0;
    if (a.hi == b.hi) return side(a.lo, a.hi, b.lo) == 0;
    return touch(a.lo, a.hi, b.lo, b.hi);
}

// Finds the loop around a loop. The first vertex of a loop in the sweep opens two edges, and the edge below it shows
// which loop surrounds it.
void Sweep::place(std::uint32_t loop, Status::iterator at) {
    placed_[loop] = 1;
    if (at == status_.begin()) return;
    const Edge& e = edge_[std::prev(at)->edge];
    const bool inside = e.rightwards == (area_[e.loop] > 0);
    parent_[loop] = inside ? static_cast<int>(e.loop) : parent_[e.loop];
}

// Opens two edges: both edges at v run to the right.
bool Sweep::open(std::uint32_t v) {
    const auto at = status_.lower_bound(point_[v]);
    if (at != status_.end() && !status_.key_comp()(point_[v], *at)) return false; // v lies on an edge
    if (placed_[edge_[v].loop] == 0) place(edge_[v].loop, at);
    std::uint32_t lower = v, upper = previous_[v];
    const int turn = side(point_[v], edge_[lower].hi, edge_[upper].hi);
    if (turn == 0) return false;
    if (turn < 0) std::swap(lower, upper);
    const auto l = status_.emplace_hint(at, Node{lower});
    const auto u = status_.emplace_hint(at, Node{upper});
    where_[lower] = l;
    where_[upper] = u;
    if (l != status_.begin() && clash(std::prev(l), l)) return false;
    return at == status_.end() || !clash(u, at);
}

// Closes two edges: both edges at v come from the left. They must be neighbours, or something lies between them.
bool Sweep::close(std::uint32_t v) {
    auto a = where_[v], b = where_[previous_[v]];
    if (std::next(a) != b) std::swap(a, b);
    if (std::next(a) != b) return false;
    const auto after = status_.erase(a, std::next(b));
    return after == status_.begin() || after == status_.end() || !clash(std::prev(after), after);
}

// Replaces the edge `in`, which ends at a vertex, by `out`, which begins there.
bool Sweep::pass(std::uint32_t in, std::uint32_t out) {
    const auto at = where_[in];
    where_[out] = at;
    at->edge = out;
    if (at != status_.begin() && clash(std::prev(at), at)) return false;
    return std::next(at) == status_.end() || !clash(at, std::next(at));
}

std::optional<std::vector<int>> Sweep::run() {
    const auto n = static_cast<std::uint32_t>(point_.size());
    std::vector<std::uint32_t> order(n);
    for (std::uint32_t i = 0; i < n; ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return before(point_[a], point_[b]); });
    for (std::uint32_t k = 0; k + 1 < n; ++k)
        if (point_[order[k]] == point_[order[k + 1]]) return std::nullopt;
    for (const std::uint32_t v : order) {
        const bool next_right = edge_[v].lo == point_[v], previous_right = edge_[previous_[v]].lo == point_[v];
        const bool fine = next_right && previous_right ? open(v)
                          : next_right                 ? pass(previous_[v], v)
                          : previous_right             ? pass(v, previous_[v])
                                                       : close(v);
        if (!fine) return std::nullopt;
    }
    return parent_;
}

} // namespace

std::optional<std::vector<int>> nesting(const polygon::Loops& loops) {
    for (std::size_t l = 0; l < loops.size(); ++l)
        if (loops[l].size() < 3) return std::nullopt;
    return Sweep(loops).run();
}

} // namespace filum::regions
