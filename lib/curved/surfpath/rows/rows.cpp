#include "surfpath/rows/rows.hpp"

#include "geodesic/isolines.hpp"
#include "geodesic/query.hpp"
#include "surface/curve/ease.hpp"
#include "surface/curve/nearest.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace filum::surfpath::rows {

namespace {

using surface::kNone;

// Least distance from rims, in halves of a spacing, at which a line continues along the inset; such lines come no
// nearer to the next line than 0.7 spacings. With beads along the rims, the distance from the innermost of them counts.
// Tuned: halving it gains 0.001 coverage and costs 0.004 overlap.
constexpr double kFollowing = 0.4;

// mm from the rims where rows end.
double depth(const RowLimits& limits) {
    if (limits.rim_beads == 0) return limits.margin;
    return limits.rim_beads * limits.rim_bead + (1 - 2 * rules::kOnRimBead) * limits.margin;
}

// Clips lines where they are nearer to a rim than the margin.
class InsetClipper {
  public:
    InsetClipper(const Surface& s, const RowLimits& limits)
        : surface_(s), half_(limits.margin), margin_(depth(limits)), give_(limits.give) {
        inset_.margin = margin_;
        inset_.half = half_;
        if (s.rims.empty()) return;
        inset_.field = geodesic::exact(s, surface::rim_sources(s), margin_ + 2 * longest_edge(s));
        inset_.rings = at_distance(margin_);
        for (const Line& ring : inset_.rings) inset_.ways.push_back(surface::curve::arc_lengths(ring));
    }

    [[nodiscard]] Inset& inset() { return inset_; }
    [[nodiscard]] const Inset& inset() const { return inset_; }

    // The lines at a distance from the rims, mm.
    [[nodiscard]] std::vector<Line> at_distance(double far) const {
        const double level[] = {far};
        std::vector<Line> out;
        for (const auto& isoline : geodesic::isolines(surface_, inset_.field, level))
            out.push_back(surface::curve::line(isoline));
        return out;
    }

    // mm: least distance from rims at which a line continues along the inset.
    [[nodiscard]] double following() const { return margin_ - (1 - kFollowing) * half_; }

    // The stretches of the line, mm along it, that keep a distance `least` from rims, or that lie in the middle of a
    // part narrower than two margins.
    [[nodiscard]] std::vector<std::pair<double, double>> kept(const Line& line, std::span<const double> ways,
                                                              double least) const {
        const auto keeps = [&](const Place& p, double way) {
            const double room = this->room(p);
            return room >= least || (room >= following() && in_middle(line, ways, way));
        };
        std::vector<std::pair<double, double>> out;
        const std::size_t n = line.size(), stretches = ways.size() - 1;
        bool in = keeps(line.places[0], 0);
        double begin = 0;
        for (std::size_t i = 0; i < stretches; ++i) {
            const Place &here = line.places[i], &next = line.places[(i + 1) % n];
            const bool then = keeps({here.triangle, next.point}, ways[i + 1]);
            if (in == then) continue;
            const double step = ways[i + 1] - ways[i];
            const double way =
                ways[i] +
                step * crossing(in, [&](double part) {
                    return keeps({here.triangle, here.point + part * (next.point - here.point)}, ways[i] + part * step);
                });
            if (in)
                out.emplace_back(begin, way);
            else
                begin = way;
            in = then;
        }
        if (in) out.emplace_back(begin, ways.back());
        return out;
    }

    // The nearest place of the inset's rings, if it is within half a spacing.
    [[nodiscard]] RingPlace nearest(const Vec3& p) const {
        RingPlace out;
        double least = half_;
        for (std::uint32_t r = 0; r < inset_.rings.size(); ++r)
            if (const auto at = surface::curve::nearest(inset_.rings[r], inset_.ways[r], p); at.distance < least) {
                least = at.distance;
                out = {r, at.way};
            }
        return out;
    }

    // Arc lengths of the line's points nearest to a rim and farthest from all rims.
    [[nodiscard]] std::pair<double, double> extremes(const Line& line, std::span<const double> ways) const {
        std::size_t near = 0, far = 0;
        for (std::size_t i = 1; i < line.size(); ++i) {
            if (room(line.places[i]) < room(line.places[near])) near = i;
            if (room(line.places[i]) > room(line.places[far])) far = i;
        }
        return {ways[near], ways[far]};
    }

    // The ring of the inset nearest to a place; nullptr if it is farther than half a spacing.
    [[nodiscard]] const Line* ring(const Place& p) const {
        const RingPlace at = nearest(p.point);
        return at.ring == kNone ? nullptr : &inset_.rings[at.ring];
    }

