#include "surfpath/rows/surface_turn.hpp"

#include "surface/curve/ease.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/rows/flat_turn.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surfpath::rows {

using surface::curve::Chart;

namespace {

// Least radii: radius of turns, so that their arcs, with points at every degree, keep the least radius on triangles.
constexpr double kWider = 1.07;
constexpr double kHairpinBelow = 0.75;            // least radii: a tighter turn costs as much as a hairpin
constexpr double kBulbCosts = 2 * kTightCosts;    // mm: cost of a bulb, for the voids beside it
constexpr double kHairpinCosts = 3 * kTightCosts; // mm: cost of a hairpin
// Spacings: ends that are up to this far apart may always turn. Tuned: 2, at which lines are neighbours, covers .007
// less with hairpins of ortheo, and overlaps .007 less.
constexpr double kNextButOne = 2.5;
constexpr double kWidest = 1.6; // widest turn, in turns of the least radius

// The first `length` mm of a line on a chart; `flip` mirrors it upside down.
std::vector<Vec2> drawn(const Chart& chart, const Line& line, double length, bool flip) {
    std::vector<Vec2> out;
    double way = 0;
    for (std::size_t i = 0; i < line.size() && way <= length; ++i) {
        const Vec2 p = chart.to(line[i]);
        out.push_back(flip ? Vec2{p.x, -p.y} : p);
        if (i + 1 < line.size()) way += distance(line[i], line[i + 1]);
    }
    return out;
}

// Arc length on a line of the point that is at arc length `way` of its drawing.
double undrawn(std::span<const double> ways, std::span<const Vec2> drawing, double way) {
    double done = 0;
    for (std::size_t i = 1; i < drawing.size(); ++i) {
        const double step = geom::distance(drawing[i - 1], drawing[i]);
        if (done + step >= way) return ways[i - 1] + (step > 0 ? (way - done) / step : 0) * (ways[i] - ways[i - 1]);
        done += step;
    }
    return ways[drawing.size() - 1];
}

} // namespace

void reverse(SurfaceTurn& t) {
    surface::curve::reverse(t.line);
    std::swap(t.from, t.to);
    std::swap(t.from_trim, t.to_trim);
}

Turner::Turner(const Surface& s, const Rows& rows, const Transits& transits, const TurnOptions& o)
    : surface_(s), rows_(rows), transits_(transits), o_(o), normals_(surface::curve::vertex_normals(s)) {
    for (const Row& row : rows.rows) {
        ways_.push_back(surface::curve::arc_lengths(row.line));
        reversed_.push_back(row.line);
        surface::curve::reverse(reversed_.back());
        ways_reversed_.push_back(surface::curve::arc_lengths(reversed_.back()));
    }
}

std::vector<SurfaceTurn> Turner::candidates() const {
    std::vector<SurfaceTurn> out;
    const auto n = static_cast<std::uint32_t>(2 * rows_.rows.size());
    for (std::uint32_t a = 0; a < n; ++a)
        for (std::uint32_t b = a + 1; b < n; ++b) {
            if (a / 2 == b / 2) continue;
            const bool one = same_line(a, b);
            if (!one && may_turn(a, b))
                if (auto t = turn_between(a, b, 0); t.line.size() > 1) {
                    out.push_back(std::move(t));
                    continue;
                }
            if (!one && !leads_on(a, b)) continue;
            const double l = surface::curve::length(transits_.along(a, b));
            const double most = one ? o_.along : std::min(o_.along, 2 * o_.least_radius); // as far as a turn leads
            if (l > 0 && l <= most) out.push_back({a, b, 0, 0, 0, l, {}, false});
        }
    return out;
}

