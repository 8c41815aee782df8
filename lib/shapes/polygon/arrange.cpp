#include "polygon/arrange.hpp"

#include "geom/disjoint_sets.hpp"
#include "polygon/parted.hpp"
#include "polygon/simple.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace filum::polygon {

namespace {

GridPoint on_grid(Vec2 p) { return {std::llround(p.x * kGridPerMm), std::llround(p.y * kGridPerMm)}; }
Vec2 off_grid(GridPoint p) { return {static_cast<double>(p.x) / kGridPerMm, static_cast<double>(p.y) / kGridPerMm}; }

// The order of the walls that the upright sweep line crosses, lowest first. The node of a wall keeps its place, because
// no two walls cross.
struct LowerWall {
    const std::vector<GridWall>* walls;
    using is_transparent = void;
    bool operator()(std::uint32_t w, GridPoint p) const { return turn((*walls)[w].a, (*walls)[w].b, p) > 0; }
    bool operator()(GridPoint p, std::uint32_t w) const { return turn((*walls)[w].a, (*walls)[w].b, p) < 0; }
    // Compares two walls, which happens only when one is inserted beside the other.
    bool operator()(std::uint32_t v, std::uint32_t w) const {
        const GridWall &e = (*walls)[v], &f = (*walls)[w];
        if (e.a == f.a) return turn(e.a, e.b, f.b) > 0;
        return e.a < f.a ? turn(e.a, e.b, f.a) > 0 : turn(f.a, f.b, e.a) < 0;
    }
};

class FaceSweep {
  public:
    explicit FaceSweep(const std::vector<GridWall>& walls)
        : walls_(walls), at_(LowerWall{&walls_}), place_(walls.size()), above_(walls.size()), below_(walls.size()),
          faces_(1), winding_(1, 0) {}

    // Sweeps over the ends of the walls; false if walls cross after all.
    bool run() {
        std::vector<std::uint32_t> ending(walls_.size());
        std::iota(ending.begin(), ending.end(), 0U);
        std::sort(ending.begin(), ending.end(), [&](std::uint32_t v, std::uint32_t w) {
            return walls_[v].b != walls_[w].b ? walls_[v].b < walls_[w].b : v < w;
        });
        for (std::uint32_t first = 0, done = 0; done < walls_.size();) {
            GridPoint p = walls_[ending[done]].b;
            if (first < walls_.size()) p = std::min(p, walls_[first].a);
            std::uint32_t last = first, ended = done;
            while (last < walls_.size() && walls_[last].a == p) ++last;
            while (ended < walls_.size() && walls_[ending[ended]].b == p) ++ended;
            if (!pass(p, {ending.data() + done, ended - done}, first, last)) return false;
            first = last;
            done = ended;
        }
        return true;
    }

    Arrangement result() {
        Arrangement out;
        std::vector<std::uint32_t> number;
        out.winding.resize(faces_.number(number));
        for (std::size_t f = number.size(); f-- > 0;) out.winding[number[f]] = winding_[f];
        out.borders.reserve(walls_.size());
        for (std::size_t w = 0; w < walls_.size(); ++w)
            out.borders.push_back({off_grid(walls_[w].a), off_grid(walls_[w].b), number[above_[w]], number[below_[w]],
                                   walls_[w].weight, walls_[w].marked});
        return out;
    }

  private:
    using Active = std::set<std::uint32_t, LowerWall>;

    // Removes the walls that end at p and returns their place and the face above them. False unless they are
    // neighbours.
    bool take_out(std::span<const std::uint32_t> ending, Active::iterator& after, std::uint32_t& face_above) {
        auto lowest = place_[ending[0]];
        for (const std::uint32_t w : ending)
            if (at_.key_comp()(w, *lowest)) lowest = place_[w];
        after = lowest;
        for (std::size_t k = 0; k < ending.size(); ++k) {
            if (after == at_.end() || walls_[*after].b != walls_[ending[0]].b) return false;
            face_above = above_[*after];
            after = at_.erase(after);
        }
        return true;
    }

    bool pass(GridPoint p, std::span<const std::uint32_t> ending, std::uint32_t first, std::uint32_t last) {
        Active::iterator after;
        std::uint32_t face_above = 0;
        if (ending.empty())
            after = at_.lower_bound(p);
        else if (!take_out(ending, after, face_above))
            return false;
        const std::uint32_t face_below = after == at_.begin() ? 0 : above_[*std::prev(after)];
        if (ending.empty()) face_above = face_below;
        if (first == last) {
            faces_.unite(face_below, face_above);
            return true;
        }
        // Sorts the walls that begin at p by their other ends, lowest first.
        order_.resize(last - first);
        std::iota(order_.begin(), order_.end(), first);
        std::sort(order_.begin(), order_.end(),
                  [&](std::uint32_t v, std::uint32_t w) { return turn(p, walls_[v].b, walls_[w].b) > 0; });
        std::uint32_t face = face_below;
        for (const std::uint32_t w : order_) {
            place_[w] = at_.emplace_hint(after, w);
            below_[w] = face;
            if (w == order_.back())
                face = face_above;
            else {
                winding_.push_back(winding_[face] + walls_[w].weight);
                face = faces_.add();
            }
            above_[w] = face;
        }
        return true;
    }

