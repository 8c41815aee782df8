#include "sequence/collision.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "geom/bvh.hpp"
#include "sequence/drift.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace filum::sequence {

namespace {

using geom::Box2;

constexpr std::size_t kBlock = 8; // regions of a column per box

void add(Box2& to, const Box2& b) {
    to.add(b.lo);
    to.add(b.hi);
}

bool may_collide(const Box2& a, const Box2& b, const Reach& r) {
    return r.everywhere || geom::distance(a, b) < r.radius ||
           (a.lo.x - b.hi.x < r.half_x && b.lo.x - a.hi.x < r.half_x && a.lo.y - b.hi.y < r.half_y &&
            b.lo.y - a.hi.y < r.half_y);
}

struct PairSearch {
    const Graph& g;
    const Columns& columns;
    const std::vector<Outline>& outlines;
    const machine::Head& head;
    DistanceWork& work;
    geom::Vec3 shift;                     // mm, from the tip in use to the tip of this head
    const std::vector<Outline>& over;     // the outlines, shifted: where this tip is while a region is printed
    std::vector<std::vector<Box2>> block; // per column, one per kBlock regions
    std::vector<Box2> box;                // per column
    std::vector<Drift> drifts;            // per column
    std::vector<Drift> drifts_over;       // per column, of the shifted outlines
    std::optional<geom::Bvh> tree;        // over the columns' boxes
    double top = 0;                       // mm, of all regions
    std::vector<std::size_t> limit;       // per column: places from there on wait for the current column
    std::vector<Pair> found;
    std::vector<Index> place_of; // per region: its place in its column

    [[nodiscard]] const Box2& box_of(Index v) const { return outlines[v].box; }
    [[nodiscard]] const Box2& box_over(Index v) const { return over[v].box; }
    [[nodiscard]] Box2 column_over(Index a) const { return {box[a].lo + shift.xy(), box[a].hi + shift.xy()}; }
    // How far u rises above the tip of this head while v is printed, mm.
    [[nodiscard]] double rise(Index v, Index u) const { return g.node[u].z - g.node[v].z - shift.z; }
    // The extent of the head up to the top of u; none if u does not rise above its tip.
    [[nodiscard]] Reach reach_of(Index v, Index u) const {
        const double dz = rise(v, u);
        return dz > 0 ? reach(head, dz) : Reach{-1, 0, 0, false};
    }

    void boxes() {
        place_of.resize(g.size());
        for (const auto& member : columns.member) {
            block.emplace_back((member.size() + kBlock - 1) / kBlock);
            box.emplace_back();
            for (std::size_t i = 0; i < member.size(); ++i) add(block.back()[i / kBlock], box_of(member[i]));
            for (const auto& b : block.back()) add(box.back(), b);
            limit.push_back(member.size());
            for (Index i = 0; i < member.size(); ++i) place_of[member[i]] = i;
            drifts.push_back(drift(member, outlines));
            drifts_over.push_back(shifted(drifts.back(), shift.xy()));
            top = std::max(top, g.node[member.back()].z);
        }
        std::vector<geom::Box3> flat;
        for (const Box2& b : box) flat.push_back({{b.lo.x, b.lo.y, 0}, {b.hi.x, b.hi.y, 0}});
        tree.emplace(std::move(flat));
    }

    // Whether the measured distance proves that the head over v, place i of column a, touches none of the places first
    // to last of column c.
    [[nodiscard]] bool clear(Index v, Index a, Index c, const RegionDistance& m, std::size_t first,
                             std::size_t last) const {
        const std::size_t i = place_of[v];
        const Drift& of_c = drifts[c];
        const double to_last = of_c.between(first, last);
        const double way = drifts_over[a].between(m.i, i) + std::max(of_c.between(m.k, first), of_c.between(m.k, last));
        const auto least = [&](Bounds d) {
            return std::max(d.least - way, relative(drifts_over[a], m.i, i, of_c, m.k, first, d).least - to_last);
        };
        const double apart = least(m.distance);
        if (!(apart > 0)) return false;
        const Reach r = reach_of(v, columns.member[c][last]);
        if (r.everywhere || apart < r.radius) return false;
        return std::hypot(r.half_x, r.half_y) <= apart || least(m.carriage) >= std::min(r.half_x, r.half_y);
    }