std::vector<SurfaceTurn> Turner::deeper(const SurfaceTurn& outermost, double apart) const {
    std::vector<SurfaceTurn> out{outermost};
    const bool swapped = outermost.from > outermost.to;
    const auto [a, b] = std::minmax(outermost.from, outermost.to);
    const double deepest = rules::kTurnReach * std::max(o_.least_radius, o_.spacing);
    const double least = least_deeper(outermost.radius);
    for (double behind = apart; behind < deepest; behind += apart) {
        SurfaceTurn t = turn_between(a, b, behind);
        if (t.line.size() < 2) break; // the rows are too short for a deeper turn
        if (t.radius < least) continue;
        if (swapped) reverse(t);
        out.push_back(std::move(t));
    }
    return out;
}

Line Turner::stretch(std::uint32_t in, double off_begin, double off_end) const {
    const auto w = ways_inwards(in);
    return surface::curve::part(inwards(in), w, off_begin, w.back() - off_end);
}

Line Turner::part(std::uint32_t in, double from, double to) const {
    return surface::curve::part(inwards(in), ways_inwards(in), from, to);
}

SurfaceTurn Turner::eased(std::uint32_t from, const std::vector<Line>& stretches, std::uint32_t to) const {
    const double radius = o_.tight ? o_.spacing / 2 : o_.least_radius, most = rules::kTurnReach * radius;
    SurfaceTurn out{from, to, std::min(most, length(from / 2) / 2), std::min(most, length(to / 2) / 2), 0, 0, {}, true};
    Line line = surface::curve::part(inwards(from), ways_inwards(from), 0, out.from_trim);
    surface::curve::reverse(line);
    for (const Line& l : stretches) surface::curve::append(line, l);
    surface::curve::append(line, surface::curve::part(inwards(to), ways_inwards(to), 0, out.to_trim));
    line = surface::curve::threaded(surface_, line);
    auto eased = surface::curve::ease(surface_, line,
                                      {.radius = rules::kRounded * radius, .corridor = rules::kTurnReach * radius});
    // Around a convex corner, as of a hole, rounding comes too near to the rim; then the tight line is better.
    const bool inside = std::all_of(eased.line.places.begin(), eased.line.places.end(), [&](const Place& p) {
        return rows_.inset.room(surface_, p) >= rows_.inset.margin - rules::kGive * o_.spacing;
    });
    out.line = inside ? std::move(eased.line) : std::move(line);
    return out;
}

const RingPlace& Turner::ring_place(std::uint32_t end) const {
    const Row& row = rows_.rows[end / 2];
    return end % 2 == 0 ? row.begin : row.end;
}

const Line& Turner::inwards(std::uint32_t end) const {
    return end % 2 == 0 ? rows_.rows[end / 2].line : reversed_[end / 2];
}

std::span<const double> Turner::ways_inwards(std::uint32_t end) const {
    return end % 2 == 0 ? ways_[end / 2] : ways_reversed_[end / 2];
}

// Unit tangent of a row at its end, inwards.
Vec3 Turner::tangent(std::uint32_t end) const {
    const Line& l = inwards(end);
    const auto w = ways_inwards(end);
    const Vec3 d = surface::curve::at(l, w, std::min(w.back(), 0.5 * o_.spacing)).point - l[0];
    return 1 / std::max(1e-12, norm(d)) * d;
}

// Whether a turn between the two ends is worth considering.
bool Turner::may_turn(std::uint32_t a, std::uint32_t b) const {
    if (ring_place(a).ring != ring_place(b).ring || ring_place(a).ring == surface::kNone) return false;
    const double spacing = o_.spacing, two = 2 * o_.least_radius, most = std::max(kWidest * two, kNextButOne * spacing);
    const Vec3 d = inwards(b)[0] - inwards(a)[0], u = tangent(a);
    const double w = norm(d - dot(d, u) * u); // across the rows
    // Of ends too near for an arc only the nearest are considered, for hairpins and bulbs.
    if (!(dot(u, tangent(b)) > 0) || norm(d) > w / rules::kAlong + spacing) return false;
    return w < most && (w <= kNextButOne * spacing || w >= kHairpinBelow * two);
}

