#include "surfpath/rows/winding.hpp"

#include "surface/curve/walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::surfpath::rows {

namespace {

constexpr std::size_t kSamples = 24; // of a ring, to tell whether another runs beside it
constexpr double kRingsBeside = 1.6; // of the difference of levels: how far apart rings beside each other may be
constexpr double kSpiralStep = 0.4;  // of the spacing, between places of a spiral
constexpr double kApart = 100;       // spacings, of levels, between chains that have nothing to do with each other
constexpr double kNearInset = 2;     // spacings: from where the spiral's end is led to the inset

struct Foot {
    double far = std::numeric_limits<double>::infinity();
    double way = 0;
};

// The nearest place of a closed or open line.
Foot foot(const Line& line, std::span<const double> ways, const Vec3& p) {
    Foot out;
    for (std::size_t i = 0; i + 1 < ways.size(); ++i) {
        const Vec3 &a = line[i], d = line[(i + 1) % line.size()] - a;
        const double l2 = dot(d, d), t = l2 > 0 ? std::clamp(dot(p - a, d) / l2, 0.0, 1.0) : 0;
        if (const double far = distance(p, a + t * d); far < out.far) out = {far, ways[i] + t * std::sqrt(l2)};
    }
    return out;
}

struct Contour {
    Line line;
    std::vector<double> ways;
    double level;
    geom::Box3 box;
};

Contour contour(const Line& line, double level) {
    Contour out{line, surface::curve::arc_lengths(line), level, {}};
    for (const Place& p : line.places) out.box.add(p.point);
    return out;
}

// How far rings are from each other, mm, in the mean; infinite if anywhere farther than `most`.
double apart(const Contour& a, const Contour& b, double most) {
    const Vec3 low = a.box.lo - b.box.lo, high = a.box.hi - b.box.hi; // of rings that near, boxes are alike
    for (const double off : {low.x, low.y, low.z, high.x, high.y, high.z})
        if (std::abs(off) > most) return std::numeric_limits<double>::infinity();
    double sum = 0;
    for (std::size_t i = 0; i < kSamples; ++i)
        for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
            const double way = static_cast<double>(i) / kSamples * from->ways.back();
            const double far = foot(to->line, to->ways, surface::curve::at(from->line, from->ways, way).point).far;
            if (far > most) return std::numeric_limits<double>::infinity();
            sum += far;
        }
    return sum / (2 * kSamples);
}

bool beside(const Contour& a, const Contour& b) {
    return std::isfinite(apart(a, b, kRingsBeside * std::abs(a.level - b.level)));
}

