#include "geom/disjoint_sets.hpp"
#include "surfpath/field/stripes.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace filum::surfpath::field {

namespace {

using surface::kNone;

// A crossing of a line with an edge. Crossings of an edge are in the order of the half-edge from its vertex of lower
// number.
struct EdgeCrossing {
    std::uint32_t edge = 0; // that half-edge, or the only one
    Vec3 point;
    std::array<std::uint32_t, 2> other{kNone, kNone};   // crossings that it is connected to
    std::array<std::uint32_t, 2> through{kNone, kNone}; // the triangles between
};

class Tracer {
  public:
    Tracer(const Surface& s, const Stripes& stripes) : s_(s), stripes_(stripes), first_(s.twin.size() + 1, 0) {}

    std::vector<Line> all() {
        for (std::uint32_t h = 0; h < s_.twin.size(); ++h) {
            first_[h] = static_cast<std::uint32_t>(found_.size());
            if (own(h)) cross_edge(h);
        }
        first_.back() = static_cast<std::uint32_t>(found_.size());
        for (std::uint32_t t = 0; t < s_.triangles.size(); ++t) join(t);
        join_loops();
        std::vector<Line> out;
        used_.assign(found_.size(), 0);
        for (std::uint32_t i = 0; i < found_.size(); ++i) // lines that end at rims first, then closed ones
            if (!used_[i] && found_[i].other[1] == kNone) out.push_back(follow(i));
        for (std::uint32_t i = 0; i < found_.size(); ++i)
            if (!used_[i]) out.push_back(follow(i));
        return out;
    }

  private:
    // Whether this half-edge is the one that stands for the edge.
    [[nodiscard]] bool own(std::uint32_t h) const { return s_.twin[h] == kNone || s_.tail(h) < s_.head(h); }

    void cross_edge(std::uint32_t h) {
        const bool ahead = s_.tail(h) < s_.head(h);
        const std::uint32_t a = ahead ? s_.tail(h) : s_.head(h), b = ahead ? s_.head(h) : s_.tail(h);
        const double grown = stripes_.growth[h];
        const double from = std::arg(stripes_.phase[a]), to = from + grown;
        const double low = std::min(from, to), high = std::max(from, to);
        const auto begin = found_.size();
        for (double k = std::ceil(low / std::numbers::pi - 0.5); (k + 0.5) * std::numbers::pi < high; ++k) {
            const double share =
                std::clamp(((k + 0.5) * std::numbers::pi - from) / grown, rules::kTiny, 1 - rules::kTiny);
            found_.push_back({h, s_.vertices[a] + share * (s_.vertices[b] - s_.vertices[a]), {kNone, kNone}, {}});
        }
        if (ahead != (grown > 0)) std::reverse(found_.begin() + static_cast<std::ptrdiff_t>(begin), found_.end());
    }

    // The crossings around a triangle, side by side.
    [[nodiscard]] std::vector<std::uint32_t> round(std::uint32_t t) const {
        std::vector<std::uint32_t> out;
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            const std::uint32_t e = own(h) ? h : s_.twin[h];
            for (std::uint32_t i = first_[e]; i < first_[e + 1]; ++i)
                out.push_back(e == h ? i : first_[e + 1] - 1 - (i - first_[e]));
        }
        return out;
    }

    // Connects the crossings of a triangle in pairs that do not cross, of the least total length (dynamic
    // programming).
    void join(std::uint32_t t) {
        const auto about = round(t);
        const std::size_t n = about.size();
        if (n < 2) return;
        const bool odd = singular(s_, stripes_, t);
        const auto at = [&](std::size_t i) { return about[i % n]; };
        std::vector<double> best((n + 1) * (n + 1), 0); // least cost of the crossings from i to j - 1
        std::vector<std::size_t> with((n + 1) * (n + 1), 0);
        for (std::size_t span = 2; span <= n; span += 2)
            for (std::size_t i = 0; i + span <= n; ++i) {
                double& least = best[i * (n + 1) + i + span];
                least = std::numeric_limits<double>::infinity();
                for (std::size_t k = i + 1; k < i + span; k += 2) {
                    const double l =
                        cost(at(i), at(k)) + best[(i + 1) * (n + 1) + k] + best[(k + 1) * (n + 1) + i + span];
                    if (l < least) {
                        least = l;
                        with[i * (n + 1) + i + span] = k;
                    }
                }
            }
        std::vector<std::pair<std::size_t, std::size_t>> open{{0, n - n % 2}};
        while (!open.empty()) {
            const auto [i, j] = open.back();
            open.pop_back();
            if (j < i + 2) continue;
            const std::size_t k = with[i * (n + 1) + j];
            tie(at(i), at(k), t);
            if (odd) chords_.push_back({t, at(i), at(k)});
            open.emplace_back(i + 1, k);
            open.emplace_back(k + 1, j);
        }
    }

    // Two crossings of one side are only connected, as neighbours in a turn, if nothing else is possible.
    [[nodiscard]] double cost(std::uint32_t a, std::uint32_t b) const {
        return distance(found_[a].point, found_[b].point) + (found_[a].edge == found_[b].edge ? 1e6 : 0);
    }

