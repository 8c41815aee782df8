#include "surfpath/rows/transit.hpp"

#include "geom/disjoint_sets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace filum::surfpath::rows {

namespace {

using surface::kNone;

constexpr double kUnreached = std::numeric_limits<double>::infinity();
constexpr double kNoWay = 1e9; // mm: what none counts as, so that there are as few as may be
constexpr std::uint32_t kExact = 8;

// From one place of a ring to another: how far ahead, negative if back; the shorter way round.
double ahead(const Line& ring, std::span<const double> ways, double from, double to) {
    double on = to - from;
    if (!ring.closed) return on;
    const double all = ways.back();
    if (on > all / 2) on -= all;
    if (on < -all / 2) on += all;
    return on;
}

// The best tour of all chains, by dynamic programming over sets (Held, Karp 1962).
std::vector<Turned> exact_tour(const std::vector<std::vector<double>>& length, std::uint32_t n) {
    const std::uint32_t sets = 1u << n;
    std::vector<double> best(sets * 2 * n, kUnreached); // by set and the end that the tour leaves from
    std::vector<std::uint32_t> before(best.size(), kNone);
    for (std::uint32_t e = 0; e < 2 * n; ++e) best[(1u << (e / 2)) * 2 * n + e] = 0;
    for (std::uint32_t set = 1; set < sets; ++set)
        for (std::uint32_t e = 0; e < 2 * n; ++e) {
            const double so_far = best[set * 2 * n + e];
            if (!(so_far < kUnreached)) continue;
            for (std::uint32_t in = 0; in < 2 * n; ++in) {
                if ((set >> (in / 2) & 1u) != 0) continue;
                const std::uint32_t to = (set | 1u << (in / 2)) * 2 * n + (in ^ 1u);
                const double l = so_far + std::min(length[e][in], kNoWay);
                if (l < best[to]) {
                    best[to] = l;
                    before[to] = set * 2 * n + e;
                }
            }
        }
    const auto first = best.end() - static_cast<std::ptrdiff_t>(2) * n; // of the set of all
    auto at = static_cast<std::uint32_t>(std::min_element(first, best.end()) - best.begin());
    std::vector<Turned> out;
    for (; at != kNone; at = before[at]) {
        const std::uint32_t e = at % (2 * n);
        out.push_back({e / 2, e % 2 == 0});
    }
    std::reverse(out.begin(), out.end());
    return out;
}

std::vector<Turned> nearest_tour(const std::vector<std::vector<double>>& length, std::uint32_t n) {
    std::vector<Turned> out{{0, false}};
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

// Of all ways the shortest first, as long as no end gets two and none closes a loop; what is still apart then follows
// in the order of chains.
std::vector<Turned> greedy_tour(const std::vector<std::vector<double>>& length, std::uint32_t n) {
    std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> ways;
    for (std::uint32_t a = 0; a < 2 * n; ++a)
        for (std::uint32_t b = a + 1; b < 2 * n; ++b)
            if (a / 2 != b / 2 && length[a][b] < kUnreached) ways.emplace_back(length[a][b], a, b);
    std::sort(ways.begin(), ways.end());
    geom::DisjointSets together(n);
    std::vector<std::uint32_t> led(2 * n, kNone); // per end: to which other one
    for (const auto& [l, a, b] : ways) {
        if (led[a] != kNone || led[b] != kNone || together.root(a / 2) == together.root(b / 2)) continue;
        together.unite(a / 2, b / 2);
        led[a] = b;
        led[b] = a;
    }
    std::vector<Turned> out;
    std::vector<char> seen(n, 0);
    for (std::uint32_t e = 0; e < 2 * n; ++e)
        if (led[e] == kNone && seen[e / 2] == 0)
            for (std::uint32_t in = e; in != kNone; in = led[in ^ 1u]) {
                seen[in / 2] = 1;
                out.push_back({in / 2, in % 2 == 1});
            }
    return out;
}

} // namespace

Transits::Transits(const Rows& rows) : rows_(rows), steps_(2 * rows.rows.size()) {
    std::vector<std::vector<std::pair<double, std::uint32_t>>> on(rows.inset.rings.size());
    for (std::uint32_t r = 0; r < rows.rows.size(); ++r) {
        const Row& row = rows.rows[r];
        if (row.line.closed) continue;
        const double l = surface::curve::length(row.line);
        steps_[2 * r].push_back({2 * r + 1, l, true});
        steps_[2 * r + 1].push_back({2 * r, l, true});
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
            steps_[from].push_back({to, l, false});
            steps_[to].push_back({from, l, false});
        }
    }
}

Transits::Tree Transits::search(std::uint32_t from, std::uint32_t to) const {
    Tree out{std::vector<double>(steps_.size(), kUnreached), std::vector<std::uint32_t>(steps_.size(), kNone),
             std::vector<char>(steps_.size(), 0)};
    using Item = std::pair<double, std::uint32_t>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
    out.length[from] = 0;
    queue.emplace(0, from);
    while (!queue.empty()) {
        const auto [l, at] = queue.top();
        queue.pop();
        if (l > out.length[at]) continue;
        const bool own = at / 2 == from / 2 || at / 2 == to / 2;
        for (const Step& s : steps_[at])
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
    return std::any_of(steps_[a].begin(), steps_[a].end(), [&](const Step& s) { return !s.row && s.to == b; });
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

std::optional<Transits::Way> Transits::way(std::uint32_t from, std::uint32_t to) const {
    const Tree tree = search(from, to);
    if (!(tree.length[to] < kUnreached)) return std::nullopt;
    std::vector<std::uint32_t> ends{to};
    while (ends.back() != from) ends.push_back(tree.before[ends.back()]);
    std::reverse(ends.begin(), ends.end());
    Way out{tree.length[to], {}};
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

std::vector<Turned> tour(const std::vector<std::vector<double>>& length) {
    const auto n = static_cast<std::uint32_t>(length.size() / 2);
    if (n == 0) return {};
    if (n <= kExact) return exact_tour(length, n);
    const auto ways = [&](const std::vector<Turned>& tour) {
        double sum = 0;
        for (std::size_t i = 1; i < tour.size(); ++i) {
            const std::uint32_t from = 2 * tour[i - 1].chain + (tour[i - 1].reversed ? 0 : 1);
            sum += std::min(length[from][2 * tour[i].chain + (tour[i].reversed ? 1 : 0)], kNoWay);
        }
        return sum;
    };
    auto near = nearest_tour(length, n), shortest = greedy_tour(length, n);
    return ways(shortest) < ways(near) ? shortest : near;
}

} // namespace filum::surfpath::rows