    // The first place in [first, limit) for which the measured distance does not prove that the head over v is clear.
    [[nodiscard]] std::size_t skip(Index v, Index a, Index c, const RegionDistance& m, std::size_t first,
                                   std::size_t limit) const {
        if (!clear(v, a, c, m, first, first)) return first;
        std::size_t proven = first, open = limit; // clear up to and including `proven`; from `open` on unknown
        while (open - proven > 1) {
            const std::size_t middle = proven + (open - proven) / 2;
            (clear(v, a, c, m, first, middle) ? proven : open) = middle;
        }
        return proven + 1;
    }

    // The first place in [first, limit) for which no measured distance proves that the head over v is clear.
    [[nodiscard]] std::size_t skip(Index v, Index a, Index c, const RegionDistances& measured, std::size_t first,
                                   std::size_t limit) const {
        for (std::size_t from = limit; from != first && first < limit;) { // a stretch may end where the next one begins
            from = first;
            measured.near(place_of[v], first, [&](const RegionDistance& m) {
                if (first < limit) first = skip(v, a, c, m, first, limit);
            });
        }
        return first;
    }

    // What measured distances say about the one between v and place k of column c.
    [[nodiscard]] RegionDistance known(Index v, Index a, Index c, const RegionDistances& measured,
                                       std::size_t k) const {
        RegionDistance out{place_of[v], k, {}, {}};
        measured.near(out.i, k, [&](const RegionDistance& m) {
            const auto add = [&](Bounds& to, Bounds before) {
                const Bounds now = relative(drifts_over[a], m.i, out.i, drifts[c], m.k, k, before);
                to = {std::max(to.least, now.least), std::min(to.most, now.most)};
            };
            add(out.distance, m.distance);
            add(out.carriage, m.carriage);
        });
        return out;
    }

    // Whether the head over v touches place k of column c; also if it may touch, and the work is used up.
    bool touches(Index v, Index a, Index c, std::size_t k, RegionDistances& measured) {
        const Index u = columns.member[c][k];
        const Reach r = reach_of(v, u);
        if (r.radius < 0) return false;
        if (r.everywhere) return true;
        const double half = std::min(r.half_x, r.half_y);
        const auto near = [&](const RegionDistance& d) {
            return d.distance.most < std::max(r.radius, half) || d.carriage.most < half;
        };
        RegionDistance m = known(v, a, c, measured, k);
        if (near(m)) return true;
        if (!work.may_measure()) {
            ++work.assumed;
            return true;
        }
        if (drifts_over[a].alone(m.i) || drifts[c].alone(k)) return within(over[v], outlines[u], r, &work.steps);
        if (half > 0) m.carriage = carriage_bounds(over[v], outlines[u], r.half_x, r.half_y, m.carriage, &work.steps);
        if (r.radius > half) m.distance = distance_bounds(over[v], outlines[u], r.radius, m.distance, &work.steps);
        // No point is farther away for the carriage than it is.
        m.distance.least = std::max(m.distance.least, m.carriage.least);
        m.carriage.most = std::min(m.carriage.most, m.distance.most);
        measured.add(m);
        return near(m);
    }

    // The first place of a column that is above `layer`. Mostly its layers follow each other without a gap.
    [[nodiscard]] std::size_t above(const std::vector<Index>& member, Index layer) const {
        const Index lowest = g.node[member.front()].layer;
        if (layer < lowest) return 0;
        if (g.node[member.back()].layer - lowest + 1 == member.size()) return layer + 1 - lowest;
        const auto at = std::upper_bound(member.begin(), member.end(), layer,
                                         [&](Index of, Index v) { return of < g.node[v].layer; });
        return static_cast<std::size_t>(at - member.begin());
    }

    // The first place of column c below `limit` whose region is in the way of v, of column a; `limit` if there is
    // none.
    [[nodiscard]] std::size_t first(Index v, Index a, Index c, std::size_t limit, RegionDistances& measured) {
        const auto& member = columns.member[c];
        std::size_t i = above(member, g.node[v].layer);
        if (i >= limit) return limit;
        // Below the height at which the head reaches from column to column there are no collisions.
        const auto out_of_reach = [&](Index u) { return !may_collide(column_over(a), box[c], reach_of(v, u)); };
        i = static_cast<std::size_t>(std::partition_point(member.begin() + static_cast<long>(i),
                                                          member.begin() + static_cast<long>(limit), out_of_reach) -
                                     member.begin());
        for (; i < limit; ++i) {
            i = skip(v, a, c, measured, i, limit);
            if (i == limit) break;
            if (i % kBlock == 0) {
                const std::size_t last = std::min(member.size(), i + kBlock) - 1;
                if (!may_collide(box_over(v), block[c][i / kBlock], reach_of(v, member[last]))) {
                    i = last;
                    continue;
                }
            }
            if (may_collide(box_over(v), box_of(member[i]), reach_of(v, member[i])) && touches(v, a, c, i, measured))
                return i;
        }
        return std::min(i, limit);
    }

