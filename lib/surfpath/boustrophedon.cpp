#include "surfpath/boustrophedon.hpp"

#include "curve/walk.hpp"
#include "surfpath/order.hpp"
#include "surfpath/turn.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surfpath {

namespace {

using curve::Chart;

// A turn laid on the surface, from one end of a row to that of another.
struct Laid {
    std::uint32_t from = 0, to = 0;         // ends of rows, as in Link
    double from_trim = 0, to_trim = 0;      // mm off the rows
    double radius = 0, cost = 0;
    Line line;
};

class Turner {
  public:
    Turner(const Surface& s, const Rows& rows, const Turning& o)
        : surface_(s), rows_(rows), o_(o), normals_(curve::vertex_normals(s)) {
        for (const Row& row : rows.rows) {
            ways_.push_back(curve::ways(row.line));
            reversed_.push_back(row.line);
            curve::reverse(reversed_.back());
            ways_reversed_.push_back(curve::ways(reversed_.back()));
        }
    }

    // All turns worth considering, by their ends.
    [[nodiscard]] std::vector<Laid> turns() const {
        std::vector<Laid> out;
        const auto n = static_cast<std::uint32_t>(2 * rows_.rows.size());
        for (std::uint32_t a = 0; a < n; ++a)
            for (std::uint32_t b = a + 1; b < n; ++b) {
                if (a / 2 == b / 2 || !near(a, b)) continue;
                if (auto t = lay(a, b); t.line.size() > 1) out.push_back(std::move(t));
            }
        return out;
    }

    [[nodiscard]] double length(std::uint32_t row) const { return ways_[row].back(); }

    // The row from the end `in` to its other end, with these lengths cut off.
    [[nodiscard]] Line stretch(std::uint32_t in, double off_begin, double off_end) const {
        const auto& w = in % 2 == 0 ? ways_[in / 2] : ways_reversed_[in / 2];
        return curve::part(in % 2 == 0 ? rows_.rows[in / 2].line : reversed_[in / 2], w, off_begin,
                           w.back() - off_end);
    }

  private:
    [[nodiscard]] const Port& port(std::uint32_t end) const {
        const Row& row = rows_.rows[end / 2];
        return end % 2 == 0 ? row.begin : row.end;
    }
    [[nodiscard]] const Line& inwards(std::uint32_t end) const {
        return end % 2 == 0 ? rows_.rows[end / 2].line : reversed_[end / 2];
    }
    [[nodiscard]] std::span<const double> ways_inwards(std::uint32_t end) const {
        return end % 2 == 0 ? ways_[end / 2] : ways_reversed_[end / 2];
    }
    [[nodiscard]] Vec3 tangent(std::uint32_t end) const { // inwards
        const Line& l = inwards(end);
        const auto w = ways_inwards(end);
        const Vec3 d = curve::at(l, w, std::min(w.back(), 0.5 * o_.spacing)).point - l[0];
        return 1 / std::max(1e-12, norm(d)) * d;
    }

    // Whether two ends lie as those of neighbouring rows do.
    [[nodiscard]] bool near(std::uint32_t a, std::uint32_t b) const {
        if (port(a).ring != port(b).ring) return false;
        const Vec3 u = tangent(a), v = tangent(b), d = inwards(b)[0] - inwards(a)[0];
        if (dot(u, v) < 0.5) return false;
        const Vec3 side = d - dot(d, u) * u;
        const double w = norm(side);
        return w > 0.3 * o_.spacing && w < std::max(3.2 * o_.least_radius, 2.4 * o_.spacing) &&
               norm(d) < 3 * w + o_.spacing;
    }

    [[nodiscard]] Line bound(const Port& a, const Port& b) const {
        const Line& ring = rows_.inset.rings[a.ring];
        const auto& ways = rows_.inset.ways[a.ring];
        const double all = ways.back(), there = ring.closed ? std::fmod(b.way - a.way + all, all) : b.way - a.way;
        if (there >= 0 && (!ring.closed || there <= all / 2)) return curve::part(ring, ways, a.way, a.way + there);
        const double back = ring.closed ? all - there : -there;
        Line out = curve::part(ring, ways, b.way, b.way + back);
        curve::reverse(out);
        return out;
    }

