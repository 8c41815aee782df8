#include "polygon/tiles.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace filum::polygon {

namespace {

constexpr std::size_t kTile = 2000;       // points
constexpr double kGrid = 1e-4;            // mm: where results lie; cuts run half way between
constexpr double kClear = 0.01;           // mm: of the margin, besides the reach
constexpr double kSame = 2e-3;            // mm: crossings of a cut from both sides, at most so far apart, are the same
constexpr double kWorthwhile = 0.8;       // of the points: a half with more than these is none
constexpr double kShares[] = {0.5, 0.45}; // of the points below the cut: the second where the first does not do

struct Cut {
    bool upright = false; // along y, else along x
    double at = 0;        // mm
    [[nodiscard]] double above(Vec2 p) const { return (upright ? p.x : p.y) - at; }
    [[nodiscard]] double along(Vec2 p) const { return upright ? p.y : p.x; }
    [[nodiscard]] Vec2 point(double along) const { return upright ? Vec2{at, along} : Vec2{along, at}; }
};

Vec2 crossing(const Cut& cut, Vec2 a, Vec2 b) {
    const double fa = cut.above(a), fb = cut.above(b);
    return cut.point(std::lerp(cut.along(a), cut.along(b), fa / (fa - fb)));
}

// Where an outline crosses a cut.
struct End {
    double along = 0;
    std::size_t chain = 0;
    Vec2 inside, outside; // the ends of the edge that crosses: on this side of the cut, and beyond
};

// The result for one side: loops that keep to it, and chains that come in over the cut and leave again.
struct Side {
    Loops whole;
    std::vector<std::vector<Vec2>> chains;
    std::vector<End> in, out;
};

Side side(const Loops& result, const Cut& cut, bool upper) {
    const auto here = [&](Vec2 p) { return (cut.above(p) > 0) == upper; };
    Side s;
    for (std::size_t l = 0; l < result.size(); ++l) {
        const auto loop = result[l];
        const std::size_t n = loop.size();
        const auto at = [&](std::size_t i) { return loop[i % n]; };
        std::size_t first = 0; // a point where the loop comes in
        while (first < n && !(here(loop[first]) && !here(at(first + n - 1)))) ++first;
        if (first == n) {
            if (here(loop[0])) s.whole.add(loop);
            continue;
        }
        for (std::size_t i = first; i < first + n; ++i) {
            const Vec2 p = at(i), before = at(i + n - 1), after = at(i + 1);
            if (!here(p)) continue;
            if (!here(before)) {
                s.in.push_back({cut.along(crossing(cut, p, before)), s.chains.size(), p, before});
                s.chains.emplace_back();
            }
            s.chains.back().push_back(p);
            if (!here(after)) s.out.push_back({cut.along(crossing(cut, p, after)), s.chains.size() - 1, p, after});
        }
    }
    for (auto* ends : {&s.in, &s.out})
        std::stable_sort(ends->begin(), ends->end(), [](const End& a, const End& b) { return a.along < b.along; });
    return s;
}

// The same of a simple area, as a simple area: along the cut, solid lies between each other pair of crossings.  Nothing
// if these say that the area is not simple.
std::optional<Loops> clipped_simple(const Side& s, const Cut& cut) {
    struct Crossing {
        double along;
        bool out;
        std::size_t chain;
    };
    std::vector<Crossing> all;
    for (const End& e : s.in) all.push_back({e.along, false, e.chain});
    for (const End& e : s.out) all.push_back({e.along, true, e.chain});
    std::stable_sort(all.begin(), all.end(), [](const Crossing& a, const Crossing& b) { return a.along < b.along; });
    std::vector<std::size_t> next(s.chains.size());
    std::vector<double> begin(s.chains.size()), end(s.chains.size());
    for (std::size_t k = 0; k + 1 < all.size(); k += 2) {
        const Crossing &a = all[k], &b = all[k + 1];
        if (a.out == b.out || a.along == b.along) return std::nullopt;
        const Crossing &leaves = a.out ? a : b, &comes = a.out ? b : a;
        next[leaves.chain] = comes.chain;
        end[leaves.chain] = leaves.along;
        begin[comes.chain] = comes.along;
    }
    Loops out = s.whole;
    std::vector<char> seen(s.chains.size(), 0);
    for (std::size_t start = 0; start < s.chains.size(); ++start) {
        if (seen[start]) continue;
        for (std::size_t c = start; !seen[c]; c = next[c]) {
            seen[c] = 1;
            out.points.push_back(cut.point(begin[c]));
            out.points.insert(out.points.end(), s.chains[c].begin(), s.chains[c].end());
            out.points.push_back(cut.point(end[c]));
        }
        out.close();
    }
    return out;
}

// How the chains of one side go on at the other.
struct Next {
    std::size_t chain = 0;
    std::optional<Vec2> over; // the point on the cut, if it says more than the points beside it
};

// One for each chain of `from`; nothing if the two sides do not meet.
std::optional<std::vector<Next>> meet(const Side& from, const Side& to, const Cut& cut) {
    if (from.out.size() != to.in.size()) return std::nullopt;
    std::vector<Next> next(from.chains.size());
    for (std::size_t k = 0; k < from.out.size(); ++k) {
        const End &a = from.out[k], &b = to.in[k];
        if (std::abs(a.along - b.along) > kSame) return std::nullopt;
        Next& n = next[a.chain];
        n.chain = b.chain;
        const bool same_edge = a.outside == b.inside && a.inside == b.outside;
        const Vec2 over = cut.point((a.along + b.along) / 2);
        const double apart = std::min(geom::distance(over, a.inside), geom::distance(over, b.inside));
        if (!same_edge && apart > 2 * kGrid) n.over = over;
    }
    return next;
}

std::optional<Loops> stitched(const Side& lower, const Side& upper, const Cut& cut) {
    const Side* sides[] = {&lower, &upper};
    const std::optional<std::vector<Next>> next[] = {meet(lower, upper, cut), meet(upper, lower, cut)};
    if (!next[0] || !next[1]) return std::nullopt;
    Loops out = lower.whole;
    std::vector<char> seen(lower.chains.size(), 0);
    for (std::size_t start = 0; start < lower.chains.size(); ++start) {
        if (seen[start]) continue;
        const std::size_t before = out.points.size();
        std::size_t chain = start;
        int at = 0;
        do {
            if (at == 0) seen[chain] = 1;
            const auto& points = sides[at]->chains[chain];
            out.points.insert(out.points.end(), points.begin(), points.end());
            const Next& n = (*next[at])[chain];
            if (n.over) out.points.push_back(*n.over);
            chain = n.chain;
            at = 1 - at;
        } while (at != 0 || chain != start);
        if (out.points.size() - before >= 3)
            out.close();
        else
            out.points.resize(before);
    }
    for (std::size_t l = 0; l < upper.whole.size(); ++l) out.add(upper.whole[l]);
    return out;
}

std::size_t count(std::span<const Loops> inputs) {
    std::size_t n = 0;
    for (const Loops& a : inputs) n += a.points.size();
    return n;
}

// Across the longer side of the box, with `share` of the points below it.
Cut choose(std::span<const Loops> inputs, double share) {
    Box2 box;
    for (const Loops& a : inputs)
        for (const Vec2 p : a.points) box.add(p);
    Cut cut{box.hi.x - box.lo.x > box.hi.y - box.lo.y, 0};
    std::vector<double> values;
    values.reserve(count(inputs));
    for (const Loops& a : inputs)
        for (const Vec2 p : a.points) values.push_back(cut.upright ? p.x : p.y);
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
    std::nth_element(values.begin(), middle, values.end());
    cut.at = (std::floor(*middle / kGrid) + 0.5) * kGrid;
    return cut;
}

// Nothing if one of the inputs is not simple there: cut as it is, it would have edges to and fro along the cut, which
// cost Clipper more than the whole.
std::optional<std::vector<Loops>> half(std::span<const Loops> inputs, const Cut& cut, double reach, bool upper) {
    Cut rim = cut;
    rim.at += (upper ? -1 : 1) * (reach + kClear);
    std::vector<Loops> out;
    out.reserve(inputs.size());
    for (const Loops& a : inputs) {
        auto part = clipped_simple(side(a, rim, upper), rim);
        if (!part) return std::nullopt;
        out.push_back(std::move(*part));
    }
    return out;
}

} // namespace

Loops tiled(std::span<const Loops> inputs, double reach, const Operation& operation) {
    const std::size_t n = count(inputs);
    if (n <= kTile) return operation(inputs);
    for (const double share : kShares) {
        const Cut cut = choose(inputs, share);
        const auto lower = half(inputs, cut, reach, false), upper = half(inputs, cut, reach, true);
        if (!lower || !upper) break;
        const double most = kWorthwhile * static_cast<double>(n);
        if (static_cast<double>(count(*lower)) > most || static_cast<double>(count(*upper)) > most) break;
        const Side below = side(tiled(*lower, reach, operation), cut, false);
        const Side above = side(tiled(*upper, reach, operation), cut, true);
        if (auto joined = stitched(below, above, cut)) return std::move(*joined);
    }
    return operation(inputs);
}

} // namespace filum::polygon
