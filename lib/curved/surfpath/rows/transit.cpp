#include "surfpath/rows/transit.hpp"

#include "geom/disjoint_sets.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace filum::surfpath::rows {

namespace {

using surface::kNone;

// Number of chains up to which the best tour is computed.
constexpr std::uint32_t kExact = 8;

// Signed distance along a ring from one place to another, around the shorter way if it is closed.
double ahead(const Line& ring, std::span<const double> ways, double from, double to) {
    double on = to - from;
    if (!ring.closed) return on;
    const double all = ways.back();
    if (on > all / 2) on -= all;
    if (on < -all / 2) on += all;
    return on;
}

// The best tour of all chains, by dynamic programming over subsets (Held, Karp 1962).
std::vector<OrientedChain> exact_tour(const std::vector<std::vector<double>>& length, std::uint32_t n, double no_way) {
    const std::uint32_t sets = 1u << n;
    std::vector<double> best(sets * 2 * n,
                             std::numeric_limits<double>::infinity()); // by subset and the end at which the tour stops
    std::vector<std::uint32_t> before(best.size(), kNone);
    for (std::uint32_t e = 0; e < 2 * n; ++e) best[(1u << (e / 2)) * 2 * n + e] = 0;
    for (std::uint32_t set = 1; set < sets; ++set)
        for (std::uint32_t e = 0; e < 2 * n; ++e) {
            const double so_far = best[set * 2 * n + e];
            if (std::isinf(so_far)) continue;
            for (std::uint32_t in = 0; in < 2 * n; ++in) {
                if ((set >> (in / 2) & 1u) != 0) continue;
                const std::uint32_t to = (set | 1u << (in / 2)) * 2 * n + (in ^ 1u);
                const double l = so_far + std::min(length[e][in], no_way);
                if (l < best[to]) {
                    best[to] = l;
                    before[to] = set * 2 * n + e;
                }
            }
        }
    const auto first = best.end() - static_cast<std::ptrdiff_t>(2) * n; // of the full set
    auto at = static_cast<std::uint32_t>(std::min_element(first, best.end()) - best.begin());
    std::vector<OrientedChain> out;
    for (; at != kNone; at = before[at]) {
        const std::uint32_t e = at % (2 * n);
        out.push_back({e / 2, e % 2 == 0});
    }
    std::reverse(out.begin(), out.end());
    return out;
}

std::vector<OrientedChain> nearest_tour(const std::vector<std::vector<double>>& length, std::uint32_t n) {
    std::vector<OrientedChain> out{{0, false}};
    std::vector<char> seen(n, 0);
    seen[0] = 1;
    for (std::uint32_t e = 1; out.size() < n;) {
        std::uint32_t next = kNone;
        for (std::uint32_t in = 0; in < 2 * n; ++in)
            if (seen[in / 2] == 0 && (next == kNone || length[e][in] < length[e][next])) next = in;
        seen[next / 2] = 1;
        out.push_back({next / 2, next % 2 == 1});
        e = next ^ 1u;
    }
    return out;
}

// Takes ways in the order of length, if no end gets two and none closes a loop. Tours that remain apart follow in the
// order of chains.
std::vector<OrientedChain> greedy_tour(const std::vector<std::vector<double>>& length, std::uint32_t n) {
    std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> ways;
    for (std::uint32_t a = 0; a < 2 * n; ++a)
        for (std::uint32_t b = a + 1; b < 2 * n; ++b)
            if (a / 2 != b / 2 && std::isfinite(length[a][b])) ways.emplace_back(length[a][b], a, b);
    std::sort(ways.begin(), ways.end());
    geom::DisjointSets together(n);
    std::vector<std::uint32_t> linked(2 * n, kNone); // per end: the end to which it is connected
    for (const auto& [l, a, b] : ways) {
        if (linked[a] != kNone || linked[b] != kNone || together.root(a / 2) == together.root(b / 2)) continue;
        together.unite(a / 2, b / 2);
        linked[a] = b;
        linked[b] = a;
    }
    std::vector<OrientedChain> out;
    std::vector<char> seen(n, 0);
    for (std::uint32_t e = 0; e < 2 * n; ++e)
        if (linked[e] == kNone && seen[e / 2] == 0)
            for (std::uint32_t in = e; in != kNone; in = linked[in ^ 1u]) {
                seen[in / 2] = 1;
                out.push_back({in / 2, in % 2 == 1});
            }
    return out;
}

} // namespace

