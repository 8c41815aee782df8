#include "fill/walls/wall_walk.hpp"
#include "base/none.hpp"
#include "fill/join/crossings.hpp"

#include "geom/disjoint_sets.hpp"
#include "geom/segment.hpp"
#include "toolpath/curve_place.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <tuple>

namespace filum::fill::walls {

namespace {

// One pass along a wall. Its end at the wall's node a is number 2 * track, that at node b 2 * track + 1.
struct Track {
    std::uint32_t wall = 0;
    int side = 0; // 0: in the middle; 1: left of the wall from a to b; -1: right of it
};

class Circuit {
  public:
    Circuit(const WallGraph& g, const std::vector<int>& passes) : g_(g), at_(g.node.size()) {
        for (std::uint32_t k = 0; k < g.walls.size(); ++k) {
            if (passes[k] == 1) tracks_.push_back({k, 0});
            if (passes[k] == 2) {
                tracks_.push_back({k, 1});
                tracks_.push_back({k, -1});
            }
        }
        for (std::uint32_t t = 0; t < tracks_.size(); ++t) {
            at_[g.walls[tracks_[t].wall].a].push_back(2 * t);
            at_[g.walls[tracks_[t].wall].b].push_back(2 * t + 1);
        }
        partner_.assign(2 * tracks_.size(), kNone);
        circuits_ = geom::DisjointSets(tracks_.size());
    }

    // Per circuit the ends in the order in which they are entered; the open circuit comes first.
    std::vector<std::vector<std::uint32_t>> run() {
        for (auto& ends : at_) pair_up(ends);
        for (bool joined = true; joined;) {
            joined = false;
            for (const auto& ends : at_) joined = join(ends) || joined;
        }
        std::vector<std::uint32_t> starts;
        for (std::uint32_t e = 0; e < partner_.size(); ++e)
            if (partner_[e] == kNone) starts.push_back(e);
        for (std::uint32_t e = 0; e < partner_.size(); e += 2) starts.push_back(e);
        std::vector<char> done(tracks_.size(), 0);
        std::vector<std::vector<std::uint32_t>> out;
        for (const auto start : starts) {
            if (done[start / 2] != 0) continue;
            out.emplace_back();
            for (auto e = start; e != kNone && done[e / 2] == 0; e = partner_[e ^ 1U]) {
                done[e / 2] = 1;
                out.back().push_back(e);
            }
        }
        return out;
    }

    [[nodiscard]] bool closed(const std::vector<std::uint32_t>& ends) const { return partner_[ends[0]] != kNone; }
    [[nodiscard]] const Track& track(std::uint32_t end) const { return tracks_[end / 2]; }

  private:
    // The sort key of an end around its node: its direction there, then its place beside its twin.
    [[nodiscard]] std::tuple<double, int, std::uint32_t> order(std::uint32_t end) const {
        const Track& t = tracks_[end / 2];
        const Wall& w = g_.walls[t.wall];
        const bool at_b = end % 2 != 0;
        const auto& line = w.line.points;
        const std::size_t n = line.size();
        const Vec2 from = at_b ? line[n - 1] : line[0], to = at_b ? line[n - 2] : line[1];
        return {std::atan2(to.y - from.y, to.x - from.x), at_b ? -t.side : t.side, end};
    }

    // Pairs neighbours around the node. If their number is odd, an end of a wall that is passed once is left over.
    void pair_up(std::vector<std::uint32_t>& ends) {
        std::sort(ends.begin(), ends.end(), [&](auto e, auto f) { return order(e) < order(f); });
        std::vector<std::uint32_t> rest = ends;
        if (rest.size() % 2 != 0) {
            const auto single =
                std::find_if(rest.begin(), rest.end(), [&](auto e) { return tracks_[e / 2].side == 0; });
            rest.erase(single == rest.end() ? rest.begin() : single);
        }
        for (std::size_t i = 0; i + 1 < rest.size(); i += 2) connect(rest[i], rest[i + 1]);
    }

