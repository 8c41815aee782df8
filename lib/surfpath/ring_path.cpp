#include "surfpath/ring_path.hpp"

#include "base/error.hpp"
#include "surface/curve/ease.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/rings.hpp"
#include "surfpath/seam.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace filum::surfpath {

namespace {

constexpr double kLeast = 0.3;    // spacings: no radius is less
constexpr double kPathStep = 0.1; // least radii: between points of the path
constexpr double kEase = 1.08;    // least radii: so that what remains keeps to it
constexpr double kSeam = 25;      // spacings: length of a seam, per lane that lanes go over by

// The place, in the triangle among those about its own that it lies in: where lines were joined it may be another.
Place settled(const Surface& s, Place p) {
    for (int round = 0; round < 3; ++round) {
        Place best{p.triangle, surface::nearest_in(s, p.triangle, p.point)};
        double least = distance(best.point, p.point);
        if (least < 1e-9) return best;
        for (const auto v : s.triangles[p.triangle])
            surface::each_outgoing(s, v, [&](std::uint32_t h) {
                const Vec3 q = surface::nearest_in(s, h / 3, p.point);
                if (const double d = distance(q, p.point); d < least) least = d, best = {h / 3, q};
            });
        if (best.triangle == p.triangle) return best;
        p.triangle = best.triangle;
    }
    return {p.triangle, surface::nearest_in(s, p.triangle, p.point)};
}

// The line in pieces, those that turn tighter than the radius declared.
std::vector<Piece> pieces(const Surface& s, const Line& line, double radius) {
    constexpr double kReach = 0.4; // mm about a place that its turn is measured over
    if (!(radius > 0)) return {{line, false}};
    const auto ways = surface::curve::ways(line);
    const double all = ways.back(), step = 0.1;
    const auto n = static_cast<std::size_t>(all / step);
    std::vector<char> tight(n + 1, 0);
    const auto reach = static_cast<std::size_t>(kReach / step);
    std::vector<Place> at;
    for (std::size_t i = 0; i <= n; ++i) at.push_back(surface::curve::at(line, ways, step * static_cast<double>(i)));
    for (std::size_t i = 2; i + 2 <= n; ++i) {
        const Vec3 a = at[i].point - at[i - 2].point, b = at[i + 2].point - at[i].point;
        const Vec3 m = surface::normal(s, at[i].triangle);
        const double turn = std::abs(std::atan2(dot(cross(a, b), m), dot(a, b) - dot(a, m) * dot(b, m)));
        if (turn < 2 * step * 1.15 / radius) continue;
        for (std::size_t k = i - std::min(i, reach); k <= std::min(n, i + reach); ++k) tight[k] = 1;
    }
    std::vector<Piece> out;
    for (std::size_t i = 0; i < n;) {
        std::size_t j = i + 1;
        while (j < n && tight[j] == tight[i]) ++j;
        out.push_back({surface::curve::part(line, ways, step * static_cast<double>(i),
                                            j == n ? all : step * static_cast<double>(j)),
                       tight[i] != 0});
        for (Place* p : {&out.back().line.places.front(), &out.back().line.places.back()}) *p = settled(s, *p);
        i = j;
    }
    return out;
}

// The line with points where it crosses edges only if it would leave the surface by more than 0.004 mm between its own:
// of two points that are next to nothing apart, each turns by any angle.
Line slim_threaded(const Surface& s, const Line& line) {
    constexpr double kOff = 4e-3;
    Line out;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        out.places.push_back(line.places[i]);
        const Line way = surface::curve::join(s, line.places[i], line.places[i + 1]);
        const Vec3 d = line[i + 1] - line[i];
        for (std::size_t k = 1; k + 1 < way.size(); ++k) {
            const Vec3 p = way[k] - line[i];
            const double l = dot(d, d), t = l > 0 ? dot(p, d) / l : 0;
            if (norm(p - t * d) > kOff) out.places.push_back(way.places[k]);
        }
    }
    out.places.push_back(line.places.back());
    return out;
}

// The line eased, with points in equal steps, so that the noise of crossings with edges does not count as curvature.
Line gentle(const Surface& s, const Line& line, double radius, double spacing) {
    const auto eased =
        surface::curve::ease(s, line, {.radius = kEase * radius, .corridor = 0.25 * spacing, .step = 0.05 * radius});
    Line out = surface::curve::resampled(eased.line, kPathStep * radius);
    for (Place& p : out.places) p = settled(s, p);
    return slim_threaded(s, out);
}

} // namespace

namespace {

// Notes of rings that stayed apart, and facts of how tight the path turns.
void tell(Plan& plan, std::size_t apart) {
    double hairpins = 0, length = 0;
    for (const Stroke& stroke : plan.strokes)
        for (const Piece& p : stroke.pieces)
            if (p.hairpin) hairpins += 1, length += surface::curve::length(p.line);
    plan.facts.push_back({"", "hairpins", hairpins, ""});
    plan.facts.push_back({"", "hairpin-length", length, "mm"});
    if (apart == 0) return;
    const Vec3 at = plan.strokes.back().pieces[0].line[0];
    Note note;
    note.what = "ring not joined";
    note.amount = static_cast<double>(apart);
    note.unit = "rings";
    note.x = at.x, note.y = at.y;
    plan.notes.push_back(std::move(note));
}

} // namespace

Plan ring_path(const surface::Sheet& sheet, const Options& given, int by) {
    Plan out;
    Options o = given;
    o.least_radius = std::max(o.least_radius, kLeast * o.spacing);
    const Surface& s = sheet.surface;
    Rings made = rings(sheet, o, out.facts);
    const Lanes lanes(s, made.lines, made.spacing);
    Weave weave(lanes);
    std::uint32_t start = surface::kNone;
    for (std::uint32_t l = 0; l < lanes.size(); ++l)
        if (made.level[l] == 0 && (start == surface::kNone || lanes.length(l) > lanes.length(start))) start = l;
    std::vector<std::uint32_t> merged;
    if (start != surface::kNone) {
        const Rungs seam =
            seam_place(lanes, start, 2 * std::sqrt(o.least_radius * made.spacing * by), kSeam * by * made.spacing);
        if (seam.lanes() >= static_cast<std::size_t>(by) + 1) {
            shift(weave, lanes, seam, by);
            merged = seam.lane;
        }
        out.facts.push_back({"", "seam-lanes", static_cast<double>(seam.lanes()), ""});
        if (seam.lanes()) out.facts.push_back({"", "seam-length", shortest(lanes, seam), "mm"});
    }
    if (merged.empty() && start != surface::kNone) merged = {start};
    const std::size_t apart = cross_over(weave, lanes, merged, o.least_radius);
    for (auto& course : weave.courses()) {
        const Line line = gentle(s, course.line, o.least_radius, made.spacing);
        out.strokes.push_back({pieces(s, line, o.least_radius)});
    }
    if (out.strokes.empty())
        throw Error(Exit::failure, "cannot lay rings: none is closed; make other triangles by geodesic --remesh");
    std::set<std::uint32_t> components; // that have rings
    for (const Line& line : made.lines) components.insert(s.component[line.places[0].triangle]);
    tell(out, apart + 1 - components.size());
    return out;
}

} // namespace filum::surfpath
