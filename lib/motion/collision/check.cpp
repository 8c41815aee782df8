#include "collision/check.hpp"

#include "kinematics/chain.hpp"
#include "parallel/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::collision {

namespace {

constexpr std::size_t kGrain = 2048;  // moves per task
constexpr std::size_t kTogether = 8;  // most moves that are tested together
constexpr std::size_t kSamples = 512; // sample moves that are checked first, to get a good bound
constexpr double kArc = 1.02;         // arcs of chords up to 0.5 are longer by no more than this factor

Vec3 any_across(const Vec3& v) {
    const Vec3 other = std::abs(v.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 c = cross(v, other);
    return (1 / norm(c)) * c;
}

// Interpolates between unit vectors at even speed along the great circle.
Vec3 turned(const Vec3& a, const Vec3& b, double share) {
    const double all = geom::angle(a, b);
    if (all < 1e-9) return share < 0.5 ? a : b;
    const Vec3 across = b - dot(a, b) * a;
    const double l = norm(across);
    const Vec3 towards = l > 1e-9 ? (1 / l) * across : any_across(a);
    return std::cos(share * all) * a + std::sin(share * all) * towards;
}

struct Search {
    const Scene& scene;
    const Shapes shapes;
    const std::vector<Move>& moves;
    const Options& options;

    // Clearances below this are collisions; solid things must not even be touched.
    [[nodiscard]] double demanded(Obstacle against) const {
        return against == Obstacle::beads ? options.margin - options.press : std::max(options.margin, kTouch);
    }

    [[nodiscard]] Probe probe(const ToolFrame& stance, const Move& m, Obstacle against, double cutoff) const {
        return {stance, against == Obstacle::beads ? m.before : 1, options.press, cutoff};
    }

    // One move checked against one kind of obstacle.
    struct MoveCheck {
        std::size_t move;
        Obstacle against;
        Motion motion;
        Place worst;
        bool found = false;
    };

    void look(MoveCheck& c, double begin, double end, int depth, double& best) const {
        const Move& m = moves[c.move];
        const Tree& tree = scene[static_cast<std::size_t>(c.against)];
        if (c.found && c.worst.clearance <= -tree.deepest()) return; // it cannot get worse
        const double middle = (begin + end) / 2, half = (end - begin) / 2;
        double cutoff = std::max(best, demanded(c.against));
        if (c.found) cutoff = std::min(cutoff, c.worst.clearance);
        Probe p = probe(at(m, middle), m, c.against, cutoff);
        p.shift = half * c.motion.length;
        p.turn = half * c.motion.turn;
        p.sink = half * std::abs(dot(c.motion.way, p.stance.axis));
        const auto near = tree.any(shapes.of(m.tool), p, {at(m, begin), at(m, end)}, options.step);
        if (near == Tree::Proximity::nothing) return;
        if (near == Tree::Proximity::moving && depth < kHalvings) {
            look(c, begin, middle, depth + 1, best);
            look(c, middle, end, depth + 1, best);
            return;
        }
        p.shift = p.turn = p.sink = 0;
        const auto hit = tree.nearest(shapes.of(m.tool), p);
        if (!hit.found) return;
        c.worst = {c.move, middle, hit.distance, p.stance.tip, hit.piece, c.against};
        c.found = true;
        best = std::min(best, hit.distance);
    }

    // False if nothing comes nearer than `cutoff` on any of these moves, bounded by their deviation from the straight
    // move from the first stance to the last; true if the tool turns far.
    [[nodiscard]] bool may_meet(std::size_t begin, std::size_t end, Obstacle against, double cutoff) const {
        const ToolFrame &first = moves[begin].from, &last = moves[end - 1].to;
        Probe p = probe(moves[begin + (end - begin) / 2].from, moves[end - 1], against, cutoff);
        Sweep sweep{first, last};
        bool round = first.side == Vec3{} || last.side == Vec3{};
        double length = 0, gone = 0, most = 0;
        for (std::size_t i = begin; i < end; ++i) length += distance(moves[i].from.tip, moves[i].to.tip);
        const auto stretch = [&](const ToolFrame& s, double share) {
            sweep.stray = std::max(sweep.stray, norm(s.tip - first.tip - share * (last.tip - first.tip)));
            round = round || s.side == Vec3{};
            const double twist = round ? 0 : norm(s.side - first.side - share * (last.side - first.side));
            sweep.lean = std::max(sweep.lean, twist + norm(s.axis - first.axis - share * (last.axis - first.axis)));
            const Vec3 way = s.tip - p.stance.tip;
            p.shift = std::max(p.shift, norm(way));
            p.sink = std::max(p.sink, std::abs(dot(way, p.stance.axis)));
            p.turn = std::max(p.turn, norm(s.axis - p.stance.axis) + (round ? 0 : norm(s.side - p.stance.side)));
        };
        for (std::size_t i = begin; i < end; ++i) {
            const Move& m = moves[i];
            if (m.tool != moves[begin].tool) return true; // another head
            stretch(m.from, length > 0 ? gone / length : 0);
            gone += distance(m.from.tip, m.to.tip);
            stretch(m.to, length > 0 ? gone / length : 1);
            most = std::max(most, norm(m.to.axis - m.from.axis) + (round ? 0 : 2 * norm(m.to.side - m.from.side)));
        }
        if (round) p.stance.side = sweep.from.side = sweep.to.side = {};
        const double turn = norm(last.axis - first.axis) + (round ? 0 : 2 * norm(last.side - first.side));
        if (p.turn > 0.5 || turn > 0.5 || most > 0.5) return true;
        // Converts chords to angles, and accounts for the deviation of arcs from their chords.
        sweep.lean = kArc * (sweep.lean + (turn * turn + most * most) / 8);
        p.turn *= kArc;
        return scene[static_cast<std::size_t>(against)].any(shapes.of(moves[begin].tool), p, sweep, 0) !=
               Tree::Proximity::nothing;
    }

    // Checks moves; `best` is the least clearance so far.
    void follow(std::size_t begin, std::size_t end, Obstacle against, double& best, CheckResult& out) const {
        if (end - begin > 1) {
            if (end - begin <= kTogether && !may_meet(begin, end, against, std::max(best, demanded(against)))) return;
            const std::size_t half = begin + (end - begin) / 2;
            follow(begin, half, against, best, out);
            follow(half, end, against, best, out);
            return;
        }
        MoveCheck c{begin, against, motion(moves[begin]), {}, false};
        const double before = best;
        look(c, 0, 1, 0, best);
        if (!c.found) return;
        if (c.worst.clearance < before) out.least[static_cast<std::size_t>(against)] = c.worst;
        if (c.worst.clearance < demanded(against)) out.collisions.push_back(c.worst);
    }

    // Checks moves against all kinds of obstacles, starting with the least clearances `best`.
    void chunk(std::size_t begin, std::size_t end, std::array<double, 4> best, CheckResult& out) const {
        for (std::size_t k = 0; k < scene.size(); ++k)
            if (!scene[k].empty()) follow(begin, end, static_cast<Obstacle>(k), best[k], out);
        auto& all = out.collisions;
        std::stable_sort(all.begin(), all.end(), [](const Place& a, const Place& b) { return a.move < b.move; });
        for (std::size_t i = 0; i < all.size(); ++i) out.moves += i == 0 || all[i].move != all[i - 1].move ? 1 : 0;
    }

    // The least clearance in the middle of some sample moves, as a start.
    [[nodiscard]] CheckResult sample() const {
        CheckResult out;
        const std::size_t stride = std::max<std::size_t>(1, moves.size() / kSamples);
        for (std::size_t i = stride / 2; i < moves.size(); i += stride)
            for (std::size_t k = 0; k < scene.size(); ++k) {
                const auto against = static_cast<Obstacle>(k);
                const double so_far = out.least[k] ? out.least[k]->clearance : std::numeric_limits<double>::infinity();
                const ToolFrame stance = at(moves[i], 0.5);
                const auto hit = scene[k].nearest(shapes.of(moves[i].tool), probe(stance, moves[i], against, so_far));
                if (hit.found) out.least[k] = Place{i, 0.5, hit.distance, stance.tip, hit.piece, against};
            }
        return out;
    }
};

} // namespace

ToolFrame at(const Move& m, double along) {
    ToolFrame out;
    out.tip = m.from.tip + along * (m.to.tip - m.from.tip);
    out.axis = turned(m.from.axis, m.to.axis, along);
    out.side = {};
    if (m.from.side != Vec3{} && m.to.side != Vec3{}) out.side = turned(m.from.side, m.to.side, along);
    return out;
}

Motion motion(const Move& m) {
    double turn = geom::angle(m.from.axis, m.to.axis);
    if (m.from.side != Vec3{} && m.to.side != Vec3{}) turn += geom::angle(m.from.side, m.to.side);
    return {m.to.tip - m.from.tip, distance(m.from.tip, m.to.tip), turn};
}

CheckResult check(const Scene& scene, const Heads& heads, const std::vector<Move>& moves, const Options& options,
                  int threads) {
    const Search search{scene, Shapes(heads), moves, options};
    CheckResult out = search.sample();
    std::array<double, 4> seed{};
    for (std::size_t k = 0; k < seed.size(); ++k)
        seed[k] = out.least[k] ? out.least[k]->clearance : std::numeric_limits<double>::infinity();
    std::vector<CheckResult> part((moves.size() + kGrain - 1) / kGrain);
    parallel::for_chunks(moves.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        search.chunk(begin, end, seed, part[begin / kGrain]);
    });
    for (const CheckResult& f : part) {
        out.collisions.insert(out.collisions.end(), f.collisions.begin(), f.collisions.end());
        out.moves += f.moves;
        for (std::size_t k = 0; k < seed.size(); ++k)
            if (f.least[k] && (!out.least[k] || f.least[k]->clearance < out.least[k]->clearance))
                out.least[k] = f.least[k];
    }
    return out;
}

std::vector<Solid> bed(const std::vector<Move>& moves) {
    constexpr double around = 300;
    geom::Box2 box;
    for (const Move& m : moves) {
        box.add(m.from.tip.xy());
        box.add(m.to.tip.xy());
    }
    if (box.empty()) return {};
    const double x0 = box.lo.x - around, x1 = box.hi.x + around, y0 = box.lo.y - around, y1 = box.hi.y + around;
    return {{{Vec3{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}}, 0, 0}};
}

} // namespace filum::collision