// Whether one line ends at a hole in `a` and continues behind it in `b`.
bool Turner::same_line(std::uint32_t a, std::uint32_t b) const {
    if (a / 2 == b / 2 || rows_.rows[a / 2].level != rows_.rows[b / 2].level) return false;
    if (ring_place(a).ring != ring_place(b).ring || ring_place(a).ring == surface::kNone) return false;
    const Vec3 u = tangent(a), v = tangent(b), d = inwards(b)[0] - inwards(a)[0];
    return dot(u, v) < 0 && dot(u, d) < 0 && dot(v, d) > 0;
}

// Of hybrid: whether the way along the rim between the ends passes no other end.
bool Turner::leads_on(std::uint32_t a, std::uint32_t b) const { return o_.tight && transits_.next_to(a, b); }

SurfaceTurn Turner::turn_between(std::uint32_t a, std::uint32_t b, double behind, bool bulbs) const {
    SurfaceTurn out{a, b, 0, 0, 0, 0, {}, false};
    const Place pa = inwards(a).places[0], pb = inwards(b).places[0];
    const Vec3 sum =
        surface::curve::normal_at(surface_, normals_, pa) + surface::curve::normal_at(surface_, normals_, pb);
    if (!(norm(sum) > 0.5)) return out;
    const Chart flat = surface::curve::chart(pa, 1 / norm(sum) * sum, pb.point - pa.point);
    const double reach = 6 * o_.least_radius + norm(flat.to(pb.point));
    const bool flip = dot(tangent(a) + tangent(b), flat.y) > 0; // rows must come from below
    const auto first = drawn(flat, inwards(a), std::min(reach, length(a / 2) / 2), flip);
    const auto second = drawn(flat, inwards(b), std::min(reach, length(b / 2) / 2), flip);
    const auto bound = drawn(flat, transits_.along(a, b), 1e300, flip);
    const FlatTurn t = turn({first, second, bound, behind}, kWider * o_.least_radius, bulbs && !o_.tight);
    if (t.points.empty()) return out;
    out.from_trim = undrawn(ways_inwards(a), first, t.from_first);
    out.to_trim = undrawn(ways_inwards(b), second, t.from_second);
    if (out.from_trim > length(a / 2) / 2 || out.to_trim > length(b / 2) / 2) return out;
    std::vector<Vec2> points = t.points;
    if (flip)
        for (Vec2& p : points) p.y = -p.y;
    const Place begin = surface::curve::at(inwards(a), ways_inwards(a), out.from_trim);
    const Place end = surface::curve::at(inwards(b), ways_inwards(b), out.to_trim);
    points.front() = flat.to(begin.point);
    points.back() = flat.to(end.point);
    auto laid = surface::curve::from_chart(surface_, flat, begin, points);
    if (!laid.whole || distance(laid.line.places.back().point, end.point) > rules::kSamePoint)
        return t.bulb ? turn_between(a, b, behind, false) : out;
    laid.line.places.back() = end;
    for (const Place& p : laid.line.places)
        if (rows_.inset.room(surface_, p) < rows_.inset.margin - rules::kGive * o_.spacing)
            return t.bulb ? turn_between(a, b, behind, false) : out;
    out.line = std::move(laid.line);
    out.radius = t.radius;
    out.cost = t.length - out.from_trim - out.to_trim + (t.bulb ? kBulbCosts : tightness(t.radius));
    return out;
}

// Least radius of a turn behind one of `radius`, mm. Wide turns stay wide. The radius of a hairpin is half the distance
// of its rows, which changes along them by as much as lines may be moved.
double Turner::least_deeper(double radius) const {
    const bool wide = radius >= o_.least_radius && o_.least_radius > o_.spacing / 2;
    return wide ? o_.least_radius - rules::kSamePoint : (1 - rules::kGive) * std::min(radius, o_.least_radius);
}

// Cost of a tight turn, mm.
double Turner::tightness(double radius) const {
    const double part = radius / o_.least_radius;
    return o_.tight || part >= 0.999 ? 0
                                     : (part < kHairpinBelow ? kHairpinCosts : kTightCosts) + kTightCosts * (1 - part);
}

} // namespace filum::surfpath::rows