    void tie(std::uint32_t a, std::uint32_t b, std::uint32_t t) {
        for (const auto& [x, y] : {std::pair(a, b), std::pair(b, a)}) {
            const std::size_t k = found_[x].other[0] == kNone ? 0 : 1;
            found_[x].other[k] = y;
            found_[x].through[k] = t;
        }
    }

    void untie(std::uint32_t a, std::uint32_t b, std::uint32_t t) {
        for (const auto& [x, y] : {std::pair(a, b), std::pair(b, a)}) {
            EdgeCrossing& c = found_[x];
            const std::size_t k = c.other[0] == y && c.through[0] == t ? 0 : 1;
            if (k == 0) {
                c.other[0] = c.other[1];
                c.through[0] = c.through[1];
            }
            c.other[1] = c.through[1] = kNone;
        }
    }

    // Where a closed line meets another line in a singular triangle, connects them there the other way, which makes
    // one line of both.
    void join_loops() {
        geom::DisjointSets lines(found_.size());
        std::vector<char> open(found_.size(), 0);
        for (std::uint32_t i = 0; i < found_.size(); ++i)
            for (const std::uint32_t k : found_[i].other)
                if (k != kNone) lines.unite(i, k);
        for (std::uint32_t i = 0; i < found_.size(); ++i)
            if (found_[i].other[1] == kNone) open[lines.root(i)] = 1;
        for (std::size_t i = 0; i < chords_.size(); ++i)
            for (std::size_t k = i + 1; k < chords_.size() && chords_[k].triangle == chords_[i].triangle; ++k) {
                const auto a = lines.root(chords_[i].a), b = lines.root(chords_[k].a);
                if (a == b || (open[a] != 0 && open[b] != 0) || !swap(chords_[i], chords_[k])) continue;
                const bool ends = open[a] != 0 || open[b] != 0;
                lines.unite(a, b);
                open[lines.root(a)] = ends ? 1 : 0;
            }
    }

    struct Chord {
        std::uint32_t triangle, a, b;
    };

    // Connects the ends of two chords of a triangle the other way; returns false if another chord is in between.
    bool swap(Chord& x, Chord& y) {
        const std::uint32_t t = x.triangle;
        const auto about = round(t);
        const auto where = [&](std::uint32_t i) { return std::find(about.begin(), about.end(), i) - about.begin(); };
        std::array<std::uint32_t, 4> ends{x.a, x.b, y.a, y.b};
        std::sort(ends.begin(), ends.end(), [&](std::uint32_t i, std::uint32_t k) { return where(i) < where(k); });
        const bool first = (ends[0] == x.a && ends[1] == x.b) || (ends[0] == x.b && ends[1] == x.a) ||
                           (ends[0] == y.a && ends[1] == y.b) || (ends[0] == y.b && ends[1] == y.a);
        const std::array<std::uint32_t, 4> to =
            first ? std::array{ends[0], ends[3], ends[1], ends[2]} : std::array{ends[0], ends[1], ends[2], ends[3]};
        for (const Chord& c : chords_) { // another chord with just one end in between would cross
            if (c.triangle != t || c.a == x.a || c.a == y.a) continue;
            for (const std::size_t k : {0U, 2U}) {
                const auto i0 = where(to[k]), i1 = where(to[k + 1]), low = std::min(i0, i1), high = std::max(i0, i1);
                const auto inside = [&](std::uint32_t i) { return where(i) > low && where(i) < high; };
                if (inside(c.a) != inside(c.b)) return false;
            }
        }
        untie(x.a, x.b, t);
        untie(y.a, y.b, t);
        x = {t, to[0], to[1]};
        y = {t, to[2], to[3]};
        tie(x.a, x.b, t);
        tie(y.a, y.b, t);
        return true;
    }

    Line follow(std::uint32_t i) {
        Line out;
        std::uint32_t before = kNone;
        while (true) {
            used_[i] = 1;
            EdgeCrossing& c = found_[i];
            // If the line returns through the same two crossings, it continues through the other triangle.
            std::size_t k = 0;
            if (before != kNone) k = c.through[0] == before ? 1 : 0;
            if (c.other[k] == kNone) {
                out.places.push_back({before == kNone ? c.edge / 3 : before, c.point});
                return out;
            }
            out.places.push_back({c.through[k], c.point});
            before = c.through[k];
            i = c.other[k];
            if (used_[i]) {
                const bool back = distance(found_[i].point, out[0]) == 0;
                out.closed = back && found_[i].other[1] != kNone;
                if (!out.closed) out.places.push_back({before, found_[i].point});
                return out;
            }
        }
    }

    const Surface& s_;
    const Stripes& stripes_;
    std::vector<std::uint32_t> first_; // per half-edge the index of its first crossing
    std::vector<EdgeCrossing> found_;
    std::vector<Chord> chords_; // of singular triangles, in the order of these
    std::vector<char> used_;
};

} // namespace

std::vector<Line> lines(const Surface& s, const Stripes& stripes) { return Tracer(s, stripes).all(); }

} // namespace filum::surfpath::field
