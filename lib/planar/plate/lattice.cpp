#include "plate/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::plate {

namespace {

// All vectors by which a copy of the outline can be moved such that both overlap: the sum of the outline and of the
// outline turned by half a turn. It is convex and symmetric about (0, 0). Its edges are those of both, sorted by
// direction.
std::vector<Vec2> overlapping_moves(std::span<const Vec2> outline) {
    std::vector<Vec2> edges;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 e = outline[(i + 1) % outline.size()] - outline[i];
        edges.push_back(e);
        edges.push_back(-1.0 * e);
    }
    std::stable_sort(edges.begin(), edges.end(),
                     [](Vec2 a, Vec2 b) { return std::atan2(a.y, a.x) < std::atan2(b.y, b.x); });
    std::vector<Vec2> out;
    geom::Box2 box;
    Vec2 at;
    for (const Vec2& e : edges) {
        box.add(at);
        out.push_back(at);
        at = at + e;
    }
    for (Vec2& p : out) p = p - 0.5 * (box.lo + box.hi);
    return out;
}

// Where the line y = h meets a convex area.
struct Chord {
    double from = 0, to = 0;
    [[nodiscard]] double length() const { return to - from; }
};

Chord chord(std::span<const Vec2> area, double h) {
    double from = std::numeric_limits<double>::infinity(), to = -from;
    for (std::size_t i = 0; i < area.size(); ++i) {
        const Vec2 a = area[i], b = area[(i + 1) % area.size()];
        if (a.y != h && (a.y < h) == (b.y < h)) continue;
        const double x = a.y == h ? a.x : a.x + (b.x - a.x) * (h - a.y) / (b.y - a.y);
        from = std::min(from, x);
        to = std::max(to, x);
    }
    return {from, to};
}

// Copies are `apart` from each other in a row. The next row is `up` above, moved to the right by `shift`.
struct Lattice {
    double apart = 0, up = 0, shift = 0;
};

// A copy of the next row fits between two neighbours of a row if the chord of the overlapping moves at its height is
// no longer than their distance. Chords get shorter with the height, so a bisection finds the least height. Rows two
// apart do not meet there: the length of chords is concave, so at half the height of the overlapping moves a chord is
// at least half as long as the longest one, which is the distance of neighbours.
Lattice lattice_of(std::span<const Vec2> moves) {
    constexpr int kHalvings = 60; // to the precision of double
    double lo = 0, hi = 0;
    for (const Vec2& p : moves) hi = std::max(hi, p.y);
    Lattice out{chord(moves, 0).to, hi, 0};
    if (chord(moves, hi).length() > out.apart) return out; // tiles
    for (int k = 0; k < kHalvings; ++k) {
        const double middle = (lo + hi) / 2;
        (chord(moves, middle).length() > out.apart ? lo : hi) = middle;
    }
    out.up = hi;
    out.shift = std::fmod(chord(moves, hi).to, out.apart);
    if (out.shift < 0) out.shift += out.apart;
    return out;
}

// Rows of copies. Coordinates are those of moves.
class Rows {
  public:
    Rows(const Lattice& lattice, Vec2 room) : lattice_(lattice), room_(room) {}

    // How many copies row `row` can hold, at most `columns`.
    [[nodiscard]] std::size_t holds(std::size_t row, std::size_t columns) const {
        const double left = room_.x - shift(row);
        if (!(left >= 0) || !(lattice_.up * static_cast<double>(row) <= room_.y)) return 0;
        return static_cast<std::size_t>(std::min(std::floor(left / lattice_.apart) + 1, static_cast<double>(columns)));
    }
    [[nodiscard]] Vec2 place(std::size_t column, std::size_t row) const {
        return {shift(row) + lattice_.apart * static_cast<double>(column), lattice_.up * static_cast<double>(row)};
    }
    // The last moves along x and along y if `count` copies are placed, `columns` in a row; nothing if they do not fit.
    // `placed`: how many do.
    [[nodiscard]] std::optional<Vec2> extent(std::size_t count, std::size_t columns, std::size_t& placed) const {
        Vec2 out;
        placed = 0;
        for (std::size_t row = 0; placed < count; ++row) {
            const std::size_t here = std::min(holds(row, columns), count - placed);
            if (here == 0) return std::nullopt;
            placed += here;
            const Vec2 last = place(here - 1, row);
            out = {std::max(out.x, last.x), last.y};
        }
        return out;
    }

  private:
    [[nodiscard]] double shift(std::size_t row) const {
        return std::fmod(lattice_.shift * static_cast<double>(row), lattice_.apart);
    }
    Lattice lattice_;
    Vec2 room_;
};

Vec2 swapped(Vec2 p) { return {p.y, p.x}; }

} // namespace

std::optional<std::vector<Vec2>> lattice(std::span<const Vec2> outline, std::size_t count, Vec2 size,
                                         std::size_t& most) {
    std::optional<std::vector<Vec2>> out;
    double least = std::numeric_limits<double>::infinity(); // mm, half perimeter of the pile
    most = 0;
    for (const bool upright : {false, true}) {
        std::vector<Vec2> turned(outline.begin(), outline.end());
        if (upright) std::transform(turned.begin(), turned.end(), turned.begin(), swapped);
        geom::Box2 box;
        for (const Vec2& p : turned) box.add(p);
        const Vec2 own = box.hi - box.lo, room = (upright ? swapped(size) : size) - own;
        const Rows rows(lattice_of(overlapping_moves(turned)), room);
        std::size_t best = 0, placed = 0;
        for (std::size_t columns = 1; columns <= std::max<std::size_t>(1, rows.holds(0, count)); ++columns) {
            const auto extent = rows.extent(count, columns, placed);
            most = std::max(most, placed);
            const double perimeter = extent ? extent->x + own.x + extent->y + own.y : least;
            if (perimeter >= least) continue;
            least = perimeter;
            best = columns;
        }
        if (best == 0) continue;
        out.emplace();
        for (std::size_t row = 0; out->size() < count; ++row)
            for (std::size_t k = 0, n = rows.holds(row, best); k < n && out->size() < count; ++k)
                out->push_back(upright ? swapped(rows.place(k, row)) : rows.place(k, row));
    }
    return out;
}

} // namespace filum::plate
