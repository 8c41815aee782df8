#include "sequence/collision.hpp"

#include "geom/bvh.hpp"

#include <algorithm>
#include <optional>

namespace filum::sequence {

namespace {

using geom::Box2;

constexpr std::size_t kBlock = 8; // regions of a column that share a box

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
    std::vector<std::vector<Box2>> block; // per column, of every kBlock regions
    std::vector<Box2> box;                // per column
    std::optional<geom::Bvh> tree;        // over those
    double top = 0;                       // mm, of all
    std::vector<std::size_t> limit;       // per column: places from there on wait for the column at hand
    std::vector<Pair> found;

    [[nodiscard]] const Box2& box_of(Index v) const { return outlines[v].box[0]; }
    [[nodiscard]] Reach reach_of(Index v, Index u) const { return reach(head, g.node[u].z - g.node[v].z); }

    void boxes() {
        for (const auto& member : columns.member) {
            block.emplace_back((member.size() + kBlock - 1) / kBlock);
            box.emplace_back();
            for (std::size_t i = 0; i < member.size(); ++i) add(block.back()[i / kBlock], box_of(member[i]));
            for (const auto& b : block.back()) add(box.back(), b);
            limit.push_back(member.size());
            top = std::max(top, g.node[member.back()].z);
        }
        std::vector<geom::Box3> flat;
        for (const Box2& b : box) flat.push_back({{b.lo.x, b.lo.y, 0}, {b.hi.x, b.hi.y, 0}});
        tree.emplace(std::move(flat));
    }

    // The first place of column c, below `limit`, whose region stands in the way of v, of column a; `limit` if none.
    [[nodiscard]] std::size_t first(Index v, Index a, Index c, std::size_t limit) const {
        const auto& member = columns.member[c];
        const Index layer = g.node[v].layer, lowest = g.node[member[0]].layer;
        std::size_t i = layer + 1 > lowest ? layer + 1 - lowest : 0;
        if (i >= limit) return limit;
        // below the height at which the head reaches from column to column there is nothing to look at
        const auto out_of_reach = [&](Index u) { return !may_collide(box[a], box[c], reach_of(v, u)); };
        i = static_cast<std::size_t>(std::partition_point(member.begin() + static_cast<long>(i),
                                                          member.begin() + static_cast<long>(limit), out_of_reach) -
                                     member.begin());
        for (; i < limit; ++i) {
            if (i % kBlock == 0) {
                const std::size_t last = std::min(member.size(), i + kBlock) - 1;
                if (!may_collide(box_of(v), block[c][i / kBlock], reach_of(v, member[last]))) {
                    i = last;
                    continue;
                }
            }
            const Reach r = reach_of(v, member[i]);
            if (may_collide(box_of(v), box_of(member[i]), r) && within(outlines[v], outlines[member[i]], r)) return i;
        }
        return limit;
    }

    // A column whose lowest region rests on one that must wait for v waits as a whole.
    [[nodiscard]] bool implied(Index c) const {
        for (const Index p : g.before[columns.member[c][0]]) {
            const Index d = columns.of[p];
            if (g.node[p].layer - g.node[columns.member[d][0]].layer >= limit[d]) return true;
        }
        return false;
    }

    // The columns that the head can touch while it prints column a, ascending.
    [[nodiscard]] std::vector<Index> others(Index a) const {
        const double lowest = g.node[columns.member[a][0]].z;
        const Reach most = reach(head, top - lowest);
        std::vector<Index> out;
        const auto ask = [&](Index c) {
            const double dz = g.node[columns.member[c].back()].z - lowest;
            if (c != a && dz > 0 && may_collide(box[a], box[c], reach(head, dz))) out.push_back(c);
        };
        if (most.everywhere) {
            for (Index c = 0; c < columns.member.size(); ++c) ask(c);
            return out;
        }
        const double far = most.farthest();
        const Box2& own = box[a];
        tree->visit({{own.lo.x - far, own.lo.y - far, 0}, {own.hi.x + far, own.hi.y + far, 0}}, ask);
        std::sort(out.begin(), out.end());
        return out;
    }

    void column(Index a) {
        const auto& own = columns.member[a];
        const auto near = others(a);
        for (std::size_t i = own.size(); i-- > 0;) {
            const Index v = own[i];
            limit[a] = i; // what rests on v or higher waits for it by support
            for (const Index c : near) {
                if (limit[c] == 0) continue;
                if (implied(c)) {
                    limit[c] = 0;
                    continue;
                }
                const std::size_t at = first(v, a, c, limit[c]);
                if (at < limit[c]) found.emplace_back(v, columns.member[c][at]);
                limit[c] = at;
            }
        }
        limit[a] = own.size();
        for (const Index c : near) limit[c] = columns.member[c].size();
    }
};

} // namespace

std::vector<Pair> collisions(const Graph& g, const Columns& columns, const std::vector<Outline>& outlines,
                             const machine::Head& head) {
    PairSearch s{g, columns, outlines, head, {}, {}, {}, 0, {}, {}};
    s.boxes();
    for (Index a = 0; a < columns.member.size(); ++a) s.column(a);
    return std::move(s.found);
}

} // namespace filum::sequence
