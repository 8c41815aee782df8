#include "surfpath/rings.hpp"

#include "base/error.hpp"
#include "curve/walk.hpp"
#include "geodesic/exact.hpp"
#include "geodesic/isolines.hpp"
#include "geodesic/query.hpp"
#include "parallel/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace filum::surfpath {

namespace {

using geodesic::ExactField;
using surface::Isoline;
using surface::kNone;

constexpr double kStretch = 0.1;   // of the spacing
constexpr double kOfRidge = 0.9;   // of the way to the ridge that a turn of a ring takes, where the ridge is near
constexpr double kWorth = 3.3;     // least radii: what a ring with tighter turns has besides them
constexpr double kTightest = 0.3;  // spacings: no ring turns tighter

// The sources, and all rims.
surface::Sources all_sources(const surface::Sheet& sheet) {
    const Surface& s = sheet.surface;
    surface::Sources out = sheet.sources;
    out.segments.clear();
    for (const auto& segment : sheet.sources.segments) out.segments.push_back(segment);
    for (const auto& rim : s.rims)
        for (const auto h : rim.sides) out.segments.push_back({h / 3, s.vertices[s.tail(h)], s.vertices[s.head(h)]});
    if (out.empty())
        throw Error(Exit::bad_input, "cannot lay rings on a closed surface without a source; run geodesic --source "
                                     "vertex:ID (or another) first");
    return out;
}

// The spacing near `d` for which the farthest place is a whole number of them and a half away.
double stretched(double farthest, double d) {
    const double n = std::max(1.0, std::floor(farthest / d));
    const double wide = farthest / (n + 0.5), tight = farthest / (n - 0.5);
    const double best = std::abs(wide / d - 1) < std::abs(tight / d - 1) ? wide : tight;
    return std::abs(best / d - 1) <= kStretch ? best : d;
}

double longest_edge(const Surface& s) {
    double out = 0;
    for (std::uint32_t h = 0; h < s.twin.size(); ++h)
        out = std::max(out, geom::distance(s.vertices[s.tail(h)], s.vertices[s.head(h)]));
    return out;
}

// The highest vertex of the triangles that a line runs through; kNone if none is as high as the line.
std::uint32_t top(const Surface& s, const std::vector<double>& far, const Isoline& line) {
    std::uint32_t out = kNone;
    for (const auto t : line.triangles)
        for (const auto v : s.triangles[t])
            if (far[v] >= line.level && (out == kNone || far[v] > far[out] || (far[v] == far[out] && v < out))) out = v;
    return out;
}

// From where to find the highest vertex that can be reached without going below a level.
struct Climb {
    double level;
    std::uint32_t from;       // kNone: leads nowhere
    std::uint32_t to = kNone; // found
};
void climb(const Surface& s, const std::vector<double>& far, std::vector<Climb>& climbs) {
    const auto higher = [&](std::uint32_t a, std::uint32_t b) { return far[a] != far[b] ? far[a] > far[b] : a < b; };
    std::vector<std::uint32_t> order(far.size()), root(far.size()), turn(climbs.size());
    std::iota(order.begin(), order.end(), 0U);
    std::iota(root.begin(), root.end(), 0U);
    std::iota(turn.begin(), turn.end(), 0U);
    std::sort(order.begin(), order.end(), higher);
    std::stable_sort(turn.begin(), turn.end(), [&](auto a, auto b) { return climbs[a].level > climbs[b].level; });
    const auto find = [&](std::uint32_t v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    std::size_t at = 0;
    for (const auto i : turn) {
        Climb& c = climbs[i];
        for (; at < order.size() && far[order[at]] >= c.level; ++at)
            surface::each_outgoing(s, order[at], [&](std::uint32_t h) {
                for (const auto v : {s.head(h), s.tail(surface::prev(h))}) {
                    if (!(far[v] >= c.level)) continue;
                    const auto a = find(v), b = find(order[at]);
                    if (a != b) root[higher(a, b) ? b : a] = higher(a, b) ? a : b;
                }
            });
        if (c.from != kNone) c.to = find(c.from);
    }
}

surface::Sources as_sources(const std::vector<const Isoline*>& lines) {
    surface::Sources out;
    for (const Isoline* l : lines)
        for (std::size_t i = 0; i < l->triangles.size(); ++i)
            out.segments.push_back({l->triangles[i], l->points[i], l->points[(i + 1) % l->points.size()]});
    return out;
}

// A place on one of several lines.
struct On {
    std::size_t line = 0;
    double way = 0, distance = 1e300;
};

// A ring, and what it runs like where its corners are rounded.
struct Ring {
    Line line;
    std::vector<double> ways;
    struct Corner {
        double from, to; // ways between which it is replaced; `to` may be less
        Line arc;
    };
    std::vector<Corner> corners;
    std::vector<double> kept;  // ways at places where it stays as it is
    std::vector<Line> instead; // of all of it
};

On nearest(const std::vector<Ring>& rings, const Vec3& p) {
    On out;
    for (std::size_t r = 0; r < rings.size(); ++r)
        for (std::size_t i = 0; i < rings[r].line.size(); ++i)
            if (const double d = distance(rings[r].line[i], p); d < out.distance) out = {r, rings[r].ways[i], d};
    if (out.distance > 1e299) return out;
    // on the stretches beside that point
    const Ring& ring = rings[out.line];
    const double reach = 0.5, all = ring.ways.back();
    const double from = out.way;
    for (int i = -100; i <= 100; ++i) {
        const double way = from + reach * i / 100;
        const double d = distance(curve::at(ring.line, ring.ways, way).point, p);
        if (d < out.distance) out.distance = d, out.way = std::fmod(way + all, all);
    }
    return out;
}

class Rounding {
  public:
    Rounding(const Surface& s, const ExactField& field) : surface_(s), field_(field), edge_(longest_edge(s)) {}

    // The isolines `outer` of one level, their corners rounded by the radius: where a disc of that size, rolling along
    // inside, does not come, but for narrow places that lead on to others where it does.  `inner`: what is a radius
    // farther away.
    [[nodiscard]] std::vector<Line> operator()(double level, const std::vector<const Isoline*>& outer,
                                               const std::vector<const Isoline*>& inner, double radius) const {
        std::vector<Ring> rings;
        for (const Isoline* line : outer) rings.push_back({curve::line(*line), {}, {}, {}, {}});
        for (Ring& r : rings) r.ways = curve::ways(r.line);
        if (!rings.empty())
            for (const Line& line : opened(level, inner, radius)) sort_in(line, level, radius, rings);
        std::vector<Line> out;
        for (Ring& r : rings) assemble(r, out);
        return out;
    }

  private:
    // Lines `radius` mm outside of `inner`.
    [[nodiscard]] std::vector<Line> opened(double level, const std::vector<const Isoline*>& inner, double radius) const {
        std::vector<Line> out;
        if (inner.empty()) return out;
        const auto near = geodesic::exact(surface_, as_sources(inner), radius + 2 * edge_);
        const double levels[] = {radius};
        for (const auto& line : geodesic::isolines(surface_, near, levels)) {
            if (!line.closed || line.points.size() < 3) continue;
            if (height(curve::line(line).places[0]) > level + radius) continue;
            out.push_back(curve::line(line));
            curve::reverse(out.back()); // what is less lies to its left again
        }
        return out;
    }

    [[nodiscard]] double height(const Place& p) const {
        return geodesic::distance_at(surface_, field_, p.triangle, p.point);
    }

    // Splits an opened line into arcs and what runs along the rings.
    void sort_in(const Line& line, double level, double radius, std::vector<Ring>& rings) const {
        const double still = 0.0015 * radius, off = 0.01 * radius;
        const std::size_t n = line.size();
        std::vector<double> above(n);
        for (std::size_t i = 0; i < n; ++i) above[i] = height(line.places[i]) - level;
        std::size_t first = n; // a place along a ring
        for (std::size_t i = 0; i < n && first == n; ++i)
            if (above[i] <= still) first = i;
        if (first == n) {
            rings[nearest(rings, line[0]).line].instead.push_back(line);
            return;
        }
        for (std::size_t k = 0; k < n;) { // from first + k on
            std::size_t e = k;
            double most = 0;
            while (e < n && above[(first + e) % n] > still) most = std::max(most, above[(first + e) % n]), ++e;
            if (e == k) {
                const On on = nearest(rings, line[(first + k) % n]);
                rings[on.line].kept.push_back(on.way);
                ++k;
                continue;
            }
            if (most > off) add_arc(line, first + k - 1 + n, first + e + n, rings);
            k = e;
        }
    }
    static void add_arc(const Line& line, std::size_t begin, std::size_t end, std::vector<Ring>& rings) {
        const std::size_t n = line.size();
        const On a = nearest(rings, line[begin % n]), b = nearest(rings, line[end % n]);
        if (a.line != b.line) return;
        Line arc;
        for (std::size_t i = begin; i <= end; ++i) arc.places.push_back(line.places[i % n]);
        rings[a.line].corners.push_back({a.way, b.way, std::move(arc)});
    }

    void assemble(Ring& r, std::vector<Line>& out) const {
        if (r.kept.empty()) {
            for (auto& line : r.instead) out.push_back(std::move(line));
            return;
        }
        const double all = r.ways.back();
        const auto ahead = [&](double from, double to) {
            const double d = std::fmod(to - from, all);
            return d < 0 ? d + all : d;
        };
        std::erase_if(r.corners, [&](const Ring::Corner& c) {
            const double l = ahead(c.from, c.to);
            return std::any_of(r.kept.begin(), r.kept.end(), [&](double way) {
                const double on = ahead(c.from, way);
                return on > 1e-3 && on < l - 1e-3;
            });
        });
        std::sort(r.corners.begin(), r.corners.end(), [](const auto& a, const auto& b) { return a.from < b.from; });
        if (r.corners.empty()) {
            out.push_back(std::move(r.line));
            return;
        }
        Line line{{}, false};
        for (std::size_t i = 0; i < r.corners.size(); ++i) {
            const auto& c = r.corners[i];
            const auto& next = r.corners[(i + 1) % r.corners.size()];
            curve::append(line, c.arc);
            const double rest = r.corners.size() == 1 ? all - ahead(c.from, c.to) : ahead(c.to, next.from);
            if (rest < all - 1e-6) curve::append(line, curve::part(r.line, r.ways, c.to, c.to + rest));
        }
        line.closed = true;
        out.push_back(curve::threaded(surface_, line));
    }

    const Surface& surface_;
    const ExactField& field_;
    double edge_;
};

// Isolines of one level that are rounded alike.
struct Batch {
    double level, radius;
    std::vector<const Isoline*> outer, inner;
    std::vector<Line> lines{};
};

} // namespace

Rings rings(const surface::Sheet& sheet, const Options& o, Facts& facts) {
    const Surface& s = sheet.surface;
    const auto field = geodesic::exact(s, all_sources(sheet));
    double farthest = 0;
    for (const double d : field.distance)
        if (std::isfinite(d)) farthest = std::max(farthest, d);
    Rings out;
    out.spacing = stretched(farthest, o.spacing);
    const double d = out.spacing, least = o.least_radius;
    std::vector<double> levels, inner_levels;
    for (double l = d / 2; l < farthest; l += d) levels.push_back(l), inner_levels.push_back(l + least);
    const auto outer = geodesic::isolines(s, field, levels);
    const auto inner = geodesic::isolines(s, field, inner_levels);
    std::vector<Climb> climbs;
    for (const auto& line : outer) climbs.push_back({line.level, top(s, field.distance, line)});
    climb(s, field.distance, climbs);

    std::vector<Batch> batches;
    for (const double l : levels) {
        batches.push_back({l, least, {}, {}});
        for (std::size_t i = 0; i < outer.size(); ++i)
            if (outer[i].closed && outer[i].level == l && climbs[i].to != kNone &&
                field.distance[climbs[i].to] > l + least)
                batches.back().outer.push_back(&outer[i]);
        for (const auto& line : inner)
            if (line.closed && std::abs(line.level - l - least) < 1e-9) batches.back().inner.push_back(&line);
    }
    // what is too low for the radius has one of its own
    struct Low {
        std::size_t line;
        double radius;
    };
    std::vector<Low> low;
    std::vector<double> low_levels;
    for (std::size_t i = 0; i < outer.size(); ++i) {
        if (!outer[i].closed || climbs[i].to == kNone) continue;
        const double high = field.distance[climbs[i].to] - outer[i].level, radius = kOfRidge * high;
        if (high > least || radius < kTightest * d) continue;
        if (curve::length(curve::line(outer[i])) < 2 * std::numbers::pi * radius + kWorth * least) continue;
        low.push_back({i, radius});
        low_levels.push_back(outer[i].level + radius);
    }
    std::sort(low_levels.begin(), low_levels.end());
    low_levels.erase(std::unique(low_levels.begin(), low_levels.end()), low_levels.end());
    const auto low_inner = geodesic::isolines(s, field, low_levels);
    for (const Low& own : low) {
        const double level = outer[own.line].level;
        batches.push_back({level, own.radius, {&outer[own.line]}, {}});
        std::vector<const Isoline*> lines;
        std::vector<Climb> to;
        for (const auto& line : low_inner)
            if (line.closed && line.level == level + own.radius)
                lines.push_back(&line), to.push_back({level, top(s, field.distance, line)});
        climb(s, field.distance, to);
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (to[i].to == climbs[own.line].to) batches.back().inner.push_back(lines[i]);
    }
    const Rounding rounding(s, field);
    parallel::for_chunks(batches.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            batches[i].lines = rounding(batches[i].level, batches[i].outer, batches[i].inner, batches[i].radius);
    });
    for (auto& b : batches)
        for (auto& line : b.lines) {
            out.lines.push_back(std::move(line));
            out.level.push_back(static_cast<int>(std::lround(b.level / d - 0.5)));
            out.radius.push_back(b.radius);
        }
    facts.push_back({"", "rings", static_cast<double>(out.lines.size()), ""});
    facts.push_back({"", "stretch", out.spacing / o.spacing, ""});
    return out;
}

} // namespace filum::surfpath