    void connect(std::uint32_t e, std::uint32_t f) {
        partner_[e] = f;
        partner_[f] = e;
        circuits_.unite(e / 2, f / 2);
    }

    // True if the pairs (a, b) and (c, d), places around a node, cross.
    static bool cross(std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
        if (a > b) std::swap(a, b);
        return (c > a && c < b) != (d > a && d < b);
    }

    // Joins two circuits at the node, if two of its pairs, or a pair and an end of the curve, belong to different ones.
    // True if it did.
    bool join(const std::vector<std::uint32_t>& ends) {
        const std::size_t n = ends.size();
        std::vector<std::size_t> mate(n, n); // n: where the curve begins or ends
        for (std::size_t i = 0; i < n; ++i)
            if (const auto f = std::find(ends.begin(), ends.end(), partner_[ends[i]]); f != ends.end())
                mate[i] = static_cast<std::size_t>(f - ends.begin());
        const auto free = [&](std::size_t p, std::size_t q, std::initializer_list<std::size_t> but) {
            for (std::size_t i = 0; i < n; ++i)
                if (mate[i] < n && std::find(but.begin(), but.end(), i) == but.end() && cross(p, q, i, mate[i]))
                    return false;
            return true;
        };
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t c = 0; c < n; ++c) {
                const std::size_t b = mate[a], d = mate[c];
                if (b == n || b < a || circuits_.root(ends[a] / 2) == circuits_.root(ends[c] / 2)) continue;
                if (d == n) { // the curve continues into the circuit and ends where that returns
                    for (const auto& [p, q] : {std::pair{a, b}, std::pair{b, a}}) {
                        if (!free(p, c, {a, b, c})) continue;
                        connect(ends[p], ends[c]);
                        partner_[ends[q]] = kNone;
                        return true;
                    }
                    continue;
                }
                for (const auto& [p, q, r, s] : {std::tuple{a, c, b, d}, std::tuple{a, d, b, c}}) {
                    if (cross(p, q, r, s) || !free(p, q, {a, b, c, d}) || !free(r, s, {a, b, c, d})) continue;
                    connect(ends[p], ends[q]);
                    connect(ends[r], ends[s]);
                    return true;
                }
            }
        return false;
    }

