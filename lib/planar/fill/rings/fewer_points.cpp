#include "fill/rings/fewer_points.hpp"

#include "fill/rings/wall_lanes.hpp"
#include "toolpath/merge.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace filum::fill::rings {

namespace {

class BeadSimplifier {
  public:
    // `even`: whether to even out the turns.
    BeadSimplifier(const toolpath::Curve& bead, double tolerance, double least_void, bool even)
        : bead_(bead), n_(bead.points.size()), way_(n_), tolerance_(tolerance), least_(least_void), even_(even) {
        for (std::size_t i = 0; i < n_; ++i)
            way_[i] = geom::distance(bead_.points[(i > 0 ? i : n_) - 1], bead_.points[i]);
    }

    // The remaining points, moved such that beads side by side keep their distance on average.
    toolpath::Curve run() const {
        std::vector<std::size_t> kept;
        for (std::size_t a = 0; a < n_; a = farthest(a)) kept.push_back(a);
        if (kept.size() < 3) kept = {0, n_ / 3, 2 * n_ / 3}; // a closed bead keeps at least a triangle
        if (even_) even_out(kept);
        const std::size_t n = kept.size();
        std::vector<Chord> chords;
        chords.reserve(n);
        for (std::size_t k = 0; k < n; ++k) chords.push_back(chord(kept[k], k + 1 < n ? kept[k + 1] : n_));
        toolpath::Curve out{true, {}, {}};
        out.points.reserve(n);
        out.width.reserve(n);
        for (std::size_t k = 0; k <= n; ++k) {
            const Vertex at = vertex(kept, chords, k < n ? k : 0);
            add_tapered(at.point, at.width, least_, out);
        }
        out.drop_last(); // equal to the first one
        return out;
    }

  private:
    // The bead along a chord.
    struct Chord {
        double length = 0;   // mm, of the bead
        double straight = 0; // mm, of the chord
        Vec2 along;          // the chord's direction, unit
        double aside = 0;    // mm from the chord to the middle of the bead's strip, to the left
        double wider = 0;    // mm by which the bead is wider than the chord's ends, on average
    };
    struct Vertex {
        Vec2 point;
        double width;
    };

    // A point to which the chord from a can lead, although not to the next few points behind it (galloping search).
    [[nodiscard]] std::size_t farthest(std::size_t a) const {
        std::size_t step = 1;
        while (a + 2 * step <= n_ && within(a, a + 2 * step)) step *= 2;
        std::size_t lo = a + step, hi = std::min(a + 2 * step, n_ + 1); // hi is too far
        while (hi - lo > 1) {
            const std::size_t middle = lo + (hi - lo) / 2;
            (within(a, middle) ? lo : hi) = middle;
        }
        return lo;
    }
    // Whether the line from a to b stays in a strip along its chord at most twice the tolerance wide, with a width
    // near enough to that of the chord.
    [[nodiscard]] bool within(std::size_t a, std::size_t b) const {
        const std::size_t end = around(b);
        const Vec2 p = bead_.points[a], chord = bead_.points[end] - p;
        const double wa = bead_.width[a], wider_by = bead_.width[end] - wa;
        const double length2 = geom::norm2(chord), widest = 2 * tolerance_;
        if (!(length2 > 0)) return false;
        // How far point i is from the chord, positive on its left. `along`: its place along the chord. Both are
        // multiplied by the chord's length, so that no root is needed.
        const auto aside = [&](std::size_t i, double& along) {
            const Vec2 from = bead_.points[i] - p;
            along = dot(chord, from);
            const double off = cross(chord, from);
            if (along >= 0 && along <= length2) return off;
            along = std::clamp(along, 0.0, length2); // beyond the chord its end is nearest
            return std::copysign(std::sqrt(length2) * geom::norm(along > 0 ? from - chord : from), off);
        };
        double along = 0;
        const std::size_t middle = a + (b - a) / 2; // a quick test: lines too far off are usually too far off there
        if (b > a + 2 && square(aside(middle, along)) > square(widest) * length2) return false;
        const double strip2 = square(widest * toolpath::full_share(wa, length2)) * length2, by = 1 / length2;
        double laid_aside = 0, left = 0, right = 0; // mm2, and as of aside()
        for (std::size_t i = a + 1; i < b; ++i) {
            const double most = kMostOff * bead_.width[i], off = aside(i, along);
            left = std::max(left, off);
            right = std::min(right, off);
            if (square(left - right) > strip2 || square(off) > square(most) * length2) return false;
            const double wider = std::abs(bead_.width[i] - (wa + by * along * wider_by));
            laid_aside += wider * way_[i];
            if (wider > most || laid_aside > least_) return false;
        }
        return true;
    }

    // The number of the point that follows the one before i; the first one follows the last.
    [[nodiscard]] std::size_t around(std::size_t i) const { return i == n_ ? 0 : i; }

    static double square(double x) { return x * x; }

