#include "rings/fewer_points.hpp"

#include "toolpath/merge.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace filum::rings {

namespace {

// Of what an evenly bent line is off its chord, two thirds are on one side of a chord that is moved to the mean.
constexpr double kBalanced = 1.5;
constexpr int kSweeps = 2; // to even the turns out; more change less than a hundredth of them

// A closed bead.
struct Bead {
    std::span<const Vec2> points;
    std::span<const double> width;

    [[nodiscard]] std::size_t size() const { return points.size(); }
};

class Thinning {
  public:
    // `even`: turns are to be even.
    Thinning(Bead bead, double tolerance, double least_void, bool even)
        : bead_(bead), way_(bead.size()), off_(kBalanced * tolerance), least_(least_void), even_(even) {
        for (std::size_t i = 0; i < bead_.size(); ++i)
            way_[i] = geom::distance(bead_.points[(i > 0 ? i : bead_.size()) - 1], bead_.points[i]);
    }

    // Adds the points that stay, moved such that beads side by side stay so on average.
    void run(std::vector<Vec2>& points, std::vector<double>& width) const {
        std::vector<std::size_t> kept;
        for (std::size_t a = 0; a < bead_.size(); a = farthest(a)) kept.push_back(a);
        if (kept.size() < 3) kept = {0, bead_.size() / 3, 2 * bead_.size() / 3}; // no line there and back
        if (even_ && kept.size() > 4) even_out(kept);
        const std::size_t n = kept.size();
        std::vector<Chord> chords;
        for (std::size_t k = 0; k < n; ++k) chords.push_back(chord(kept[k], k + 1 < n ? kept[k + 1] : bead_.size()));
        std::vector<Vec2> moved;
        std::vector<double> wide;
        for (std::size_t k = 0; k < n; ++k) {
            const Chord &before = chords[(k + n - 1) % n], &after = chords[k];
            const double l = before.length + after.length, share = l > 0 ? before.length / l : 0.5; // long ones stay
            moved.push_back(vertex(kept[(k + n - 1) % n], kept[k], kept[(k + 1) % n], before.aside, after.aside));
            wide.push_back(bead_.width[kept[k]] + std::lerp(after.wider, before.wider, share));
        }
        for (std::size_t k = 0; k < n; ++k) {
            points.push_back(moved[k]);
            width.push_back(wide[k]);
            divide(moved[k], moved[(k + 1) % n], wide[k], wide[(k + 1) % n], points, width);
        }
    }

  private:
    // What the bead is beside a chord: means.
    struct Chord {
        double length = 0; // mm
        double aside = 0;  // mm, to the left
        double wider = 0;  // mm
    };

    // A point that the chord from a may run to; beyond it there is none near by.
    [[nodiscard]] std::size_t farthest(std::size_t a) const {
        std::size_t step = 1;
        while (a + 2 * step <= bead_.size() && within(a, a + 2 * step)) step *= 2;
        std::size_t lo = a + step, hi = std::min(a + 2 * step, bead_.size() + 1); // hi is too far
        while (hi - lo > 1) {
            const std::size_t middle = lo + (hi - lo) / 2;
            (within(a, middle) ? lo : hi) = middle;
        }
        return lo;
    }
    // Whether the chord from a to b is near enough to the line between, and its width to the bead's.
    [[nodiscard]] bool within(std::size_t a, std::size_t b) const {
        const Vec2 p = bead_.points[a], chord = bead_.points[b % bead_.size()] - p;
        const double wa = bead_.width[a], wider_by = bead_.width[b % bead_.size()] - wa, l2 = geom::norm2(chord);
        const double by_length2 = l2 > 0 ? 1 / l2 : 0;
        const auto along = [&](std::size_t i) { // the share of the chord at which it is the nearest to point i
            return std::clamp(by_length2 * dot(bead_.points[i] - p, chord), 0.0, 1.0);
        };
        const auto off2 = [&](std::size_t i, double t) { return geom::norm2(p + t * chord - bead_.points[i]); };
        const std::size_t middle = a + (b - a) / 2; // most that are too far are so there
        if (b > a + 2 && off2(middle, along(middle)) > off_ * off_) return false;
        const double full = off_ * toolpath::full_share(wa, l2);
        double laid_aside = 0; // mm2
        for (std::size_t i = a + 1; i < b; ++i) {
            const double eighth = bead_.width[i] / 8, off = std::min(full, eighth);
            const double t = along(i);
            if (off2(i, t) > off * off) return false;
            const double wider = std::abs(bead_.width[i] - (wa + t * wider_by));
            if (wider > eighth) return false;
            if (wider > 0) laid_aside += wider * way_[i];
            if (laid_aside > least_) return false;
        }
        return true;
    }