    [[nodiscard]] Laid lay(std::uint32_t a, std::uint32_t b) const {
        Laid out{a, b, 0, 0, 0, 0, {}};
        const Place pa = inwards(a).places[0], pb = inwards(b).places[0];
        const Vec3 sum = curve::normal_at(surface_, normals_, pa) + curve::normal_at(surface_, normals_, pb);
        if (!(norm(sum) > 0.5)) return out;
        const Chart flat = curve::chart(pa, 1 / norm(sum) * sum, pb.point - pa.point);
        const double c = norm(flat.to(pb.point)), reach = 6 * o_.least_radius + c;
        const auto flipped = [&](Vec2 p, bool flip) { return flip ? Vec2{p.x, -p.y} : p; };
        const bool flip = dot(tangent(a) + tangent(b), flat.y) > 0; // rows come from below
        const auto drawn = [&](const Line& l, double length) {
            std::vector<Vec2> points;
            double way = 0;
            for (std::size_t i = 0; i < l.size(); ++i) {
                if (i > 0) way += distance(l[i - 1], l[i]);
                points.push_back(flipped(flat.to(l[i]), flip));
                if (way > length) break;
            }
            return points;
        };
        const auto first = drawn(inwards(a), std::min(reach, length(a / 2) / 2));
        const auto second = drawn(inwards(b), std::min(reach, length(b / 2) / 2));
        const auto limit = drawn(bound(port(a), port(b)), 1e300);
        const FlatTurn t = turn({first, second, limit}, o_.least_radius);
        if (t.points.empty()) return out;
        // From the flat drawing back to the rows.
        const auto way_on = [&](const Line& l, std::span<const double> ways, std::span<const Vec2> flat_row, double way) {
            double done = 0;
            for (std::size_t i = 1; i < flat_row.size(); ++i) {
                const double step = geom::distance(flat_row[i - 1], flat_row[i]);
                if (done + step >= way) return ways[i - 1] + (step > 0 ? (way - done) / step : 0) * (ways[i] - ways[i - 1]);
                done += step;
            }
            return ways[std::min(flat_row.size(), l.size()) - 1];
        };
        out.from_trim = way_on(inwards(a), ways_inwards(a), first, t.from_first);
        out.to_trim = way_on(inwards(b), ways_inwards(b), second, t.from_second);
        if (out.from_trim > length(a / 2) / 2 || out.to_trim > length(b / 2) / 2) return out;
        std::vector<Vec2> points;
        for (const Vec2 p : t.points) points.push_back(flipped(p, flip));
        const Place begin = curve::at(inwards(a), ways_inwards(a), out.from_trim);
        const Place end = curve::at(inwards(b), ways_inwards(b), out.to_trim);
        points.front() = flat.to(begin.point), points.back() = flat.to(end.point);
        auto laid = curve::lay(surface_, flat, begin, points);
        if (!laid.whole || distance(laid.line.places.back().point, end.point) > 1e-6) return out;
        laid.line.places.back() = end;
        out.line = std::move(laid.line);
        out.radius = t.radius;
        out.cost = t.length - out.from_trim - out.to_trim + tightness(t.radius);
        return out;
    }

    [[nodiscard]] double tightness(double radius) const {
        const double part = radius / o_.least_radius;
        return part >= 0.999 ? 0 : part >= 0.75 ? 5 + 20 * (1 - part) : 60 + 20 * (1 - part);
    }

    const Surface& surface_;
    const Rows& rows_;
    Turning o_;
    std::vector<Vec3> normals_;
    std::vector<Line> reversed_;
    std::vector<std::vector<double>> ways_, ways_reversed_;
};

} // namespace

Plan boustrophedon(const Surface& s, const Rows& rows, const Turning& o) {
    const Turner turner(s, rows, o);
    const auto turns = turner.turns();
    std::vector<Link> links;
    for (const Laid& t : turns) links.push_back({t.from, t.to, t.cost});
    const auto chains = order(static_cast<std::uint32_t>(rows.rows.size()), links, 200);
    Plan out;
    double least = 1e300;
    std::size_t hairpins = 0, used = 0;
    for (const auto& chain : chains) {
        Stroke stroke;
        double off = 0;
        for (std::size_t i = 0; i < chain.size(); ++i) {
            const std::uint32_t in = 2 * chain[i].row + (chain[i].reversed ? 1 : 0), exit = in ^ 1u;
            const Laid* next = nullptr;
            bool forward = true;
            if (i + 1 < chain.size()) {
                const std::uint32_t to = 2 * chain[i + 1].row + (chain[i + 1].reversed ? 1 : 0);
                forward = exit < to;
                const auto key = std::minmax(exit, to);
                const auto it = std::lower_bound(turns.begin(), turns.end(), key, [](const Laid& t, const auto& k) {
                    return std::pair(t.from, t.to) < std::pair(k.first, k.second);
                });
                next = &*it;
            }
            const double end = !next ? 0 : forward ? next->from_trim : next->to_trim;
            stroke.pieces.push_back({turner.stretch(in, off, end), false});
            if (!next) break;
            Line l = next->line;
            if (!forward) curve::reverse(l);
            const bool hairpin = next->radius < 0.75 * o.least_radius;
            stroke.pieces.push_back({std::move(l), hairpin});
            least = std::min(least, next->radius);
            hairpins += hairpin, ++used;
            off = forward ? next->to_trim : next->from_trim;
        }
        out.strokes.push_back(std::move(stroke));
    }
    out.facts = {{"", "rows", static_cast<double>(rows.rows.size()), ""},
                 {"", "turns", static_cast<double>(used), ""},
                 {"", "hairpins", static_cast<double>(hairpins), ""}};
    if (used > 0) out.facts.push_back({"", "least-radius", least, "mm"});
    return out;
}

} // namespace filum::surfpath
