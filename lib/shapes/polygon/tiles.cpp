#include "polygon/tiles.hpp"

#include "polygon/cut.hpp"
#include "polygon/simple.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace filum::polygon {

namespace {

constexpr std::size_t kTile = 2000;       // points; larger inputs are halved
constexpr double kClear = 0.01;           // mm of margin in addition to the reach
constexpr double kSame = 2e-3;            // mm; nearer crossings of a cut from both sides are the same
constexpr double kWorthwhile = 0.8;       // of the points; a half with more is not worth a cut
constexpr double kShares[] = {0.5, 0.45}; // of the points below the cut; the second if the first fails

// The chain on the other side of a cut at which a chain continues.
struct Continuation {
    std::size_t chain = 0;
    std::optional<Vec2> over; // the point on the cut, if it is not too near to the points beside it
};

// The continuation of each chain of `from`; nothing if the two sides do not meet.
std::optional<std::vector<Continuation>> meet(const CutSide& from, const CutSide& to, const ClipLine& cut) {
    if (from.out.size() != to.in.size()) return std::nullopt;
    std::vector<Continuation> next(from.chains.size());
    for (std::size_t k = 0; k < from.out.size(); ++k) {
        const CutEnd &a = from.out[k], &b = to.in[k];
        if (std::abs(a.along - b.along) > kSame) return std::nullopt;
        Continuation& n = next[a.chain];
        n.chain = b.chain;
        const bool same_edge = a.outside == b.inside && a.inside == b.outside;
        const Vec2 over = cut.point((a.along + b.along) / 2);
        const double apart = std::min(geom::distance(over, a.inside), geom::distance(over, b.inside));
        if (!same_edge && apart > 2 * kGridStep) n.over = over;
    }
    return next;
}

std::optional<Loops> stitched(const CutSide& lower, const CutSide& upper, const ClipLine& cut) {
    const CutSide* sides[] = {&lower, &upper};
    const std::optional<std::vector<Continuation>> next[] = {meet(lower, upper, cut), meet(upper, lower, cut)};
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
            const Continuation& n = (*next[at])[chain];
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

// The cut across the longer side of the box, with `share` of the points below it.
ClipLine choose(std::span<const Loops> inputs, double share) {
    Box2 box;
    for (const Loops& a : inputs)
        for (const Vec2 p : a.points) box.add(p);
    ClipLine cut{box.hi.x - box.lo.x > box.hi.y - box.lo.y, 0};
    std::vector<double> values;
    values.reserve(count(inputs));
    for (const Loops& a : inputs)
        for (const Vec2 p : a.points) values.push_back(cut.upright ? p.x : p.y);
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
    std::nth_element(values.begin(), middle, values.end());
    cut.at = between_grid_points(*middle);
    return cut;
}

// One half of the inputs, with its margin. Nothing if one of the inputs is not simple there. It would get edges to and
// fro along the cut, which cost Clipper more than the whole.
std::optional<std::vector<Loops>> half(std::span<const Loops> inputs, const ClipLine& cut, double reach, bool upper) {
    ClipLine rim = cut;
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
        const ClipLine cut = choose(inputs, share);
        const auto lower = half(inputs, cut, reach, false), upper = half(inputs, cut, reach, true);
        if (!lower || !upper) break;
        const double most = kWorthwhile * static_cast<double>(n);
        if (static_cast<double>(count(*lower)) > most || static_cast<double>(count(*upper)) > most) break;
        const CutSide below = side(tiled(*lower, reach, operation), cut, false);
        const CutSide above = side(tiled(*upper, reach, operation), cut, true);
        if (auto joined = stitched(below, above, cut)) return std::move(*joined);
    }
    return operation(inputs);
}

} // namespace filum::polygon
