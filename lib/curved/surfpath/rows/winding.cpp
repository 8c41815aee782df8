#include "surfpath/rows/winding.hpp"

#include "surface/curve/nearest.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::surfpath::rows {

namespace {

using surface::curve::nearest;

constexpr std::size_t kSamples = 24; // sample points of a ring to decide whether another runs beside it

struct RingLine {
    Line line;
    std::vector<double> ways;
    double level;
    geom::Box3 box;
};

RingLine ring_line(const Line& line, double level) {
    RingLine out{line, surface::curve::arc_lengths(line), level, {}};
    for (const Place& p : line.places) out.box.add(p.point);
    return out;
}

// Mean distance of two rings, mm; infinite if it exceeds `most` anywhere.
double apart(const RingLine& a, const RingLine& b, double most) {
    const Vec3 low = a.box.lo - b.box.lo, high = a.box.hi - b.box.hi; // boxes of rings that near are almost equal
    for (const double off : {low.x, low.y, low.z, high.x, high.y, high.z})
        if (std::abs(off) > most) return std::numeric_limits<double>::infinity();
    double sum = 0;
    for (std::size_t i = 0; i < kSamples; ++i)
        for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
            const double way = static_cast<double>(i) / kSamples * from->ways.back();
            const double far =
                nearest(to->line, to->ways, surface::curve::at(from->line, from->ways, way).point).distance;
            if (far > most) return std::numeric_limits<double>::infinity();
            sum += far;
        }
    return sum / (2 * kSamples);
}

bool beside(const RingLine& a, const RingLine& b) {
    return std::isfinite(apart(a, b, rules::kBeside * std::abs(a.level - b.level)));
}

// Sorts rings into chains in which each lies beside the next.
std::vector<std::vector<RingLine>> chained(std::vector<RingLine> rings, double spacing) {
    std::vector<std::vector<RingLine>> out;
    for (RingLine& ring : rings) {
        std::vector<RingLine>* to = nullptr;
        for (auto& chain : out)
            if (const double rise = ring.level - chain.back().level;
                rise > 0 && rise < 1.5 * spacing && beside(chain.back(), ring)) {
                to = &chain;
                break;
            }
        if (!to) to = &out.emplace_back();
        to->push_back(std::move(ring));
    }
    return out;
}

class SpiralWinder {
  public:
    SpiralWinder(const Surface& s, const Rows& rows, double spacing)
        : surface_(s), rows_(rows), spacing_(spacing), normals_(surface::curve::vertex_normals(s)) {}

    [[nodiscard]] Row wound(const std::vector<RingLine>& chain, bool from_rim) const {
        Row out;
        out.level = chain.front().level;
        const auto [place, to_inset] = landing(chain.back());
        double at = start(chain);
        Line line;
        if (from_rim || chain.size() == 1) {
            const double lap = chain.front().ways.back();
            line = surface::curve::part(chain.front().line, chain.front().ways, at - lap, at);
        }
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            const Line lap = over(chain[i], at, chain[i + 1]);
            surface::curve::append(line, lap);
            at = nearest(chain[i + 1].line, chain[i + 1].ways, line.places.back().point).way;
        }
        const RingLine& last = chain.back();
        if (chain.size() > 1) {
            double to = place.ring == surface::kNone ? at + last.ways.back() : to_inset;
            const double lap = last.ways.back();
            while (to < at + 0.25 * lap) to += lap;
            while (to > at + 1.25 * lap) to -= lap;
            if (to > at + lap) {
                surface::curve::append(line, surface::curve::part(last.line, last.ways, at, at + lap));
                to -= lap;
            }
            if (to > at) surface::curve::append(line, surface::curve::part(last.line, last.ways, at, to));
        }
        if (place.ring != surface::kNone)
            line.places.push_back(
                surface::curve::at(rows_.inset.rings[place.ring], rows_.inset.ways[place.ring], place.way));
        out.line = surface::curve::threaded(surface_, line);
        out.end = place;
        return out;
    }

  private:
    // Where the spiral that ends on `ring` reaches the inset, and the arc length at which it leaves the ring.
    [[nodiscard]] std::pair<RingPlace, double> landing(const RingLine& ring) const {
        RingPlace place;
        double least = rules::kBeside * spacing_, from = 0;
        for (std::uint32_t r = 0; r < rows_.inset.rings.size(); ++r)
            for (std::size_t i = 0; i < ring.line.size();) {
                const auto f = nearest(rows_.inset.rings[r], rows_.inset.ways[r], ring.line[i]);
                const double nearer =
                    ring.ways[i] + f.distance - least; // no place before this arc length can be nearer
                if (f.distance < least) {
                    least = f.distance;
                    place = {r, f.way};
                    from = ring.ways[i];
                }
                for (++i; i < ring.line.size() && ring.ways[i] < nearer;) ++i;
            }
        return {place, from};
    }

    // Where on the first ring the spiral begins such that its last lap starts half a lap before its end; for a single
    // ring, at its end.
    [[nodiscard]] double start(const std::vector<RingLine>& chain) const {
        const auto [place, to_inset] = landing(chain.back());
        if (chain.size() == 1) return to_inset;
        double way = place.ring == surface::kNone ? 0 : to_inset + chain.back().ways.back() / 2;
        for (std::size_t i = chain.size() - 1; i-- > 0;)
            way = nearest(chain[i].line, chain[i].ways,
                          surface::curve::at(chain[i + 1].line, chain[i + 1].ways, way).point)
                      .way;
        return way;
    }

    // One lap from `at` on a ring that gradually shifts to the next ring.
    [[nodiscard]] Line over(const RingLine& ring, double at, const RingLine& to) const {
        const double all = ring.ways.back(), gap = std::abs(to.level - ring.level);
        const auto n = static_cast<std::size_t>(std::max(48.0, std::ceil(all / (rules::kGrain * spacing_))));
        const double side = outward(ring, at, to, gap);
        Line out;
        for (std::size_t i = 0; i <= n; ++i) {
            const double part = static_cast<double>(i) / static_cast<double>(n);
            const double way = at + all * (i == n ? 0 : part);
            out.places.push_back(aside(ring, way, side * part * gap));
        }
        return out;
    }

    // The place `left` mm to the left of the ring.
    [[nodiscard]] Place aside(const RingLine& ring, double way, double left) const {
        const Place p = surface::curve::at(ring.line, ring.ways, way);
        if (left == 0) return p;
        const double h = std::min(0.5 * spacing_, ring.ways.back() / 16);
        const Vec3 along = surface::curve::at(ring.line, ring.ways, way + h).point -
                           surface::curve::at(ring.line, ring.ways, way - h).point;
        const Vec3 across = cross(surface::curve::normal_at(surface_, normals_, p), along);
        return surface::curve::step(surface_, p, left / norm(across) * across);
    }

    [[nodiscard]] double outward(const RingLine& ring, double at, const RingLine& to, double gap) const {
        const auto off = [&](double left) { return nearest(to.line, to.ways, aside(ring, at, left).point).distance; };
        return off(gap) <= off(-gap) ? 1 : -1;
    }

    const Surface& surface_;
    const Rows& rows_;
    double spacing_;
    std::vector<Vec3> normals_;
};

} // namespace