    const WallGraph& g_;
    std::vector<Track> tracks_;
    std::vector<std::vector<std::uint32_t>> at_; // per node: ends, in their order around it
    std::vector<std::uint32_t> partner_; // per end: the end that follows it; kNone where the curve begins or ends
    geom::DisjointSets circuits_;        // of tracks
};

Vec2 unit(Vec2 v) {
    const double l = geom::norm(v);
    return l > 0 ? (1 / l) * v : Vec2{1, 0};
}

// Drops points of a lane that lie too near to the middle line: inside its bends they would fold over.
void unfold(const Wall& w, toolpath::Curve& lane) {
    const auto& middle = w.line.points;
    const auto& width = w.line.width;
    const std::size_t n = middle.size();
    toolpath::Curve out;
    for (std::size_t i = 0; i < n; ++i) {
        const double least = 0.98 * width[i] / 4;
        const auto far = [&](std::size_t k) { // true if the point keeps away from segment k
            return geom::point_segment_distance(middle[k], middle[k + 1], lane.points[i]) >= least;
        };
        bool free = true;
        double along = 0;
        for (std::size_t k = i; k + 1 < n && free && along < 2 * width[i]; ++k) {
            free = far(k);
            along += geom::distance(middle[k], middle[k + 1]);
        }
        along = 0;
        for (std::size_t k = i; k > 0 && free && along < 2 * width[i]; --k) {
            free = far(k - 1);
            along += geom::distance(middle[k - 1], middle[k]);
        }
        if (free || i == 0 || i + 1 == n) out.add(lane.points[i], lane.width[i]);
    }
    lane = std::move(out);
}

// The lane without `first` mm at its start and `last` mm at its end, at most a third of it each.
toolpath::Curve trimmed(const toolpath::Curve& lane, double first, double last) {
    const auto sums = toolpath::arc_lengths(lane);
    const double all = sums.back(), end = all - std::min(last, all / 3);
    toolpath::Curve out;
    add_stretch(lane, place_at(lane, sums, std::min(first, all / 3)), place_at(lane, sums, end), out);
    return out;
}

// The line of one pass, from node a to node b of the wall. `dead_a`, `dead_b`: that node is a dead end, where lanes
// turn. Without `apart` both passes of a wall follow its middle.
toolpath::Curve line(const Wall& w, int side, bool apart, bool dead_a, bool dead_b) {
    toolpath::Curve out = w.line;
    if (side == 0) return out;
    for (double& wide : out.width) wide /= 2;
    if (!apart) return out;
    const auto& middle = w.line.points;
    const std::size_t n = middle.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 before = i > 0 ? unit(middle[i] - middle[i - 1]) : Vec2{},
                   after = i + 1 < n ? unit(middle[i + 1] - middle[i]) : Vec2{};
        const Vec2 along = unit(before + after);
        const double quarter = w.line.width[i] / 4;
        out.points[i] = middle[i] + side * quarter * geom::left_of(along);
        // lanes reach to the end of the wall
        if (i == 0 && dead_a) out.points[i] = out.points[i] - quarter * along;
        if (i + 1 == n && dead_b) out.points[i] = out.points[i] + quarter * along;
    }
    unfold(w, out);
    return trimmed(out, dead_a ? 0 : w.line.width.front() / 2, dead_b ? 0 : w.line.width.back() / 2);
}

toolpath::Curve lay_walls(const WallGraph& g, const Circuit& circuit, const std::vector<std::uint32_t>& ends,
                          bool closed, bool apart) {
    std::vector<int> degree(g.node.size(), 0);
    for (const Wall& w : g.walls) {
        ++degree[w.a];
        ++degree[w.b];
    }
    toolpath::Curve out;
    out.closed = closed;
    const auto push = [&](Vec2 p, double width) {
        p = toolpath::on_grid(p);
        if (!out.points.empty() && out.points.back() == p) return;
        out.add(p, width);
    };
    for (const auto e : ends) {
        const Track& t = circuit.track(e);
        const Wall& w = g.walls[t.wall];
        toolpath::Curve l = line(w, t.side, apart, degree[w.a] == 1, degree[w.b] == 1);
        if (e % 2 != 0) l.reverse();
        const auto first = e % 2 != 0 ? w.b : w.a, last = e % 2 != 0 ? w.a : w.b;
        if (t.side != 0 && degree[first] > 1) push(g.node[first], l.width.front());
        for (std::size_t i = 0; i < l.points.size(); ++i) push(l.points[i], l.width[i]);
        if (t.side != 0 && degree[last] > 1) push(g.node[last], l.width.back());
    }
    if (closed && out.points.size() > 3 && out.points.front() == out.points.back()) out.drop_last();
    return out;
}

} // namespace

WallWalk wall_walk(const WallGraph& g) {
    const auto passes = passes_of_walls(g);
    Circuit circuit(g, passes);
    const auto all = circuit.run();
    WallWalk out;
    for (const bool apart : {true, false}) { // if lanes cross, both follow the middle
        out.curves.clear();
        for (const auto& ends : all) out.curves.push_back(lay_walls(g, circuit, ends, circuit.closed(ends), apart));
        if (join::crossing_pairs(out.curves, 0.5).empty()) break;
    }
    for (std::size_t k = 0; k < g.walls.size(); ++k)
        if (passes[k] > 1) {
            out.twice += g.walls[k].length;
            out.at = g.walls[k].line.points.front();
        }
    return out;
}

} // namespace filum::fill::walls
