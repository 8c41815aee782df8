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

constexpr double kStretch = 0.03;  // of the spacing
constexpr double kOfRidge = 0.9;   // of the way to the ridge that a turn of a ring takes, where the ridge is near
constexpr double kRounder = 1.05;  // least radii: what corners are rounded by, so that little remains to be eased
constexpr double kLong = 2.5;      // least radii: a corner that is cut by less is let be
constexpr double kGain = 3.3;      // least radii of length: what a radian of tight turn is good for
constexpr double kSeen = 0.06;     // least radii: what touches a ring farther from the ends of an arc lies between them
constexpr double kCusp = 0.15;     // rad
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

// The spacing up to `d` for which the farthest place is a whole number of them and a half away, if one is near; else one
// that is a little less, which wins more of the gaps at corners than it loses.
double stretched(double farthest, double d) {
    const double fits = farthest / (std::ceil(farthest / d - 0.5 - 1e-9) + 0.5);
    return fits >= (1 - kStretch) * d ? std::min(fits, d) : (1 - kStretch / 2) * d;
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

// A stretch of a ring about a corner, and what runs there instead.
struct Corner {
    double from, to; // ways; `to` may be less, round the end
    Line arc;
    double length = 0; // mm, of the arc
};

// A ring, and its corners as they are rounded by one radius after the other.
struct Ring {
    Line line;
    std::vector<double> ways;
    struct Rounded {
        std::vector<Corner> corners{};
        std::vector<double> kept{}; // ways at places where it stays as it is
        std::vector<Line> instead{}; // of all of it
    };
    std::vector<Rounded> by{}; // per radius

    [[nodiscard]] double ahead(double from, double to) const {
        const double d = std::fmod(to - from, ways.back());
        return d < 0 ? d + ways.back() : d;
    }
    [[nodiscard]] bool within(const Corner& c, const Corner& outer) const {
        const double l = ahead(outer.from, outer.to), a = ahead(outer.from, c.from), b = ahead(outer.from, c.to);
        return a <= b && b <= l;
    }
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

// One radius to round by: `inner` are the lines as much farther away.
struct Scale {
    double radius;
    std::vector<const Isoline*> inner{};
};

// Isolines of one level that are rounded alike.
struct Batch {
    double level;
    std::vector<const Isoline*> outer;
    std::vector<Scale> scales; // by falling radii
    std::vector<Line> lines{};
};

// Rounds corners: where a disc, rolling along inside a ring, does not come, but for narrow places that lead on to
// others where it does.  A smaller disc takes over where that gains much length for few tight turns.
class Rounding {
  public:
    Rounding(const Surface& s, const ExactField& field, double least)
        : surface_(s), field_(field), least_(least), edge_(longest_edge(s)) {}

    void operator()(Batch& b) const {
        std::vector<Ring> rings;
        for (const Isoline* line : b.outer) rings.push_back({curve::line(*line), {}});
        for (Ring& r : rings) r.ways = curve::ways(r.line);
        bool more = !rings.empty();
        for (std::size_t k = 0; k < b.scales.size() && more; ++k) {
            for (Ring& r : rings) r.by.emplace_back();
            for (const Line& line : opened(b.level, b.scales[k])) sort_in(line, b.level, b.scales[k].radius, rings);
            more = false;
            for (Ring& r : rings) {
                check(r);
                for (const Corner& c : r.by[k].corners) more |= r.ahead(c.from, c.to) - c.length > kLong * least_;
            }
        }
        for (Ring& r : rings) assemble(r, b);
    }

  private:
    // Lines a radius outside of `inner`.
    [[nodiscard]] std::vector<Line> opened(double level, const Scale& scale) const {
        std::vector<Line> out;
        if (scale.inner.empty()) return out;
        const auto near = geodesic::exact(surface_, as_sources(scale.inner), scale.radius + 2 * edge_);
        const double levels[] = {scale.radius};
        for (const auto& line : geodesic::isolines(surface_, near, levels)) {
            if (!line.closed || line.points.size() < 3) continue;
            if (height(curve::line(line).places[0]) > level + scale.radius) continue;
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
            rings[nearest(rings, line[0]).line].by.back().instead.push_back(line);
            return;
        }
        for (std::size_t k = 0; k < n;) { // from first + k on
            std::size_t e = k;
            double most = 0;
            while (e < n && above[(first + e) % n] > still) most = std::max(most, above[(first + e) % n]), ++e;
            if (e == k) {
                const On on = nearest(rings, line[(first + k) % n]);
                rings[on.line].by.back().kept.push_back(on.way);
                ++k;
                continue;
            }
            if (most > off) add_arc(line, first + k - 1 + n, first + e + n, rings);
            k = e;
        }
    }
    // True if the arc turns outwards somewhere: where discs about two places meet, either side of a narrow one.
    [[nodiscard]] bool has_cusp(const Line& arc) const {
        for (std::size_t i = 1; i + 1 < arc.size(); ++i) {
            const Vec3 a = arc[i] - arc[i - 1], b = arc[i + 1] - arc[i];
            const Vec3 n = surface::normal(surface_, arc.places[i].triangle);
            if (std::atan2(dot(cross(a, b), n), dot(a, b) - dot(a, n) * dot(b, n)) > kCusp) return true;
        }
        return false;
    }
    void add_arc(const Line& line, std::size_t begin, std::size_t end, std::vector<Ring>& rings) const {
        const std::size_t n = line.size();
        const On a = nearest(rings, line[begin % n]), b = nearest(rings, line[end % n]);
        if (a.line != b.line) return;
        Line arc;
        for (std::size_t i = begin; i <= end; ++i) arc.places.push_back(line.places[i % n]);
        if (has_cusp(arc)) return;
        const double l = curve::length(arc);
        rings[a.line].by.back().corners.push_back({a.way, b.way, std::move(arc), l});
    }
    // Leaves out arcs that lead across narrow places.
    void check(Ring& r) const {
        auto& now = r.by.back();
        std::erase_if(now.corners, [&](const Corner& c) {
            const double l = r.ahead(c.from, c.to);
            return std::any_of(now.kept.begin(), now.kept.end(), [&](double way) {
                const double on = r.ahead(c.from, way);
                return on > kSeen * least_ && on < l - kSeen * least_;
            });
        });
        std::sort(now.corners.begin(), now.corners.end(), [](const auto& a, const auto& b) { return a.from < b.from; });
    }

    // How much tighter than allowed a corner turns, rad.
    [[nodiscard]] double tight(const Corner& c, double radius) const { return c.length * (1 / radius - 1 / least_); }

    // The corner by this radius, or those within it by the lesser one that gains most.
    void choose(const Ring& r, const Batch& b, std::size_t k, const Corner& c, std::vector<const Corner*>& out) const {
        const double worth = -kGain * least_;
        double most = c.length + worth * tight(c, b.scales[k].radius);
        std::vector<const Corner*> best;
        std::size_t by = k;
        for (std::size_t f = k + 1; f < r.by.size(); ++f) {
            std::vector<const Corner*> finer;
            double now = r.ahead(c.from, c.to);
            for (const Corner& corner : r.by[f].corners)
                if (r.within(corner, c)) {
                    finer.push_back(&corner);
                    now += corner.length - r.ahead(corner.from, corner.to);
                    now += worth * tight(corner, b.scales[f].radius);
                }
            if (!finer.empty() && now > most) most = now, best = std::move(finer), by = f;
        }
        if (by == k) out.push_back(&c);
        for (const Corner* corner : best) choose(r, b, by, *corner, out);
    }

    void assemble(Ring& r, Batch& b) const {
        if (r.by[0].kept.empty()) {
            for (auto& line : r.by[0].instead) b.lines.push_back(std::move(line));
            return;
        }
        std::vector<const Corner*> corners;
        for (const Corner& c : r.by[0].corners) choose(r, b, 0, c, corners);
        std::sort(corners.begin(), corners.end(), [](const auto* a, const auto* c) { return a->from < c->from; });
        if (corners.empty()) {
            b.lines.push_back(std::move(r.line));
            return;
        }
        Line line{{}, false};
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Corner &c = *corners[i], &next = *corners[(i + 1) % corners.size()];
            curve::append(line, c.arc);
            const double rest = corners.size() == 1 ? r.ways.back() - r.ahead(c.from, c.to) : r.ahead(c.to, next.from);
            if (rest < r.ways.back() - 1e-6) curve::append(line, curve::part(r.line, r.ways, c.to, c.to + rest));
        }
        line.closed = true;
        b.lines.push_back(curve::threaded(surface_, line));
    }

    const Surface& surface_;
    const ExactField& field_;
    double least_, edge_;
};

} // namespace