// Rings in chains, each beside the next.
std::vector<std::vector<Contour>> chained(std::vector<Contour> rings, double spacing) {
    std::vector<std::vector<Contour>> out;
    for (Contour& ring : rings) {
        std::vector<Contour>* to = nullptr;
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

class Winder {
  public:
    Winder(const Surface& s, const Rows& rows, double spacing)
        : surface_(s), rows_(rows), spacing_(spacing), normals_(surface::curve::vertex_normals(s)) {}

    [[nodiscard]] Row wound(const std::vector<Contour>& chain, bool from_rim) const {
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
            at = foot(chain[i + 1].line, chain[i + 1].ways, line.places.back().point).way;
        }
        const Contour& last = chain.back();
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
    // Where the spiral that ends on `ring` lands on the inset, and from where on the ring.
    [[nodiscard]] std::pair<RingPlace, double> landing(const Contour& ring) const {
        RingPlace place;
        double least = kNearInset * spacing_, from = 0;
        for (std::uint32_t r = 0; r < rows_.inset.rings.size(); ++r)
            for (std::size_t i = 0; i < ring.line.size();) {
                const Foot f = foot(rows_.inset.rings[r], rows_.inset.ways[r], ring.line[i]);
                const double nearer = ring.ways[i] + f.far - least; // not before that far on
                if (f.far < least) {
                    least = f.far;
                    place = {r, f.way};
                    from = ring.ways[i];
                }
                for (++i; i < ring.line.size() && ring.ways[i] < nearer;) ++i;
            }
        return {place, from};
    }

    // Where on the first ring to begin, so that the last lap comes to be half a lap before its end; of a single ring,
    // at its end.
    [[nodiscard]] double start(const std::vector<Contour>& chain) const {
        const auto [place, to_inset] = landing(chain.back());
        if (chain.size() == 1) return to_inset;
        double way = place.ring == surface::kNone ? 0 : to_inset + chain.back().ways.back() / 2;
        for (std::size_t i = chain.size() - 1; i-- > 0;)
            way =
                foot(chain[i].line, chain[i].ways, surface::curve::at(chain[i + 1].line, chain[i + 1].ways, way).point)
                    .way;
        return way;
    }

    // A lap from `at` on one ring that goes over to the other.
    [[nodiscard]] Line over(const Contour& ring, double at, const Contour& to) const {
        const double all = ring.ways.back(), gap = std::abs(to.level - ring.level);
        const auto n = static_cast<std::size_t>(std::max(48.0, std::ceil(all / (kSpiralStep * spacing_))));
        const double side = outward(ring, at, to, gap);
        Line out;
        for (std::size_t i = 0; i <= n; ++i) {
            const double part = static_cast<double>(i) / static_cast<double>(n);
            const double way = at + all * (i == n ? 0 : part);
            out.places.push_back(aside(ring, way, side * part * gap));
        }
        return out;
    }

    // The place beside the ring, mm to its left.
    [[nodiscard]] Place aside(const Contour& ring, double way, double left) const {
        const Place p = surface::curve::at(ring.line, ring.ways, way);
        if (left == 0) return p;
        const double h = std::min(0.5 * spacing_, ring.ways.back() / 16);
        const Vec3 along = surface::curve::at(ring.line, ring.ways, way + h).point -
                           surface::curve::at(ring.line, ring.ways, way - h).point;
        const Vec3 across = cross(surface::curve::normal_at(surface_, normals_, p), along);
        return surface::curve::step(surface_, p, left / norm(across) * across);
    }

    [[nodiscard]] double outward(const Contour& ring, double at, const Contour& to, double gap) const {
        const auto off = [&](double left) { return foot(to.line, to.ways, aside(ring, at, left).point).far; };
        return off(gap) <= off(-gap) ? 1 : -1;
    }

    const Surface& surface_;
    const Rows& rows_;
    double spacing_;
    std::vector<Vec3> normals_;
};

} // namespace

void wind(const Surface& s, Rows& rows, double spacing, bool from_rim) {
    std::vector<Contour> rings;
    for (const Row& row : rows.rows)
        if (row.line.closed) rings.push_back(contour(row.line, row.level));
    if (rings.empty()) return;
    const Winder winder(s, rows, spacing);
    std::vector<Row> wound;
    const double first = rings.front().level; // of the seed's own, rows being sorted
    for (const auto& chain : chained(std::move(rings), spacing))
        wound.push_back(winder.wound(chain, from_rim || chain.front().level > first));
    std::erase_if(rows.rows, [](const Row& row) { return row.line.closed; });
    std::move(wound.begin(), wound.end(), std::back_inserter(rows.rows));
    std::stable_sort(rows.rows.begin(), rows.rows.end(), [](const Row& a, const Row& b) { return a.level < b.level; });
}

namespace {

// Turns `b` round unless `a`, which runs beside it, lies to its left.
void turn_from(const Surface& s, Line& b, const Contour& a) {
    const auto ways = surface::curve::arc_lengths(b);
    const Place p = b.places[0];
    const Vec3 t = surface::curve::at(b, ways, ways.back() / 1000).point - p.point;
    const Vec3 q = surface::curve::at(a.line, a.ways, foot(a.line, a.ways, p.point).way).point;
    if (dot(cross(surface::normal(s, p.triangle), t), q - p.point) < 0) surface::curve::reverse(b);
}

} // namespace

std::vector<std::size_t> level_rings(const Surface& s, std::vector<Raw>& lines, double spacing) {
    std::vector<std::size_t> which;
    std::vector<Contour> rings;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (lines[i].line.closed) {
            which.push_back(i);
            rings.push_back(contour(lines[i].line, 0));
        }
    const std::size_t n = rings.size();
    using Near = std::pair<double, std::size_t>;
    std::vector<std::vector<Near>> next(n); // nearest first
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = i + 1; k < n; ++k) {
            const double far = apart(rings[i], rings[k], kRingsBeside * spacing);
            if (!std::isfinite(far)) continue;
            next[i].emplace_back(far, k);
            next[k].emplace_back(far, i);
        }
    for (auto& near : next) std::sort(near.begin(), near.end());
    std::vector<char> seen(n, 0);
    std::vector<std::size_t> sizes(lines.size(), 0);
    double level = 0;
    for (const std::size_t most : {1U, 2U, 1000U}) // from the ends of chains on, then what closes up or branches
        for (std::size_t i = 0; i < n; ++i) {
            if (seen[i] || next[i].size() > most) continue;
            level += kApart * spacing;
            std::vector<std::size_t> chain;
            for (std::size_t at = i; at < n;) {
                seen[at] = 1;
                chain.push_back(at);
                lines[which[at]].level = level;
                level += spacing;
                const auto on =
                    std::find_if(next[at].begin(), next[at].end(), [&](const Near& k) { return seen[k.second] == 0; });
                at = on == next[at].end() ? n : on->second;
            }
            for (std::size_t k = 0; k < chain.size(); ++k) {
                sizes[which[chain[k]]] = chain.size();
                if (k > 0) turn_from(s, lines[which[chain[k]]].line, rings[chain[k - 1]]);
            }
            if (chain.size() > 1) { // the first one as the second
                Line& first = lines[which[chain[0]]].line;
                turn_from(s, first, rings[chain[1]]);
                surface::curve::reverse(first);
            }
        }
    return sizes;
}

} // namespace filum::surfpath::rows
