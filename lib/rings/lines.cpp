#include "rings/lines.hpp"

#include <algorithm>
#include <cmath>

namespace filum::rings {

namespace {

constexpr double kSamePlace = 1e-7; // mm

// What is left of a ring between two windows.
struct Arc {
    std::uint32_t ring;
    double s0, s1;
};

// An end of an arc: its last point, else its first.
struct End {
    std::uint32_t arc = 0;
    bool last = false;
};

// What the ends of arcs lead to, and over what link: from its first point to its last, else backwards.
struct Tie {
    End to;
    const Link* link = nullptr;
    bool along = false;
};

// Adds the points of `piece` from the first on, or from the last back.
void append_piece(const BeadLine& piece, bool backwards, BeadLine& line) {
    const std::size_t n = piece.size();
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = backwards ? n - 1 - k : k;
        line.add(piece.points[i], piece.width[i], piece.depth[i]);
    }
}

double length(const BeadLine& line) {
    double sum = geom::distance(line.points.back(), line.points.front());
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) sum += geom::distance(line.points[i], line.points[i + 1]);
    return sum;
}

// The arcs of all rings, and per window (counted over all splices) the arc that ends at its s0 and begins at its s1.
struct Arcs {
    std::vector<Arc> arc;
    std::vector<End> rim;
};

Arcs arcs(const RingLengths& lengths, const std::vector<Splice>& splices) {
    struct Cut {
        double s0, s1;
        std::uint32_t window;
    };
    std::vector<std::vector<Cut>> cuts(lengths.length.size());
    std::uint32_t windows = 0;
    for (const Splice& s : splices)
        for (const Window& w : s.windows) cuts[w.ring].push_back({w.s0, w.s1, windows++});
    Arcs out;
    out.rim.resize(2 * std::size_t{windows});
    for (std::uint32_t r = 0; r < cuts.size(); ++r) {
        auto& c = cuts[r];
        std::sort(c.begin(), c.end(), [](const Cut& a, const Cut& b) { return a.s0 < b.s0; });
        const auto first = static_cast<std::uint32_t>(out.arc.size()), n = static_cast<std::uint32_t>(c.size());
        for (std::uint32_t k = 0; k < n; ++k) {
            const bool wraps = k + 1 == n;
            out.arc.push_back({r, c[k].s1, c[wraps ? 0 : k + 1].s0 + (wraps ? lengths.length[r] : 0)});
            out.rim[2 * c[k].window] = {first + (k + n - 1) % n, true};
            out.rim[2 * c[k].window + 1] = {first + k, false};
        }
        if (n == 0) out.arc.push_back({r, 0, lengths.length[r]});
    }
    return out;
}

// Per arc what follows its first point, then its last; nothing where a whole ring leads back into itself.
std::vector<Tie> ties(const Arcs& arcs, const std::vector<Splice>& splices) {
    std::vector<Tie> out(2 * arcs.arc.size());
    for (std::uint32_t a = 0; a < arcs.arc.size(); ++a) out[2 * a].to = {a, true}, out[2 * a + 1].to = {a, false};
    std::uint32_t base = 0;
    for (const Splice& s : splices) {
        for (const Link& l : s.links) {
            const End a = arcs.rim[2 * (base + l.from.window) + (l.from.end ? 1 : 0)];
            const End b = arcs.rim[2 * (base + l.to.window) + (l.to.end ? 1 : 0)];
            out[2 * a.arc + (a.last ? 1 : 0)] = {b, &l, true};
            out[2 * b.arc + (b.last ? 1 : 0)] = {a, &l, false};
        }
        base += static_cast<std::uint32_t>(s.windows.size());
    }
    return out;
}

} // namespace

RingLengths lengths(const Rings& rings) {
    RingLengths out;
    out.along.reserve(rings.points.size()), out.ring.reserve(rings.points.size());
    for (std::uint32_t r = 0; r < rings.size(); ++r) {
        double s = 0;
        for (std::uint32_t i = rings.start[r]; i < rings.start[r + 1]; ++i) {
            out.along.push_back(s), out.ring.push_back(r);
            s += geom::distance(rings.points[i], rings.points[i + 1 == rings.start[r + 1] ? rings.start[r] : i + 1]);
        }
        out.length.push_back(s);
    }
    return out;
}

void append(const Rings& rings, const RingLengths& lengths, std::uint32_t ring, double s0, double s1, BeadLine& to) {
    const std::uint32_t first = rings.start[ring], n = rings.start[ring + 1] - first;
    const double l = lengths.length[ring], turns = std::floor(s0 / l) * l, from = s0 - turns, end = s1 - turns;
    const auto begin = lengths.along.begin() + first;
    const auto before = [&](double s) { // the last point at or before s, 0 <= s
        const double whole = std::floor(s / l);
        const auto k = static_cast<std::uint32_t>(std::upper_bound(begin, begin + n, s - whole * l) - begin - 1);
        return std::pair{k, whole * l};
    };
    const auto put = [&](double s) {
        const auto [k, turn] = before(s);
        const std::uint32_t i = first + k, j = k + 1 == n ? first : i + 1;
        const double here = lengths.along[i], span = (k + 1 == n ? l : lengths.along[j]) - here;
        const double t = span > 0 ? std::clamp((s - turn - here) / span, 0.0, 1.0) : 0;
        to.add(geom::lerp(rings.points[i], rings.points[j], t), std::lerp(rings.width[i], rings.width[j], t),
               std::lerp(rings.depth[i], rings.depth[j], t));
    };
    put(from);
    for (std::uint32_t k = before(from).first + 1; k <= 3 * n; ++k) {
        const double s = lengths.along[first + k % n] + (k / n) * l;
        if (s >= end - kSamePlace) break;
        if (s > from + kSamePlace) 
            to.add(rings.points[first + k % n], rings.width[first + k % n], rings.depth[first + k % n]);
    }
    put(end);
}

std::vector<BeadLine> spliced(const Rings& rings, const RingLengths& lengths, const std::vector<Splice>& splices) {
    const Arcs all = arcs(lengths, splices);
    const auto tie = ties(all, splices);
    std::vector<char> seen(all.arc.size(), 0);
    std::vector<BeadLine> out;
    for (std::uint32_t start = 0; start < all.arc.size(); ++start) {
        if (seen[start]) continue;
        BeadLine line;
        for (End at{start, false}; !seen[at.arc];) { // where the next arc is entered
            seen[at.arc] = 1;
            const Arc& a = all.arc[at.arc];
            BeadLine piece;
            append(rings, lengths, a.ring, a.s0, a.s1, piece);
            append_piece(piece, at.last, line);
            const Tie& t = tie[2 * at.arc + (at.last ? 0 : 1)];
            if (t.link != nullptr) append_piece(t.link->bead, !t.along, line);
            at = t.to;
        }
        out.push_back(std::move(line));
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const BeadLine& a, const BeadLine& b) { return length(a) > length(b); });
    return out;
}

} // namespace filum::rings
