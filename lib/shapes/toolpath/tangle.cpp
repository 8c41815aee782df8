#include "geom/segment_grid.hpp"
#include "toolpath/reach.hpp"

#include <algorithm>
#include <cmath>

namespace filum::toolpath {

namespace {

constexpr double kSagitta = 1e-3;  // mm, of the chords that replace an arc in the grid
constexpr double kTouching = 1e-9; // mm; ends that touch are not crossings, even after rounding
constexpr int kFine = 32;          // parts of each chord where two come close: their sagitta is a thousandth

// Moves as segments in the plane, each with the index of its move.
struct Chords {
    std::vector<geom::Segment> segments;
    std::vector<std::uint32_t> move;
};

// Whether both cross, each with its ends away from the other by more than kTouching.
bool cross_clearly(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    if (!geom::cross_properly(a, b, c, d)) return false;
    const double one = kTouching * geom::distance(a, b), other = kTouching * geom::distance(c, d);
    return std::abs(geom::orient(a, b, c)) > one && std::abs(geom::orient(a, b, d)) > one &&
           std::abs(geom::orient(c, d, a)) > other && std::abs(geom::orient(c, d, b)) > other;
}

Vec2 turned(Vec2 arm, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * arm.x - s * arm.y, s * arm.x + c * arm.y};
}

void add_arc(Chords& out, Vec2 from, Vec2 to, const Move& m) {
    const double radius = geom::distance(from, m.centre);
    const double step = 2 * std::acos(std::max(0.0, 1 - kSagitta / std::max(radius, kSagitta)));
    const int n = std::max(1, static_cast<int>(std::ceil(std::abs(m.sweep) / step)));
    const Vec2 arm = from - m.centre;
    Vec2 a = from;
    for (int k = 1; k <= n; ++k) {
        const Vec2 b = k == n ? to : m.centre + turned(arm, m.sweep * k / n);
        out.segments.push_back({a, b});
        a = b;
    }
}

// The nearest place that a program can express.
Vec2 rounded(Vec2 p, double grid) {
    return grid > 0 ? Vec2{std::round(p.x / grid) * grid, std::round(p.y / grid) * grid} : p;
}

Chords chords(Vec2 at, std::span<const Move> moves, double grid) {
    Chords out;
    at = rounded(at, grid);
    for (std::uint32_t m = 0; m < moves.size(); ++m) {
        const Vec2 to = rounded(moves[m].to.xy(), grid);
        if (moves[m].sweep != 0)
            add_arc(out, at, to, moves[m]);
        else
            out.segments.push_back({at, to});
        out.move.resize(out.segments.size(), m);
        at = to;
    }
    return out;
}

// The exact shape of a chord: of an arc, in parts.
std::vector<Vec2> piece(const geom::Segment& chord, const Move& m) {
    if (m.sweep == 0) return {chord.a, chord.b};
    const Vec2 arm = chord.a - m.centre, end = chord.b - m.centre;
    const double angle = std::atan2(geom::cross(arm, end), dot(arm, end));
    std::vector<Vec2> out{chord.a};
    for (int k = 1; k < kFine; ++k) out.push_back(m.centre + turned(arm, angle * k / kFine));
    out.push_back(chord.b);
    return out;
}

bool cross(const geom::Segment& s, const Move& m, const geom::Segment& t, const Move& n) {
    if (m.sweep == 0 && n.sweep == 0) return cross_clearly(s.a, s.b, t.a, t.b);
    if (geom::segment_distance(s.a, s.b, t.a, t.b) > 2 * kSagitta) return false;
    const auto p = piece(s, m), q = piece(t, n);
    for (std::size_t i = 0; i + 1 < p.size(); ++i)
        for (std::size_t k = 0; k + 1 < q.size(); ++k)
            if (cross_clearly(p[i], p[i + 1], q[k], q[k + 1])) return true;
    return false;
}

bool crossed_before(const Line& l, const Tangle& a, const geom::Segment& b) {
    for (std::uint32_t i = a.first; i <= a.last; ++i)
        if (geom::cross_properly(l.points[i].xy(), l.points[i + 1].xy(), b.a, b.b)) return true;
    return false;
}

bool crossed_before(const Line& l, const Tangle& a, const Tangle& b) {
    for (std::uint32_t i = a.first; i <= a.last; ++i)
        for (std::uint32_t k = b.first; k <= b.last; ++k)
            if (geom::cross_properly(l.points[i].xy(), l.points[i + 1].xy(), l.points[k].xy(), l.points[k + 1].xy()))
                return true;
    return false;
}

// Per chord whether its move differs from the line: it replaces other than one segment, or bends. Moves that do not can
// only cross each other where the line does, or where rounding decides.
std::vector<char> changed(const Line& line, std::span<const Move> moves, std::span<const std::uint32_t> begins,
                          const Chords& chords) {
    std::vector<char> out;
    out.reserve(chords.move.size());
    for (const std::uint32_t m : chords.move) {
        const std::uint32_t end = m + 1 < begins.size() ? begins[m + 1] : line.size() - 1;
        out.push_back(moves[m].sweep != 0 || end != begins[m] + 1 ? 1 : 0);
    }
    return out;
}

} // namespace

std::vector<Tangle> tangles(const Line& line, std::span<const Move> moves, std::span<const std::uint32_t> begins,
                            std::span<const geom::Segment> others, double grid) {
    std::vector<Tangle> out;
    const bool arcs = std::any_of(moves.begin(), moves.end(), [](const Move& m) { return m.sweep != 0; });
    if (!arcs && moves.size() + 1 == line.size()) return out; // the line itself
    const Chords all = chords(line.points.front().xy(), moves, grid);
    // The range of the line that a move replaces: from the point at or before its start to the one at or after its
    // end.
    const auto range = [&](std::uint32_t m) {
        const std::uint32_t end = m + 1 < begins.size() ? begins[m + 1] : line.size() - 2;
        return Tangle{begins[m], std::min(std::max(end, begins[m]), line.size() - 2)};
    };
    const geom::MarkedSegments near(all.segments, changed(line, moves, begins, all), kLeastMove,
                                    arcs ? 2 * kSagitta : 0);
    near.pairs([&](std::uint32_t i, std::uint32_t k) {
        const Move &m = moves[all.move[i]], &n = moves[all.move[k]];
        if (k == i + 1 && ((m.sweep == 0 && n.sweep == 0) || all.move[i] == all.move[k])) return;
        if (!cross(all.segments[i], m, all.segments[k], n)) return;
        const Tangle one = range(all.move[i]), other = range(all.move[k]);
        if (crossed_before(line, one, other)) return;
        out.push_back(one);
        out.push_back(other);
    });
    for (const geom::Segment& s : others)
        near.along(s.a, s.b, [&](std::uint32_t k) {
            const geom::Segment other{rounded(s.a, grid), rounded(s.b, grid)};
            if (!cross(all.segments[k], moves[all.move[k]], other, {})) return;
            if (const Tangle one = range(all.move[k]); !crossed_before(line, one, s)) out.push_back(one);
        });
    return out;
}

} // namespace filum::toolpath