    // The stretch of a ring beside a stretch of a line; empty if that would be a detour.
    [[nodiscard]] Line along(const Line& line, std::span<const double> ways, double from, double to) const {
        const auto at = [&](double way) { return surface::curve::at(line, ways, way).point; };
        const RingPlace a = nearest(at(from)), b = nearest(at(to));
        if (a.ring != b.ring || a.ring == kNone) return {};
        const Line& ring = inset_.rings[a.ring];
        const auto& of_ring = inset_.ways[a.ring];
        const double on = b.way - a.way, all = of_ring.back();
        const double ahead = ring.closed && on < 0 ? on + all : on, back = ring.closed && on > 0 ? all - on : -on;
        // Of both ways around, take the one whose middle is nearer to that of the stretch.
        const auto off = [&](double way) {
            return distance(surface::curve::at(ring, of_ring, way).point, at((from + to) / 2));
        };
        const bool forward = ahead >= 0 && (back < 0 || off(a.way + ahead / 2) <= off(a.way - back / 2));
        if (!((forward ? ahead : back) < rules::kHalfTurn * (to - from))) return {};
        if (forward) return surface::curve::part(ring, of_ring, a.way, a.way + ahead);
        Line out = surface::curve::part(ring, of_ring, b.way, b.way + back);
        surface::curve::reverse(out);
        return out;
    }

    [[nodiscard]] double room(const Place& p) const { return inset_.room(surface_, p); }

  private:
    // Whether the line is in the middle between rims on its two sides: its distance from rims is almost constant along
    // it, and decreases `reach` mm to either side, which is twice as far as lines may be moved.
    [[nodiscard]] bool in_middle(const Line& line, std::span<const double> ways, double way) const {
        const double reach = 2 * give_;
        const Place p = surface::curve::at(line, ways, way);
        const Place ahead =
            surface::curve::at(line, ways, line.closed ? way + reach : std::min(way + reach, ways.back()));
        const Place back = surface::curve::at(line, ways, line.closed ? way - reach : std::max(way - reach, 0.0));
        const Vec3 on = ahead.point - back.point;
        // the slope that leads from the margin to kFollowing of it within a spacing, which is two margins
        const double slope = (1 - kFollowing) / 2, l = norm(on), here = room(p);
        if (!(l > 0) || std::abs(room(ahead) - room(back)) > slope * l) return false;
        const auto& [a, b, c] = surface_.triangles[p.triangle];
        const Vec3 &u = surface_.vertices[a], &v = surface_.vertices[b], &w = surface_.vertices[c];
        const Vec3 across = cross(cross(v - u, w - u), on);
        const Vec3 step = reach / norm(across) * across;
        return room(surface::curve::step(surface_, p, step)) <= here &&
               room(surface::curve::step(surface_, p, -1 * step)) <= here;
    }

    // Bisection: the parameter up to which keeps() has the value that it has at the start of a segment.
    template <class Keeps>
    [[nodiscard]] static double crossing(bool from_inside, const Keeps& keeps) {
        double lo = 0, hi = 1;
        for (int i = 0; i < 30; ++i) {
            const double mid = (lo + hi) / 2;
            (keeps(mid) == from_inside ? lo : hi) = mid;
        }
        return from_inside ? lo : hi;
    }

    const Surface& surface_;
    double half_, margin_, give_; // mm
    Inset inset_;
};

// Splits a line into open lines that keep the margin. Where it is nearer to a rim, but not nearer than following(), it
// follows the inset. `half` is half a spacing, mm.
class RingFollower {
  public:
    RingFollower(const Surface& s, const InsetClipper& clipper, const Line& line, std::span<const double> ways,
                 double half)
        : surface_(s), clipper_(clipper), line_(line), ways_(ways), half_(half) {}

    [[nodiscard]] std::vector<Line> stretches() const {
        const auto kept = clipper_.kept(line_, ways_, clipper_.inset().margin);
        std::vector<Line> out;
        for (const auto& [from, to] : clipper_.kept(line_, ways_, clipper_.following())) {
            Line now;
            double at = from;
            for (const auto& [begin, end] : kept) {
                if (begin < from || end > to) continue;
                const bool first = now.size() == 0;
                const Line way = ring(at, begin, first, false);
                if (!first && way.size() < 2) {
                    if (begin - at < 2 * half_) // the mouth of another narrow part
                        surface::curve::append(now, surface::curve::part(line_, ways_, at, begin));
                    else
                        out.push_back(std::exchange(now, {}));
                }
                if (way.size() >= 2) surface::curve::append(now, way);
                surface::curve::append(now, surface::curve::part(line_, ways_, begin, end));
                at = end;
            }
            if (const Line way = ring(at, to, now.size() == 0, true); way.size() >= 2) surface::curve::append(now, way);
            if (now.size() >= 2) out.push_back(surface::curve::threaded(surface_, now));
        }
        return out;
    }

  private:
    // The stretch along the inset that replaces a stretch of the line. It ends half a spacing earlier where the line
    // begins or ends there.
    [[nodiscard]] Line ring(double from, double to, bool begins, bool ends) const {
        if (to - from < (begins || ends ? 2 * half_ : 0)) return {};
        Line way = clipper_.along(line_, ways_, from, to);
        const auto w = surface::curve::arc_lengths(way);
        if (way.size() < 2 || w.back() < 2 * half_) return begins || ends ? Line{} : way;
        return surface::curve::part(way, w, begins ? half_ : 0, w.back() - (ends ? half_ : 0));
    }

