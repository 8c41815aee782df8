#include "absorb/nose.hpp"

#include "absorb/turn.hpp"

#include <algorithm>

namespace filum::absorb {

namespace {

constexpr double kLeastScore = 1.0; // pixels
constexpr double kNoseReach = 1.6;  // bead widths from a root to what its nose may cover
constexpr double kNarrowest = 0.2;  // bead widths: a tip, where the bead was not narrower before
constexpr double kStep = 0.03;      // bead widths: between two points where the width jumps

// The tip of a nose: how far along the curve it begins on both sides, in widths of the bead; the way from the root to
// the target, as a share; the width there, as a share of the bead's; and whether the target is the farthest pixel of
// the void or the deepest.
struct Shape {
    double reach, way, width;
    bool far;
};

// Those that were best for nine of ten voids of two hundred slices, the most frequent first.
constexpr Shape kAtCorner[] = {{0.5, 0.8, 0.2, false}, {0.5, 0.35, 0.6, true},  {0.25, 0.1, 1.4, false},
                               {0.5, 0.1, 1.4, false}, {0.5, 0.35, 0.6, false}, {0.25, 0.5, 0.2, true},
                               {0.5, 0.2, 1.0, true},  {0.8, 0.35, 0.6, true},  {0.8, 0.65, 0.2, true}};
constexpr Shape kAtSide[] = {{0.25, 0.1, 1.4, false}, {0.25, 0.65, 0.2, false}, {0.25, 0.2, 1.4, false},
                             {0.25, 0.5, 0.2, true},  {0.25, 0.35, 0.6, true},  {0.8, 0.5, 1.0, true}};

std::vector<Shape> grid(std::span<const double> reaches, std::span<const double> ways) {
    std::vector<Shape> out;
    for (const double reach : reaches)
        for (const bool far : {true, false})
            for (const double way : ways)
                for (const double width : {0.2, 0.6, 1.0, 1.4}) out.push_back({reach, way, width, far});
    return out;
}

std::span<const Shape> shapes(const Root& root, const Search& search) {
    static const std::vector<Shape> all = grid(std::array{0.25, 0.5, 0.8}, std::array{0.1, 0.2, 0.35, 0.5});
    if (search.thorough && search.small) return all;
    return root.vertex ? std::span<const Shape>(kAtCorner) : std::span<const Shape>(kAtSide);
}

// A nose's shoulders: points `reach` along the old course before and after the root, with the widths that leave the
// rest of the bead as it was; the ends of the course where they are nearer.
struct Shoulders {
    std::vector<Knot> left, right; // one knot or none
    Scores::Part rest;             // the old course up to them
};

Shoulders shoulders(const Chain& chain, const Root& root, double reach, const Scores& scores) {
    const Knot &from = scores.from(), &to = scores.to();
    const double left = root.vertex ? chain[*root.vertex].knot.width : to.width;
    const double right = root.vertex ? chain[*root.vertex].knot.width : from.width;
    const double l = geom::distance(root.at, from.at), r = geom::distance(root.at, to.at);
    Shoulders s;
    if (l > 1.1 * reach) {
        s.left.push_back({snapped(geom::lerp(root.at, from.at, reach / l)), left});
        scores.add(s.rest, from, s.left[0]);
    }
    if (r > 1.1 * reach) {
        s.right.push_back({snapped(geom::lerp(root.at, to.at, reach / r)), right});
        scores.add(s.rest, s.right[0], to);
    }
    return s;
}

void keep(const Scores& scores, Course& course, std::vector<Course>& out) {
    course.score = scores(course.knots);
    if (course.score >= kLeastScore) out.push_back(course);
}

// The corner at a node: unit directions into it, out of it, and away from its inner side.
struct Corner {
    Vec2 in, on, outwards;
    // How far along `outwards` the middle of a bead of `width` lies whose edge is where that of one of `old` was.
    [[nodiscard]] double way(double old, double width) const {
        const double normal = std::abs(geom::cross(outwards, on));
        return normal > 0.2 ? (old - width) / 2 / normal : 0;
    }
};

Corner corner_at(const Chain& chain, std::uint32_t i) {
    Corner c{
        unit(chain.point(i) - chain.point(chain[i].before)), unit(chain.point(chain[i].next) - chain.point(i)), {}};
    c.outwards = unit(c.in - c.on);
    return c;
}

// From the corner `from` on along one side of a short leg: the corner at its other end and the nodes up to it.
std::vector<std::uint32_t> leg(const Chain& chain, std::uint32_t from, bool ahead, double longest) {
    constexpr double kStraight = 0.3, kTurns = 0.8; // rad
    std::vector<std::uint32_t> nodes{from};
    double length = 0;
    for (std::uint32_t i = from; nodes.size() < 5;) {
        const std::uint32_t j = ahead ? chain[i].next : chain[i].before;
        length += geom::distance(chain.point(i), chain.point(j));
        if (length > longest || j == from) break;
        nodes.push_back(i = j);
        const double t = turn(chain, j);
        if (std::abs(t) > kTurns && t * turn(chain, from) > 0) {
            if (!ahead) std::reverse(nodes.begin(), nodes.end());
            return nodes;
        }
        if (std::abs(t) > kStraight) break;
    }
    return {};
}

} // namespace

void noses(const Tile& tile, const Chain& chain, const Root& root, const Void& v, const Search& search,
           std::vector<Course>& out) {
    Vec2 far = root.at;
    double most = 0;
    for (const Pixel p : v.pixels) {
        const double d = geom::distance(tile.centre(p), root.at);
        if (d > most && d <= kNoseReach * search.width) most = d, far = tile.centre(p);
    }
    const Vec2 deep = tile.centre(v.deepest);
    const Scores scores(tile, chain, root.from, root.to, window(tile, 0.5 * (root.at + deep)), search.prices);
    const double narrowest = std::min(kNarrowest * search.width, root.width);
    Course c{root.from, root.to, {}, {}, 0};
    if (root.vertex) c.nodes.push_back(*root.vertex);
    double reach = -1;
    Shoulders s;
    for (const Shape& shape : shapes(root, search)) {
        const Knot tip{snapped(geom::lerp(root.at, shape.far ? far : deep, shape.way)), shape.width * root.width};
        if (tip.width < narrowest || !tile.well_inside(tip.at)) continue;
        if (shape.reach != reach) s = shoulders(chain, root, shape.reach * root.width, scores), reach = shape.reach;
        c.knots = s.left;
        c.knots.push_back(tip);
        c.knots.insert(c.knots.end(), s.right.begin(), s.right.end());
        std::vector<Knot> line;
        if (s.left.empty()) line.push_back(scores.from());
        line.insert(line.end(), c.knots.begin(), c.knots.end());
        if (s.right.empty()) line.push_back(scores.to());
        c.score = scores(s.rest, line);
        if (c.score >= kLeastScore) out.push_back(c);
        if (search.done(out)) return;
    }
}

void blades(const Tile& tile, const Chain& chain, const Root& root, const Search& search, std::vector<Course>& out) {
    constexpr double kLongest = 1.6; // bead widths
    if (!root.vertex || std::abs(turn(chain, *root.vertex)) < 0.8) return;
    for (const bool ahead : {false, true}) {
        const auto nodes = leg(chain, *root.vertex, ahead, kLongest * search.width);
        if (nodes.empty()) continue;
        const std::uint32_t i = nodes.front(), j = nodes.back();
        const Knot p = chain[i].knot, q = chain[j].knot;
        const double w = std::max(chain.bead(i).width, chain.bead(chain[j].before).width), step = kStep * w;
        Course c{chain[i].before, chain[j].next, nodes, {}, 0};
        if (c.from == j || c.to == i || c.from == c.to) continue;
        const Corner a = corner_at(chain, i), b = corner_at(chain, j);
        const Vec2 out_b = unit(b.in - b.on);
        const Scores scores(tile, chain, c.from, c.to, window(tile, 0.5 * (p.at + q.at)), search.prices);
        for (const double n : {0.45, 0.3, 0.6, 0.75}) {
            const Corner end{b.on, b.in, out_b}; // seen from its other side
            const double x = a.way(w, n * w), y = end.way(w, n * w);
            if (x < step || y < step) continue;
            for (const auto& [s, t] : {std::pair{1.0, 1.0}, std::pair{1.0, 0.0}, std::pair{0.0, 1.0}}) {
                const Vec2 u = snapped(p.at + x * a.outwards), v = snapped(q.at + y * out_b);
                if ((s > 0 && !tile.well_inside(u)) || (t > 0 && !tile.well_inside(v))) continue;
                c.knots = {p, {snapped(p.at + step * a.outwards), n * w}};
                if (s > 0) c.knots.push_back({u, n * w});
                if (t > 0) c.knots.push_back({v, n * w});
                c.knots.push_back({snapped(q.at + step * out_b), n * w}), c.knots.push_back(q);
                if (c.knots.size() >= c.nodes.size()) keep(scores, c, out);
                if (search.done(out)) return;
            }
        }
    }
}

void ears(const Tile& tile, const Chain& chain, const Root& root, const Search& search, std::vector<Course>& out) {
    if (!root.vertex || std::abs(turn(chain, *root.vertex)) < 0.6) return;
    const Corner corner = corner_at(chain, *root.vertex);
    const Knot p = chain[*root.vertex].knot;
    const double w = root.width, step = kStep * w;
    const Scores scores(tile, chain, root.from, root.to, window(tile, p.at), search.prices);
    for (const double n : {0.15, 0.25, 0.35, 0.5})
        for (const double apart : {0.0, 0.1, 0.2, 0.3}) {
            const double x = corner.way(w, n * w);
            if (x < 2 * step || !tile.well_inside(p.at + x * corner.outwards)) continue;
            const Vec2 l = p.at - (std::max(step, apart * w)) * corner.in,
                       r = p.at + (std::max(step, apart * w)) * corner.on;
            Course c{root.from, root.to, {*root.vertex}, {}, 0};
            c.knots = {{snapped(l), p.width},
                       {snapped(l + step * corner.outwards), n * w},
                       {snapped(p.at + x * corner.outwards), n * w},
                       {snapped(r + step * corner.outwards), n * w},
                       {snapped(r), p.width}};
            if (geom::distance(scores.from().at, p.at) < 2 * apart * w ||
                geom::distance(scores.to().at, p.at) < 2 * apart * w)
                continue;
            keep(scores, c, out);
        }
}

} // namespace filum::absorb