void wind(const Surface& s, Rows& rows, double spacing, bool from_rim) {
    std::vector<RingLine> rings;
    for (const Row& row : rows.rows)
        if (row.line.closed) rings.push_back(ring_line(row.line, row.level));
    if (rings.empty()) return;
    const SpiralWinder winder(s, rows, spacing);
    std::vector<Row> wound;
    const double first = rings.front().level; // the least level, as rows are sorted: next to the seed
    for (const auto& chain : chained(std::move(rings), spacing))
        wound.push_back(winder.wound(chain, from_rim || chain.front().level > first));
    std::erase_if(rows.rows, [](const Row& row) { return row.line.closed; });
    std::move(wound.begin(), wound.end(), std::back_inserter(rows.rows));
    std::stable_sort(rows.rows.begin(), rows.rows.end(), [](const Row& a, const Row& b) { return a.level < b.level; });
}

namespace {

// Reverses `b` unless `a`, which runs beside it, is on its left.
void turn_from(const Surface& s, Line& b, const RingLine& a) {
    const auto ways = surface::curve::arc_lengths(b);
    const Place p = b.places[0];
    const Vec3 t = surface::curve::at(b, ways, ways.back() / 1000).point - p.point;
    const Vec3 q = surface::curve::at(a.line, a.ways, nearest(a.line, a.ways, p.point).way).point;
    if (dot(cross(surface::normal(s, p.triangle), t), q - p.point) < 0) surface::curve::reverse(b);
}

// A ring, after its distance, mm.
using NearRing = std::pair<double, std::size_t>;

// Per ring those within `reach` mm of it, the nearest first.
std::vector<std::vector<NearRing>> rings_beside(const std::vector<RingLine>& rings, double reach) {
    std::vector<std::vector<NearRing>> out(rings.size());
    for (std::size_t i = 0; i < rings.size(); ++i)
        for (std::size_t k = i + 1; k < rings.size(); ++k) {
            const double far = apart(rings[i], rings[k], reach);
            if (!std::isfinite(far)) continue;
            out[i].emplace_back(far, k);
            out[k].emplace_back(far, i);
        }
    for (auto& near : out) std::sort(near.begin(), near.end());
    return out;
}

} // namespace

std::vector<std::size_t> level_rings(const Surface& s, std::vector<UnclippedLine>& lines, double spacing) {
    std::vector<std::size_t> which;
    std::vector<RingLine> rings;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (lines[i].line.closed) {
            which.push_back(i);
            rings.push_back(ring_line(lines[i].line, 0));
        }
    const std::size_t n = rings.size();
    const auto next = rings_beside(rings, rules::kBeside * spacing);
    std::vector<char> seen(n, 0);
    std::vector<std::size_t> sizes(lines.size(), 0);
    double level = 0;
    for (const std::size_t most : {1U, 2U, 1000U}) // starts at ends of chains, then takes cycles and branches
        for (std::size_t i = 0; i < n; ++i) {
            if (seen[i] || next[i].size() > most) continue;
            level += rules::kBeside * spacing; // unrelated chains are not neighbours
            std::vector<std::size_t> chain;
            for (std::size_t at = i; at < n;) {
                seen[at] = 1;
                chain.push_back(at);
                lines[which[at]].level = level;
                level += spacing;
                const auto on = std::find_if(next[at].begin(), next[at].end(),
                                             [&](const NearRing& k) { return seen[k.second] == 0; });
                at = on == next[at].end() ? n : on->second;
            }
            for (std::size_t k = 0; k < chain.size(); ++k) {
                sizes[which[chain[k]]] = chain.size();
                if (k > 0) turn_from(s, lines[which[chain[k]]].line, rings[chain[k - 1]]);
            }
            if (chain.size() > 1) { // the first ring has the second one on the other side
                Line& first = lines[which[chain[0]]].line;
                turn_from(s, first, rings[chain[1]]);
                surface::curve::reverse(first);
            }
        }
    return sizes;
}

} // namespace filum::surfpath::rows