    const Surface& surface_;
    const InsetClipper& clipper_;
    const Line& line_;
    std::span<const double> ways_;
    double half_;
};

// A closed line that follows the inset where it is nearer to a rim, and is closed again; empty if that is impossible.
Line closed_within(const Surface& s, const InsetClipper& clipper, const Line& line, std::span<const double> ways,
                   double half, double begin) {
    const double following = clipper.following();
    if (clipper.kept(line, ways, following).size() != 1 || clipper.room(line.places[0]) < following) return {};
    const Place first = surface::curve::at(line, ways, begin);
    if (clipper.room(first) <
        clipper.inset().margin) { // the line keeps the margin nowhere: take the ring if it is about as long
        const Line* ring = clipper.ring(first);
        const bool alike = ring && ring->closed && surface::curve::length(*ring) < rules::kHalfTurn * ways.back();
        return alike ? *ring : Line{};
    }
    const Line open = surface::curve::part(line, ways, begin, begin + ways.back());
    auto found = RingFollower(s, clipper, open, surface::curve::arc_lengths(open), half).stretches();
    if (found.size() != 1 || distance(found[0][0], found[0].places.back().point) > rules::kSamePoint) return {};
    found[0].places.pop_back();
    found[0].closed = true;
    return std::move(found[0]);
}

std::vector<Line> stretches(const Surface& s, const InsetClipper& clipper, const Line& line,
                            std::span<const double> ways, double half) {
    if (!line.closed) return RingFollower(s, clipper, line, ways, half).stretches();
    if (const auto kept = clipper.kept(line, ways, clipper.inset().margin);
        kept.size() == 1 && kept[0] == std::pair(0.0, ways.back()))
        return {line};
    const auto [nearest, farthest] = clipper.extremes(line, ways);
    if (Line whole = closed_within(s, clipper, line, ways, half, farthest); whole.size() > 2) return {whole};
    // Opened where it is nearest to a rim.
    const Line open = surface::curve::part(line, ways, nearest, nearest + ways.back());
    return RingFollower(s, clipper, open, surface::curve::arc_lengths(open), half).stretches();
}

// Appends the closed lines along the rims, the outermost first.
void add_rim_beads(const Surface& s, const InsetClipper& clipper, const RowLimits& limits, Rows& out) {
    for (unsigned i = 0; i < limits.rim_beads; ++i)
        for (const Line& line : clipper.at_distance((0.5 + i) * limits.rim_bead)) {
            Row row{surface::curve::ease(s, line, {.radius = limits.radius, .corridor = limits.give}).line, 0, {}, {}};
            if (row.line.closed) out.rows.push_back(std::move(row));
        }
}

} // namespace

double Inset::room(const Surface& s, const Place& p) const {
    if (s.rims.empty()) return std::numeric_limits<double>::infinity();
    return geodesic::distance_at(s, field, p.triangle, p.point);
}

void Rows::drop(const Line& row) {
    const double l = surface::curve::length(row);
    dropped += l;
    ++drops;
    if (!(l > longest_dropped)) return;
    longest_dropped = l;
    dropped_at = row[row.size() / 2];
}

void add(std::vector<UnclippedLine>& to, const std::vector<surface::Isoline>& isolines, double sign) {
    for (const auto& isoline : isolines) {
        to.push_back({surface::curve::line(isoline), sign * isoline.level});
        if (sign < 0) surface::curve::reverse(to.back().line);
    }
}

void leave_out(std::vector<UnclippedLine>& lines, std::span<const char> marked) {
    if (marked.empty()) return;
    std::erase_if(lines, [&](const UnclippedLine& raw) {
        const auto& places = raw.line.places;
        return std::all_of(places.begin(), places.end(), [&](const Place& p) { return marked[p.triangle] != 0; });
    });
}

Rows rows(const Surface& s, const std::vector<UnclippedLine>& lines, const RowLimits& limits) {
    const double margin = limits.margin;
    Rows out;
    InsetClipper clipper(s, limits);
    add_rim_beads(s, clipper, limits, out);
    double least = margin; // until a row reaches limits.shortest
    for (const UnclippedLine& raw : lines) {
        auto parts = stretches(s, clipper, raw.line, surface::curve::arc_lengths(raw.line), margin);
        for (Line& line : parts) {
            const bool as_given = line.closed && line.size() == raw.line.size();
            if (!as_given)
                line = surface::curve::ease(s, line, {.radius = limits.radius, .corridor = limits.give}).line;
            if (surface::curve::length(line) >= limits.shortest) least = limits.shortest;
            Row row{std::move(line), raw.level, {}, {}};
            row.begin = clipper.nearest(row.line.places.front().point);
            row.end = clipper.nearest(row.line.places.back().point);
            out.rows.push_back(std::move(row));
        }
    }
    std::erase_if(out.rows, [&](const Row& row) {
        const double l = surface::curve::length(row.line);
        if (l >= least) return false;
        if (l >= margin) out.drop(row.line);
        return true;
    });
    std::stable_sort(out.rows.begin(), out.rows.end(), [](const Row& a, const Row& b) { return a.level < b.level; });
    out.inset = std::move(clipper.inset());
    return out;
}

} // namespace filum::surfpath::rows