    // Whether the whole column waits for v because its lowest region rests on one that must wait.
    [[nodiscard]] bool implied(Index c) const {
        for (const Index p : g.before[columns.member[c][0]]) {
            const Index d = columns.of[p];
            if (place_of[p] >= limit[d]) return true;
        }
        return false;
    }

    // The columns that the head can touch while it prints column a, ascending.
    [[nodiscard]] std::vector<Index> others(Index a) const {
        const double lowest = g.node[columns.member[a][0]].z + shift.z;
        const Reach most = reach(head, top - lowest);
        std::vector<Index> out;
        const auto ask = [&](Index c) {
            const double dz = g.node[columns.member[c].back()].z - lowest;
            if (c != a && dz > 0 && may_collide(column_over(a), box[c], reach(head, dz))) out.push_back(c);
        };
        if (most.everywhere) {
            for (Index c = 0; c < columns.member.size(); ++c) ask(c);
            return out;
        }
        const double far = most.farthest();
        const Box2 own = column_over(a);
        tree->visit({{own.lo.x - far, own.lo.y - far, 0}, {own.hi.x + far, own.hi.y + far, 0}}, ask);
        std::sort(out.begin(), out.end());
        return out;
    }

    void column(Index a) {
        const auto& own = columns.member[a];
        const auto near = others(a);
        std::vector<RegionDistances> measured_of(near.size());
        for (std::size_t i = own.size(); i-- > 0;) {
            const Index v = own[i];
            ++work.done;
            limit[a] = i; // regions that rest on v, and higher ones, wait for it by support
            for (std::size_t k = 0; k < near.size(); ++k) {
                const Index c = near[k];
                if (limit[c] == 0) continue;
                if (implied(c)) {
                    limit[c] = 0;
                    continue;
                }
                const std::size_t at = first(v, a, c, limit[c], measured_of[k]);
                if (at < limit[c]) found.emplace_back(v, columns.member[c][at]);
                limit[c] = at;
            }
        }
        limit[a] = own.size();
        for (const Index c : near) limit[c] = columns.member[c].size();
    }
};

constexpr double kLowest = 0.001; // mm, lower tips of idle tools touch the print; rounding of profiles is smaller

// Appends the collisions of one head while `tool` prints.
void add_collisions(const Graph& g, const Columns& columns, const std::vector<Outline>& outlines,
                    const machine::Head& head, Index tool, const geom::Vec3& shift, DistanceWork& work,
                    std::vector<Pair>& out) {
    std::vector<Outline> over;
    if (shift.xy() != geom::Vec2{})
        for (const Outline& o : outlines) over.push_back(shifted(o, shift.xy()));
    PairSearch s{g,  columns, outlines, head, work, shift, over.empty() ? outlines : over, {}, {}, {},
                 {}, {},      0,        {},   {},   {}};
    s.boxes();
    for (Index a = 0; a < columns.member.size(); ++a)
        if (g.node[columns.member[a][0]].tool == tool) s.column(a);
    out.insert(out.end(), s.found.begin(), s.found.end());
}

} // namespace

bool DistanceWork::may_measure() const {
    const double share = std::min(1.0, static_cast<double>(done) / static_cast<double>(std::max(regions, done)));
    return static_cast<double>(steps) < 0.5 * (1 + share) * static_cast<double>(limit);
}

std::vector<Pair> collisions(const Graph& g, const Columns& columns, const std::vector<Outline>& outlines,
                             const machine::Heads& heads, DistanceWork& work) {
    std::vector<Pair> out;
    const std::vector<Index> used = tools(g);
    work.regions = g.size() * used.size(); // at most: each one under each head
    for (const Index tool : used) {
        add_collisions(g, columns, outlines, heads.of(tool), tool, {}, work, out);
        for (const machine::Heads::Idle& idle : heads.beside(tool)) {
            if (used.size() == 1) break; // only one head is mounted
            if (idle.shift.z < -kLowest)
                throw Error(Exit::usage, "cannot print with tool " + std::to_string(tool) + ": the tip of tool " +
                                             std::to_string(idle.tool) + " hangs " + fixed_text(-idle.shift.z, 3) +
                                             " mm lower while it is idle and would touch the print; set tools.raised");
            add_collisions(g, columns, outlines, heads.of(idle.tool), tool, idle.shift, work, out);
        }
    }
    return out;
}

} // namespace filum::sequence