    const std::vector<GridWall>& walls_;
    Active at_;
    std::vector<Active::iterator> place_;
    std::vector<std::uint32_t> above_, below_; // the faces of each wall
    geom::DisjointSets faces_;
    std::vector<int> winding_;
    std::vector<std::uint32_t> order_;
};

// A border, directed so that solid is on its left.
struct Arc {
    GridPoint from, to;
};

std::vector<Arc> arcs_between(const Arrangement& plane, const std::function<bool(std::uint32_t)>& solid) {
    std::vector<Arc> out;
    for (const Border& b : plane.borders) {
        const bool left = solid(b.left), right = solid(b.right);
        if (left == right) continue;
        const GridPoint p = on_grid(b.a), q = on_grid(b.b);
        out.push_back(left ? Arc{p, q} : Arc{q, p});
    }
    std::sort(out.begin(), out.end(),
              [](const Arc& a, const Arc& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; });
    return out;
}

// Whether, seen from p and turning clockwise from `back`, a comes before b.
bool sooner_clockwise(GridPoint p, GridPoint back, GridPoint a, GridPoint b) {
    const auto behind = [&](GridPoint q) { return turn(p, back, q) > 0; }; // more than half a turn away
    if (behind(a) != behind(b)) return behind(b);
    return turn(p, a, b) < 0;
}

// A point of a loop, and whether another loop, or another pass of the same loop, goes through it.
struct Stop {
    GridPoint at;
    bool shared = false;
};

// Adds the loop without the points that lie in a straight line between their neighbours and that no other loop passes.
void add_loop(std::span<const Stop> loop, Loops& out) {
    const std::size_t n = loop.size(), before = out.points.size();
    for (std::size_t i = 0; i < n; ++i)
        if (loop[i].shared || turn(loop[(i + n - 1) % n].at, loop[i].at, loop[(i + 1) % n].at) != 0)
            out.points.push_back(off_grid(loop[i].at));
    if (out.points.size() < before + 3)
        out.points.resize(before);
    else
        out.close();
}

// Adds the loop, split so that no loop passes a point twice.
void add_apart(const std::vector<Stop>& loop, Loops& out) {
    std::vector<Stop> path;
    std::set<GridPoint> shared; // the shared points on the path
    for (const Stop& s : loop) {
        if (s.shared && !shared.insert(s.at).second) {
            auto from = path.end() - 1;
            while (from->at != s.at) shared.erase((from--)->at);
            add_loop({from, path.end()}, out);
            path.erase(from, path.end());
        }
        path.push_back(s);
    }
    add_loop(path, out);
}

} // namespace

std::optional<Arrangement> arrange(const std::vector<Wall>& walls) {
    std::vector<GridWall> on;
    on.reserve(walls.size());
    for (const Wall& w : walls) on.push_back({on_grid(w.a), on_grid(w.b), w.weight, w.marked});
    const auto pieces = parted(std::move(on));
    if (!pieces) return std::nullopt;
    FaceSweep sweep(*pieces);
    if (!sweep.run()) return std::nullopt;
    return sweep.result();
}

Loops outline(const Arrangement& plane, const std::function<bool(std::uint32_t)>& solid) {
    const std::vector<Arc> arcs = arcs_between(plane, solid);
    std::vector<char> used(arcs.size(), 0);
    const auto from = [&](GridPoint p) {
        return static_cast<std::size_t>(
            std::lower_bound(arcs.begin(), arcs.end(), p, [](const Arc& a, GridPoint q) { return a.from < q; }) -
            arcs.begin());
    };
    Loops out;
    std::vector<Stop> loop;
    for (std::size_t start = 0; start < arcs.size(); ++start) {
        if (used[start] != 0) continue;
        loop.clear();
        for (std::size_t i = start;;) {
            used[i] = 1;
            const GridPoint q = arcs[i].from, p = arcs[i].to;
            const auto leaves_too = [&](std::size_t k) { return k < arcs.size() && arcs[k].from == q; };
            loop.push_back({q, leaves_too(i + 1) || leaves_too(i - 1)}); // i - 1 may wrap to a huge number
            std::size_t next = arcs.size();
            for (std::size_t k = from(p); k < arcs.size() && arcs[k].from == p; ++k)
                if (used[k] == 0 &&
                    (next == arcs.size() || sooner_clockwise(p, arcs[i].from, arcs[k].to, arcs[next].to)))
                    next = k;
            if (next == arcs.size()) break;
            i = next;
        }
        add_apart(loop, out);
    }
    return out;
}

std::vector<Wall> walls(const Loops& loops) {
    std::vector<Wall> out;
    out.reserve(loops.points.size());
    for (std::size_t l = 0; l < loops.size(); ++l) {
        const auto loop = loops[l];
        for (std::size_t i = 0; i < loop.size(); ++i) out.push_back({loop[i], loop[(i + 1) % loop.size()]});
    }
    return out;
}

Loops unite_exactly(const Loops& loops, Fill rule) {
    const auto plane = arrange(walls(loops));
    if (!plane) return unite(loops, rule);
    return outline(*plane, [&](std::uint32_t face) {
        const int w = plane->winding[face];
        return rule == Fill::positive ? w > 0 : rule == Fill::even_odd ? w % 2 != 0 : w != 0;
    });
}

} // namespace filum::polygon
