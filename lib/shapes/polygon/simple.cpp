#include "polygon/simple.hpp"

#include <algorithm>
#include <cstdint>

namespace filum::polygon {

namespace {

struct Point {
    std::int64_t x, y;
    friend bool operator==(const Point&, const Point&) = default;
};

std::int64_t to_grid(double v) { return static_cast<std::int64_t>(v * kGridPerMm + (v < 0 ? -0.5 : 0.5)); }

bool before(const Point& a, const Point& b) { return a.y < b.y || (a.y == b.y && a.x < b.x); }

// Sweeps upwards and, among points of one height, to the right. Edge i runs from point i to the next point of its loop.
// `Wide` is an integer type that holds the product of two differences of coordinates.
template <class Wide>
class Sweep {
  public:
    Sweep(const std::vector<Point>& points, const std::vector<std::uint32_t>& start)
        : p_(points), next_(points.size()), prev_(points.size()), loop_(points.size()), place_(points.size()),
          within_(start.size() - 1, kUnknown), hole_(start.size() - 1, 0) {
        for (std::size_t i = 0; i + 1 < start.size(); ++i)
            for (std::uint32_t k = start[i]; k < start[i + 1]; ++k) {
                loop_[k] = static_cast<std::uint32_t>(i);
                next_[k] = k + 1 < start[i + 1] ? k + 1 : start[i];
                prev_[next_[k]] = k;
            }
    }

    bool run(const std::vector<std::uint32_t>& order) {
        return std::all_of(order.begin(), order.end(), [&](std::uint32_t v) { return pass(v); });
    }
    // The loop around each loop, after a run.
    [[nodiscard]] std::vector<int> within() && { return std::move(within_); }

  private:
    [[nodiscard]] bool upwards(std::uint32_t e) const { return before(p_[e], p_[next_[e]]); }
    [[nodiscard]] std::uint32_t lower(std::uint32_t e) const { return upwards(e) ? e : next_[e]; }
    [[nodiscard]] std::uint32_t upper(std::uint32_t e) const { return upwards(e) ? next_[e] : e; }

    // Positive if c lies left of a -> b.
    [[nodiscard]] Wide orient(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return Wide{p_[b].x - p_[a].x} * (p_[c].y - p_[a].y) - Wide{p_[b].y - p_[a].y} * (p_[c].x - p_[a].x);
    }

    // Whether edge e, which begins strictly left of edge f, stays so up to the lower one of their upper ends.
    [[nodiscard]] bool stays_left(std::uint32_t e, std::uint32_t f) const {
        const std::uint32_t le = lower(e), ue = upper(e), lf = lower(f), uf = upper(f);
        if (ue == uf) return orient(le, ue, lf) < 0; // they end in a common point
        return before(p_[ue], p_[uf]) ? orient(lf, uf, ue) > 0 : orient(le, ue, uf) < 0;
    }
    [[nodiscard]] bool fits(std::size_t i) const { // whether active edge i lies between its neighbours
        return (i == 0 || stays_left(active_[i - 1], active_[i])) &&
               (i + 1 >= active_.size() || stays_left(active_[i], active_[i + 1]));
    }

    // The place of the active edge e; its remembered place may be out of date.
    std::size_t find(std::uint32_t e, std::uint32_t top) {
        if (place_[e] < active_.size() && active_[place_[e]] == e) return place_[e];
        return static_cast<std::size_t>(
            std::partition_point(active_.begin(), active_.end(),
                                 [&](std::uint32_t a) { return orient(lower(a), upper(a), top) < 0; }) -
            active_.begin());
    }

    bool pass(std::uint32_t v) {
        const std::uint32_t in = prev_[v], out = v;
        const bool from_below = before(p_[in], p_[v]), to_above = before(p_[v], p_[next_[v]]);
        if (from_below != to_above) return from_below ? end(v, in, out) : begin(v, in, out);
        const std::uint32_t old = from_below ? in : out, fresh = from_below ? out : in;
        const std::size_t i = find(old, v);
        if (i >= active_.size() || active_[i] != old) return false;
        active_[i] = fresh;
        place_[fresh] = static_cast<std::uint32_t>(i);
        return fits(i);
    }

    // Begins two edges at v, which is lower than both its neighbours. From the left, active edges must run down and up
    // in turn. Then each has solid on its left, and there is no solid within solid.
    bool begin(std::uint32_t v, std::uint32_t in, std::uint32_t out) {
        const auto at = std::partition_point(active_.begin(), active_.end(),
                                             [&](std::uint32_t a) { return orient(lower(a), upper(a), v) < 0; });
        if (at != active_.end() && orient(lower(*at), upper(*at), v) == 0) return false;
        const Wide turn = orient(v, next_[v], prev_[v]);
        const bool left_runs_down = turn > 0;
        const auto i = static_cast<std::size_t>(at - active_.begin());
        if (turn == 0 || left_runs_down != (i % 2 == 0)) return false;
        const std::uint32_t both[2] = {left_runs_down ? in : out, left_runs_down ? out : in};
        if (within_[loop_[v]] == kUnknown) place_loop(loop_[v], i);
        active_.insert(at, both, both + 2);
        place_[both[0]] = static_cast<std::uint32_t>(i);
        place_[both[1]] = static_cast<std::uint32_t>(i + 1);
        return (i == 0 || stays_left(active_[i - 1], active_[i])) &&
               (i + 2 >= active_.size() || stays_left(active_[i + 1], active_[i + 2]));
    }