    // Grows with the square of the turn at q.
    static double bend(Vec2 p, Vec2 q, Vec2 r) {
        const Vec2 u = q - p, v = r - q;
        const double l = std::sqrt(geom::norm2(u) * geom::norm2(v));
        return l > 0 ? 1 - dot(u, v) / l : 0;
    }
    // Moves every point between its neighbours as long as that makes the turns more even, as chords may run: a machine
    // slows down for the sharpest.  Ties: as it was.
    void even_out(std::vector<std::size_t>& kept) const {
        const std::size_t n = kept.size();
        const auto at = [&](std::size_t k) { return bead_.points[kept[k % n]]; };
        std::vector<double> bends(n);
        for (std::size_t k = 0; k < n; ++k) bends[k] = bend(at(k + n - 1), at(k), at(k + 1));
        std::vector<char> looked(n, 0); // at it since anything changed that decides where it goes
        for (int sweep = 0; sweep < kSweeps; ++sweep)
            for (std::size_t k = 1; k + 1 < n; ++k) {
                if (looked[k]) continue;
                if (move(kept, k, at(k + n - 2), at(k + 2), bends))
                    for (std::size_t j = k + n - 2; j <= k + n + 2; ++j) looked[j % n] = 0;
                looked[k] = 1;
            }
    }
    // Point k, between neighbours with h before them and d behind.  True if it moves.
    bool move(std::vector<std::size_t>& kept, std::size_t k, Vec2 h, Vec2 d, std::vector<double>& bends) const {
        constexpr double kLess = 1 - 1e-9; // for rounding
        const Vec2 a = bead_.points[kept[k - 1]], c = bead_.points[kept[k + 1]];
        const std::size_t from = kept[k];
        double least = kLess * (bends[k - 1] + bends[k] + bends[k + 1]);
        for (const std::size_t step : {~std::size_t{0}, std::size_t{1}}) // back, then on
            for (std::size_t i = kept[k] + step; i != kept[k - 1] && i != kept[k + 1]; i += step) {
                const Vec2 b = bead_.points[i];
                const double before = bend(h, a, b);
                if (before >= least) break;
                const double here = bend(a, b, c), behind = bend(b, c, d), now = before + here + behind;
                if (now >= least || !within(kept[k - 1], i) || !within(i, kept[k + 1])) break;
                least = kLess * now;
                kept[k] = i;
                bends[k - 1] = before;
                bends[k] = here;
                bends[k + 1] = behind;
            }
        return kept[k] != from;
    }

    [[nodiscard]] Chord chord(std::size_t a, std::size_t b) const {
        const Vec2 p = bead_.points[a], q = bead_.points[b % bead_.size()];
        Chord out;
        double area = 0, laid = 0;
        for (std::size_t i = a; i < b; ++i) {
            const std::size_t j = (i + 1) % bead_.size();
            const double l = way_[j];
            area += cross(bead_.points[i] - p, bead_.points[j] - p);
            laid += l * (bead_.width[i] + bead_.width[j]) / 2;
            out.length += l;
        }
        const double l = geom::distance(p, q);
        if (l > 0) out.aside = std::clamp(-area / 2 / l, -off_, off_);
        if (out.length > 0) out.wider = laid / out.length - (bead_.width[a] + bead_.width[b % bead_.size()]) / 2;
        return out;
    }
    // The point at i, between chords from h and to j, moved to where both are as far aside as they are to be: by least
    // squares, the longer counts for more, and so steadied that chords that hardly bend share what they differ by.
    [[nodiscard]] Vec2 vertex(std::size_t h, std::size_t i, std::size_t j, double before, double after) const {
        constexpr double kSteady = 0.01;
        const Vec2 p = bead_.points[i], u = p - bead_.points[h], v = bead_.points[j] - p;
        const double lu = geom::norm(u), lv = geom::norm(v), steady = kSteady * (lu + lv);
        if (lu == 0 || lv == 0) return p;
        const Vec2 n = (1 / lu) * geom::left_of(u), m = (1 / lv) * geom::left_of(v);
        const Vec2 r = (lu * before) * n + (lv * after) * m;
        const double xx = lu * n.x * n.x + lv * m.x * m.x + steady, yy = lu * n.y * n.y + lv * m.y * m.y + steady;
        const double xy = lu * n.x * n.y + lv * m.x * m.y;
        const Vec2 by = (1 / (xx * yy - xy * xy)) * Vec2{yy * r.x - xy * r.y, xx * r.y - xy * r.x};
        const double most = std::min(off_, bead_.width[i] / 8);
        return p + std::min(1.0, most / std::max(most, geom::norm(by))) * by;
    }
    // Points between a and b where a machine that lays the whole way with one width would lay more than `least_` aside.
    void divide(Vec2 a, Vec2 b, double wa, double wb, std::vector<Vec2>& points, std::vector<double>& width) const {
        const int parts = static_cast<int>(std::ceil(std::sqrt(std::abs(wb - wa) * geom::distance(a, b) / 8 / least_)));
        for (int k = 1; k < parts; ++k) {
            const double t = static_cast<double>(k) / parts;
            points.push_back(geom::lerp(a, b, t));
            width.push_back(std::lerp(wa, wb, t));
        }
    }

    Bead bead_;
    std::vector<double> way_; // per point: mm from the one before it
    double off_, least_;
    bool even_;
};

} // namespace

toolpath::Curve with_fewer_points(const toolpath::Curve& bead, double tolerance, double least_void) {
    toolpath::Curve out{bead.closed, {}, {}};
    Thinning({bead.points, bead.width}, tolerance, least_void, true).run(out.points, out.width);
    return out;
}

Rings with_fewer_points(const Rings& all, double tolerance, double least_void) {
    Rings out;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::size_t first = all.start[i], n = all.start[i + 1] - first;
        Thinning({{all.points.data() + first, n}, {all.width.data() + first, n}}, tolerance, least_void, false)
            .run(out.points, out.width);
        out.start.push_back(static_cast<std::uint32_t>(out.points.size()));
        out.lane.push_back(all.lane[i]);
    }
    return out;
}

} // namespace filum::rings