Transits::Transits(const Rows& rows) : rows_(rows), edges_(2 * rows.rows.size()) {
    std::vector<std::vector<std::pair<double, std::uint32_t>>> on(rows.inset.rings.size());
    for (std::uint32_t r = 0; r < rows.rows.size(); ++r) {
        const Row& row = rows.rows[r];
        if (row.line.closed) continue;
        const double l = surface::curve::length(row.line);
        edges_[2 * r].push_back({2 * r + 1, l, true});
        edges_[2 * r + 1].push_back({2 * r, l, true});
        if (row.begin.ring != kNone) on[row.begin.ring].emplace_back(row.begin.way, 2 * r);
        if (row.end.ring != kNone) on[row.end.ring].emplace_back(row.end.way, 2 * r + 1);
    }
    for (std::uint32_t ring = 0; ring < on.size(); ++ring) {
        auto& ends = on[ring];
        std::sort(ends.begin(), ends.end());
        const bool closed = rows.inset.rings[ring].closed;
        for (std::size_t i = 0; i + (closed ? 0 : 1) < ends.size() && ends.size() > 1; ++i) {
            const auto& [a, from] = ends[i];
            const auto& [b, to] = ends[(i + 1) % ends.size()];
            const double l = std::abs(ahead(rows.inset.rings[ring], rows.inset.ways[ring], a, b));
            edges_[from].push_back({to, l, false});
            edges_[to].push_back({from, l, false});
        }
    }
}

Transits::PathTree Transits::search(std::uint32_t from, std::uint32_t to) const {
    PathTree out{std::vector<double>(edges_.size(), std::numeric_limits<double>::infinity()),
                 std::vector<std::uint32_t>(edges_.size(), kNone), std::vector<char>(edges_.size(), 0)};
    using Item = std::pair<double, std::uint32_t>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
    out.length[from] = 0;
    queue.emplace(0, from);
    while (!queue.empty()) {
        const auto [l, at] = queue.top();
        queue.pop();
        if (l > out.length[at]) continue;
        const bool own = at / 2 == from / 2 || at / 2 == to / 2;
        for (const Edge& s : edges_[at])
            if (!(own && s.row) && l + s.length < out.length[s.to]) {
                out.length[s.to] = l + s.length;
                out.before[s.to] = at;
                out.by_row[s.to] = s.row ? 1 : 0;
                queue.emplace(l + s.length, s.to);
            }
    }
    return out;
}

bool Transits::next_to(std::uint32_t a, std::uint32_t b) const {
    return std::any_of(edges_[a].begin(), edges_[a].end(), [&](const Edge& s) { return !s.row && s.to == b; });
}

Line Transits::along(std::uint32_t from, std::uint32_t to) const {
    const auto place = [&](std::uint32_t e) { return e % 2 == 0 ? rows_.rows[e / 2].begin : rows_.rows[e / 2].end; };
    const RingPlace a = place(from), b = place(to);
    if (a.ring != b.ring || a.ring == kNone) return {};
    const Line& ring = rows_.inset.rings[a.ring];
    const auto& ways = rows_.inset.ways[a.ring];
    const double on = ahead(ring, ways, a.way, b.way);
    if (on >= 0) return surface::curve::part(ring, ways, a.way, a.way + on);
    Line out = surface::curve::part(ring, ways, b.way, b.way - on);
    surface::curve::reverse(out);
    return out;
}

std::optional<Transits::Transit> Transits::shortest(std::uint32_t from, std::uint32_t to) const {
    const PathTree tree = search(from, to);
    if (std::isinf(tree.length[to])) return std::nullopt;
    std::vector<std::uint32_t> ends{to};
    while (ends.back() != from) ends.push_back(tree.before[ends.back()]);
    std::reverse(ends.begin(), ends.end());
    Transit out{tree.length[to], {}};
    for (std::size_t i = 1; i < ends.size(); ++i) {
        if (tree.by_row[ends[i]] == 0) {
            Line next = along(ends[i - 1], ends[i]);
            if (i > 1 && tree.by_row[ends[i - 1]] == 0)
                surface::curve::append(out.stretches.back(), next);
            else
                out.stretches.push_back(std::move(next));
            continue;
        }
        out.stretches.push_back(rows_.rows[ends[i] / 2].line);
        if (ends[i] % 2 == 0) surface::curve::reverse(out.stretches.back());
    }
    return out;
}

std::vector<OrientedChain> tour(const std::vector<std::vector<double>>& length) {
    const auto n = static_cast<std::uint32_t>(length.size() / 2);
    if (n == 0) return {};
    double no_way = 1; // mm: cost of a missing way, more than all others together, so that few are missing
    for (const auto& from : length)
        for (const double way : from) no_way += std::isfinite(way) ? way : 0;
    if (n <= kExact) return exact_tour(length, n, no_way);
    const auto ways = [&](const std::vector<OrientedChain>& tour) {
        double sum = 0;
        for (std::size_t i = 1; i < tour.size(); ++i) {
            const std::uint32_t from = 2 * tour[i - 1].chain + (tour[i - 1].reversed ? 0 : 1);
            sum += std::min(length[from][2 * tour[i].chain + (tour[i].reversed ? 1 : 0)], no_way);
        }
        return sum;
    };
    auto near = nearest_tour(length, n), shortest = greedy_tour(length, n);
    return ways(shortest) < ways(near) ? shortest : near;
}

} // namespace filum::surfpath::rows