    // Measure of the turn at q, proportional to its square for small turns.
    static double bend(Vec2 p, Vec2 q, Vec2 r) {
        const Vec2 u = q - p, v = r - q;
        const double l = std::sqrt(geom::norm2(u) * geom::norm2(v));
        return l > 0 ? 1 - dot(u, v) / l : 0;
    }
    // Moves every point along the line between its neighbours as long as turns become more even and chords remain
    // within tolerance. A machine slows down for the sharpest turn. Ties: the point stays.
    void even_out(std::vector<std::size_t>& kept) const {
        const std::size_t n = kept.size();
        if (n < 5) return;
        const auto at = [&](std::size_t k) { return bead_.points[kept[k < n ? k : k - n]]; };
        std::array<double, 3> bends{0, bend(at(n - 1), at(0), at(1)), bend(at(0), at(1), at(2))}; // at k - 1, k, k + 1
        for (std::size_t k = 1; k + 1 < n; ++k) {
            const Vec2 h = at(k + n - 2), a = at(k - 1), c = at(k + 1), d = at(k + 2);
            bends = {bends[1], bends[2], bend(at(k), c, d)};
            double least = bends[0] + bends[1] + bends[2];
            const auto more_even = [&](std::size_t i) {
                const Vec2 b = bead_.points[i];
                const double before = bend(h, a, b);
                if (before >= least) return false;
                const double here = bend(a, b, c);
                if (before + here >= least) return false;
                const double after = bend(b, c, d), sum = before + here + after;
                if (sum >= least || !within(kept[k - 1], i) || !within(i, kept[k + 1])) return false;
                least = sum;
                bends = {before, here, after};
                return true;
            };
            for (const std::size_t step : {~std::size_t{0}, std::size_t{1}}) // backwards, then forwards
                for (std::size_t i = kept[k] + step; i != kept[k - 1] && i != kept[k + 1] && more_even(i); i += step)
                    kept[k] = i;
        }
    }

    [[nodiscard]] Chord chord(std::size_t a, std::size_t b) const {
        const std::size_t end = around(b);
        const Vec2 p = bead_.points[a], q = bead_.points[end];
        Chord out;
        double left = 0, right = 0, laid = 0;
        for (std::size_t i = a; i < b; ++i) {
            const std::size_t j = around(i + 1);
            const double l = way_[j];
            const double aside = cross(q - p, bead_.points[i] - p);
            left = std::max(left, aside);
            right = std::min(right, aside);
            laid += l * (bead_.width[i] + bead_.width[j]) / 2;
            out.length += l;
        }
        out.straight = geom::distance(p, q);
        if (out.straight > 0) {
            out.along = (1 / out.straight) * (q - p);
            out.aside = std::clamp((left + right) / 2 / out.straight, -tolerance_, tolerance_);
        }
        if (out.length > 0) out.wider = laid / out.length - (bead_.width[a] + bead_.width[end]) / 2;
        return out;
    }
    // The k-th remaining point, moved; its width is such that chords have the right width on average.
    [[nodiscard]] Vertex vertex(const std::vector<std::size_t>& kept, const std::vector<Chord>& chords,
                                std::size_t k) const {
        const Chord &a = chords[(k == 0 ? kept.size() : k) - 1], &b = chords[k];
        const double l = a.length + b.length, share = l > 0 ? a.length / l : 0.5; // long chords keep their width
        return {moved(kept[k], a, b), bead_.width[kept[k]] + std::lerp(b.wider, a.wider, share)};
    }
    // The point at i, where chord b follows chord a, moved so that both get their offsets aside: least squares weighted
    // by length, with a small regularisation so that almost parallel chords share the difference.
    [[nodiscard]] Vec2 moved(std::size_t i, const Chord& a, const Chord& b) const {
        constexpr double kSteady = 0.01;
        const Vec2 p = bead_.points[i];
        const double lu = a.straight, lv = b.straight, steady = kSteady * (lu + lv);
        if (lu == 0 || lv == 0) return p;
        const Vec2 n = geom::left_of(a.along), m = geom::left_of(b.along);
        const Vec2 r = (lu * a.aside) * n + (lv * b.aside) * m;
        const double xx = lu * n.x * n.x + lv * m.x * m.x + steady, yy = lu * n.y * n.y + lv * m.y * m.y + steady;
        const double xy = lu * n.x * n.y + lv * m.x * m.y;
        const Vec2 by = (1 / (xx * yy - xy * xy)) * Vec2{yy * r.x - xy * r.y, xx * r.y - xy * r.x};
        const double most = std::min(tolerance_, kMostOff * bead_.width[i]), by2 = geom::norm2(by);
        return p + (by2 > most * most ? most / std::sqrt(by2) : 1.0) * by;
    }
    const toolpath::Curve& bead_; // closed
    std::size_t n_;               // number of its points
    std::vector<double> way_;     // per point: mm from the point before
    double tolerance_, least_;
    bool even_;
};

} // namespace

void add_tapered(Vec2 p, double width, double least_void, toolpath::Curve& to) {
    if (!to.points.empty()) {
        const Vec2 from = to.points.back();
        const double wide = to.width.back(), change = std::abs(width - wide) / 16, length2 = geom::norm2(p - from);
        const bool small = change * change * length2 <= least_void * least_void; // one part, and no root
        const int parts = small ? 1 : static_cast<int>(std::ceil(std::sqrt(change * std::sqrt(length2) / least_void)));
        for (int k = 1; k < parts; ++k) {
            const double t = static_cast<double>(k) / parts;
            to.add(geom::lerp(from, p, t), std::lerp(wide, width, t));
        }
    }
    to.add(p, width);
}

toolpath::Curve with_fewer_points(const toolpath::Curve& bead, double tolerance, double least_void, bool even) {
    return BeadSimplifier(bead, tolerance, least_void, even).run();
}

} // namespace filum::fill::rings
