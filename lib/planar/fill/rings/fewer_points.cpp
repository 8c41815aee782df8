#include "fill/rings/fewer_points.hpp"

#include "fill/rings/wall_lanes.hpp"
#include "toolpath/merge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
        double length = 0; // mm
        double aside = 0;  // mm from the chord to the middle of the bead's strip, to the left
        double wider = 0;  // mm by which the bead is wider than the chord's ends, on average
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
        const double wa = bead_.width[a], wider_by = bead_.width[end] - wa, l2 = geom::norm2(chord);
        const double by_length2 = l2 > 0 ? 1 / l2 : 0, widest = 2 * tolerance_;
        const auto along = [&](std::size_t i) { // parameter of the chord's place nearest to point i
            return std::clamp(by_length2 * dot(bead_.points[i] - p, chord), 0.0, 1.0);
        };
        const auto off2 = [&](std::size_t i, double t) { return geom::norm2(p + t * chord - bead_.points[i]); };
        const std::size_t middle = a + (b - a) / 2; // a quick test: lines too far off are usually too far off there
        if (b > a + 2 && off2(middle, along(middle)) > widest * widest) return false;
        const double strip = widest * toolpath::full_share(wa, l2);
        double laid_aside = 0, left2 = 0, right2 = 0; // mm2
        for (std::size_t i = a + 1; i < b; ++i) {
            const double most = kMostOff * bead_.width[i], t = along(i), d2 = off2(i, t);
            const bool on_left = cross(chord, bead_.points[i] - p) > 0;
            left2 = std::max(left2, on_left ? d2 : 0.0);
            right2 = std::max(right2, on_left ? 0.0 : d2);
            if (d2 > most * most || wider_than(strip * strip, left2, right2)) return false;
            const double wider = std::abs(bead_.width[i] - (wa + t * wider_by));
            if (wider > most) return false;
            if (wider > 0) laid_aside += wider * way_[i];
            if (laid_aside > least_) return false;
        }
        return true;
    }

    // Whether the sum of two widths is more than that of a strip; all given by their squares.
    static bool wider_than(double strip2, double left2, double right2) {
        constexpr double kTwice = 2 * (1 + 1e-9); // most lines lie well inside, which shows without a root
        const double sum = left2 + right2;
        return kTwice * sum > strip2 && sum + 2 * std::sqrt(left2 * right2) > strip2;
    }
    // The number of the point that follows the one before i; the first one follows the last.
    [[nodiscard]] std::size_t around(std::size_t i) const { return i == n_ ? 0 : i; }

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
        for (std::size_t k = 1; k + 1 < n; ++k) {
            const Vec2 h = at(k + n - 2), a = at(k - 1), c = at(k + 1), d = at(k + 2);
            const auto bends = [&](Vec2 b, double most) { // the sum, or a partial sum that already reaches `most`
                const double before = bend(h, a, b);
                return before >= most ? before : before + bend(a, b, c) + bend(b, c, d);
            };
            double least = bends(at(k), std::numeric_limits<double>::infinity());
            for (const std::size_t step : {~std::size_t{0}, std::size_t{1}}) // backwards, then forwards
                for (std::size_t i = kept[k] + step; i != kept[k - 1] && i != kept[k + 1]; i += step) {
                    const double now = bends(bead_.points[i], least);
                    if (now >= least || !within(kept[k - 1], i) || !within(i, kept[k + 1])) break;
                    least = now;
                    kept[k] = i;
                }
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
        const double l = geom::distance(p, q);
        if (l > 0) out.aside = std::clamp((left + right) / 2 / l, -tolerance_, tolerance_);
        if (out.length > 0) out.wider = laid / out.length - (bead_.width[a] + bead_.width[end]) / 2;
        return out;
    }
    // The k-th remaining point, moved; its width is such that chords have the right width on average.
    [[nodiscard]] Vertex vertex(const std::vector<std::size_t>& kept, const std::vector<Chord>& chords,
                                std::size_t k) const {
        const std::size_t n = kept.size(), before = (k == 0 ? n : k) - 1, after = k + 1 == n ? 0 : k + 1;
        const Chord &a = chords[before], &b = chords[k];
        const double l = a.length + b.length, share = l > 0 ? a.length / l : 0.5; // long chords keep their width
        return {moved(kept[before], kept[k], kept[after], a.aside, b.aside),
                bead_.width[kept[k]] + std::lerp(b.wider, a.wider, share)};
    }
    // The point at i between the chords from h and to j, moved so that both get their offsets aside: least squares
    // weighted by length, with a small regularisation so that almost parallel chords share the difference.
    [[nodiscard]] Vec2 moved(std::size_t h, std::size_t i, std::size_t j, double before, double after) const {
        constexpr double kSteady = 0.01;
        const Vec2 p = bead_.points[i], u = p - bead_.points[h], v = bead_.points[j] - p;
        const double lu = geom::norm(u), lv = geom::norm(v), steady = kSteady * (lu + lv);
        if (lu == 0 || lv == 0) return p;
        const Vec2 n = (1 / lu) * geom::left_of(u), m = (1 / lv) * geom::left_of(v);
        const Vec2 r = (lu * before) * n + (lv * after) * m;
        const double xx = lu * n.x * n.x + lv * m.x * m.x + steady, yy = lu * n.y * n.y + lv * m.y * m.y + steady;
        const double xy = lu * n.x * n.y + lv * m.x * m.y;
        const Vec2 by = (1 / (xx * yy - xy * xy)) * Vec2{yy * r.x - xy * r.y, xx * r.y - xy * r.x};
        const double most = std::min(tolerance_, kMostOff * bead_.width[i]);
        return p + std::min(1.0, most / std::max(most, geom::norm(by))) * by;
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
        const double wide = to.width.back(), area = std::abs(width - wide) * geom::distance(from, p) / 16;
        const int parts = area > least_void ? static_cast<int>(std::ceil(std::sqrt(area / least_void))) : 1;
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