    // Places loop l, which begins before the active edge i. The edge to its left belongs to a loop around it, or to one
    // beside it.
    void place_loop(std::uint32_t l, std::size_t i) {
        hole_[l] = static_cast<char>(i % 2);
        within_[l] = -1;
        if (i == 0) return;
        const std::uint32_t left = loop_[active_[i - 1]];
        within_[l] = hole_[left] != hole_[l] ? static_cast<int>(left) : within_[left];
    }

    bool end(std::uint32_t v, std::uint32_t in, std::uint32_t out) {
        std::size_t i = find(in, v);
        if (i >= active_.size() || (active_[i] != in && active_[i] != out)) return false;
        if (i > 0 && active_[i - 1] == out) --i;
        if (i + 1 >= active_.size() || active_[i] + active_[i + 1] != in + out) return false;
        const auto at = active_.begin() + static_cast<std::ptrdiff_t>(i);
        active_.erase(at, at + 2);
        return i == 0 || i >= active_.size() || stays_left(active_[i - 1], active_[i]);
    }

    static constexpr int kUnknown = -2;

    const std::vector<Point>& p_;
    std::vector<std::uint32_t> next_, prev_, loop_;
    std::vector<std::uint32_t> place_; // place of each edge among the active ones when it was inserted
    std::vector<int> within_;          // of each loop, as in nesting()
    std::vector<char> hole_;
    std::vector<std::uint32_t> active_; // edges at the height of the sweep, left to right
};

// All points, lowest first. They are spread over as many buckets as there are points, then each bucket is sorted.
std::vector<std::uint32_t> lowest_first(const std::vector<Point>& p) {
    const auto [lo, hi] =
        std::minmax_element(p.begin(), p.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
    const std::int64_t bottom = lo->y;
    const double per_unit =
        static_cast<double>(p.size() - 1) / static_cast<double>(std::max<std::int64_t>(1, hi->y - bottom));
    const auto bucket = [&](const Point& q) {
        return static_cast<std::size_t>(static_cast<double>(q.y - bottom) * per_unit);
    };
    std::vector<std::uint32_t> first(p.size() + 2, 0), order(p.size());
    for (const Point& q : p) ++first[bucket(q) + 2];
    for (std::size_t b = 2; b < first.size(); ++b) first[b] += first[b - 1];
    for (std::uint32_t i = 0; i < p.size(); ++i) order[first[bucket(p[i]) + 1]++] = i;
    for (std::size_t b = 0; b + 1 < first.size(); ++b) {
        if (first[b + 1] - first[b] < 2) continue;
        std::sort(order.begin() + first[b], order.begin() + first[b + 1], [&](std::uint32_t i, std::uint32_t j) {
            return before(p[i], p[j]) || (!before(p[j], p[i]) && i < j);
        });
    }
    return order;
}

} // namespace

std::optional<std::vector<int>> nesting(const Loops& loops) {
    if (loops.points.empty()) return std::vector<int>(loops.size(), -1);
    for (std::size_t i = 0; i < loops.size(); ++i)
        if (loops[i].size() < 3) return std::nullopt;
    std::vector<Point> points;
    points.reserve(loops.points.size());
    const Box2 box = bounds(loops);
    const Point corner{to_grid(box.lo.x), to_grid(box.lo.y)};
    for (const Vec2 q : loops.points) points.push_back({to_grid(q.x) - corner.x, to_grid(q.y) - corner.y});
    const std::vector<std::uint32_t> order = lowest_first(points);
    for (std::size_t i = 1; i < order.size(); ++i) // the sweep does not see a loop that ends where another begins
        if (points[order[i]] == points[order[i - 1]]) return std::nullopt;
    constexpr std::int64_t kNarrow = std::int64_t{1} << 30;
    const auto swept = [&](auto sweep) -> std::optional<std::vector<int>> {
        if (!sweep.run(order)) return std::nullopt;
        return std::move(sweep).within();
    };
    const bool narrow = to_grid(box.hi.x) - corner.x < kNarrow && to_grid(box.hi.y) - corner.y < kNarrow;
    return narrow ? swept(Sweep<std::int64_t>(points, loops.start)) : swept(Sweep<__int128>(points, loops.start));
}

bool is_simple(const Loops& loops) { return nesting(loops).has_value(); }

} // namespace filum::polygon