Rings rings(const surface::Sheet& sheet, const Options& o, Facts& facts) {
    const Surface& s = sheet.surface;
    const auto field = geodesic::exact(s, all_sources(sheet));
    const auto& far = field.distance;
    double farthest = 0;
    for (const double d : far)
        if (std::isfinite(d)) farthest = std::max(farthest, d);
    Rings out;
    out.spacing = stretched(farthest, o.spacing);
    const double d = out.spacing, least = kRounder * o.least_radius;
    std::vector<double> levels;
    for (double l = d / 2; l < farthest; l += d) levels.push_back(l);
    const auto outer = geodesic::isolines(s, field, levels);
    std::vector<Climb> climbs;
    for (const auto& line : outer) climbs.push_back({line.level, top(s, far, line)});
    climb(s, far, climbs);

    // rings by level, those within low ridges apart
    std::vector<Batch> batches;
    std::vector<std::vector<std::uint32_t>> tops; // per batch: where its rings lead up to
    for (const double l : levels) {
        Batch high{l, {}, {{least}, {0.6 * least}, {0.35 * least}}};
        std::vector<std::uint32_t> high_tops;
        for (std::size_t i = 0; i < outer.size(); ++i) {
            if (!outer[i].closed || outer[i].level != l || climbs[i].to == kNone) continue;
            const double rise = far[climbs[i].to] - l, radius = kOfRidge * rise;
            if (rise > least) {
                high.outer.push_back(&outer[i]), high_tops.push_back(climbs[i].to);
                continue;
            }
            const double all = curve::length(curve::line(outer[i]));
            if (radius < kTightest * d || all < kGain * least * 2 * std::numbers::pi * (1 - radius / least)) continue;
            batches.push_back({l, {&outer[i]}, {{radius}, {0.55 * radius}}});
            tops.push_back({climbs[i].to});
        }
        if (!high.outer.empty()) batches.push_back(std::move(high)), tops.push_back(std::move(high_tops));
    }
    std::vector<double> inner_levels;
    for (const auto& b : batches)
        for (const auto& scale : b.scales) inner_levels.push_back(b.level + scale.radius);
    std::sort(inner_levels.begin(), inner_levels.end());
    inner_levels.erase(std::unique(inner_levels.begin(), inner_levels.end()), inner_levels.end());
    const auto inner = geodesic::isolines(s, field, inner_levels);
    struct Use {
        std::size_t batch, scale;
        const Isoline* line;
    };
    std::vector<Use> uses;
    climbs.clear();
    for (std::size_t b = 0; b < batches.size(); ++b)
        for (std::size_t k = 0; k < batches[b].scales.size(); ++k) {
            const double level = batches[b].level + batches[b].scales[k].radius;
            auto at = std::lower_bound(inner.begin(), inner.end(), level,
                                       [](const Isoline& l, double x) { return l.level < x; });
            for (; at != inner.end() && at->level == level; ++at)
                if (at->closed) uses.push_back({b, k, &*at}), climbs.push_back({batches[b].level, top(s, far, *at)});
        }
    climb(s, far, climbs);
    for (std::size_t i = 0; i < uses.size(); ++i) {
        const auto& t = tops[uses[i].batch];
        if (std::find(t.begin(), t.end(), climbs[i].to) != t.end())
            batches[uses[i].batch].scales[uses[i].scale].inner.push_back(uses[i].line);
    }
    const Rounding rounding(s, field, least);
    parallel::for_chunks(batches.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) rounding(batches[i]);
    });
    for (auto& b : batches)
        for (auto& line : b.lines) {
            out.lines.push_back(std::move(line));
            out.level.push_back(static_cast<int>(std::lround(b.level / d - 0.5)));
            out.radius.push_back(b.scales[0].radius);
        }
    facts.push_back({"", "rings", static_cast<double>(out.lines.size()), ""});
    facts.push_back({"", "stretch", out.spacing / o.spacing, ""});
    return out;
}

} // namespace filum::surfpath
