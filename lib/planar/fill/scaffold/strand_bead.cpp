#include "fill/scaffold/strand_bead.hpp"

#include "fill/join/crossings.hpp"
#include "fill/rings/wall_lanes.hpp"
#include "polygon/clip.hpp"
#include "toolpath/curve_place.hpp"
#include "toolpath/merge.hpp"

#include <algorithm>
#include <cmath>

namespace filum::fill::scaffold {

namespace {

struct Leg {
    std::vector<Vec2> line;
    double length = 0; // mm
    double width = 0;  // mm
    bool strand = false, once = false;
};

// Adds points where the width of a pass may change. They do not depend on its direction, so passes never cross.
void add_tapers(Leg& leg, double taper) {
    for (int end = 0; end < 2; ++end) {
        const Vec2 a = leg.line[0], b = leg.line[1];
        if (const double l = geom::distance(a, b); l > 3 * taper)
            leg.line.insert(leg.line.begin() + 1, geom::lerp(a, b, taper / l));
        std::reverse(leg.line.begin(), leg.line.end());
    }
}

Leg leg(const StrandGraph& g, const Step& s, const Passes& passes, double width) {
    Leg out;
    out.strand = s.strand;
    out.line = s.strand ? g.strand(s.id) : g.arcs[s.id].line;
    out.length = s.strand ? g.strand_length(s.id) : g.arcs[s.id].length;
    const std::uint32_t times = s.strand ? passes.strand[s.id] : passes.arc[s.id];
    out.width = width / times;
    out.once = times == 1;
    if (!out.once) add_tapers(out, rings::kMostOff * width);
    if (s.against) std::reverse(out.line.begin(), out.line.end());
    return out;
}

// Takes `by` mm off the end of the line.
void shorten(std::vector<Vec2>& line, double by) {
    while (line.size() > 1) {
        const Vec2 a = line[line.size() - 2], b = line.back();
        const double l = geom::distance(a, b);
        if (l > by) {
            line.back() = geom::lerp(b, a, by / l);
            return;
        }
        by -= l;
        line.pop_back();
    }
}

// Appends the curve from a to b around the corner c, tangent to both sides: the cubic nearest to a circular arc.
void append_rounded(Vec2 a, Vec2 c, Vec2 b, std::vector<Vec2>& to) {
    const Vec2 u = c - a, v = b - c;
    const double turn = std::abs(std::atan2(geom::cross(u, v), geom::dot(u, v)));
    const double pull = turn > 1e-6 && turn < 3.1 ? 4.0 / 3 * std::tan(turn / 4) / std::tan(turn / 2) : 0;
    const Vec2 p = a + pull * u, q = b - pull * v;
    const double radius = geom::norm(u) / std::max(1e-9, std::tan(turn / 2));
    const double step = 2 * std::acos(std::max(0.0, 1 - polygon::kBeadArc / radius)); // chords are off by this at most
    const int n = std::max(1, static_cast<int>(std::ceil(turn / step)));
    for (int i = 1; i <= n; ++i) {
        const double t = static_cast<double>(i) / n, s = 1 - t;
        to.push_back(s * s * s * a + 3 * s * s * t * p + 3 * s * t * t * q + t * t * t * b);
    }
}

// Rounds the corner between two legs. The round belongs to the first leg.
void round_corner(Leg& before, Leg& after, double radius) {
    if (before.strand == after.strand || !before.once || !after.once) return;
    const double by = std::min({radius, before.length / 2, after.length / 2});
    if (by < toolpath::kLeastMove / 2) return;
    const Vec2 corner = before.line.back();
    shorten(before.line, by);
    std::reverse(after.line.begin(), after.line.end());
    shorten(after.line, by);
    std::reverse(after.line.begin(), after.line.end());
    append_rounded(before.line.back(), corner, after.line.front(), before.line);
}

void append_leg(const Leg& leg, double taper, toolpath::Curve& to) {
    if (to.points.empty()) {
        to.add(leg.line.front(), leg.width);
    }
    bool same = to.width.back() == leg.width;
    for (const Vec2 p : leg.line) {
        const Vec2 last = to.points.back();
        const double l = geom::distance(last, p);
        if (l < toolpath::kLeastMove / 2) continue;
        if (!same && leg.once) {
            to.add(geom::lerp(last, p, std::min(0.5, taper / l)), leg.width);
        }
        same = true;
        to.add(p, leg.width);
    }
}

struct Bead {
    toolpath::Curve curve;
    std::vector<std::uint32_t> last; // per leg: the last segment of the curve that belongs to it
};

// The legs with the corner behind leg i rounded by at most radius[i].
Bead joined(std::vector<Leg> legs, std::span<const double> radius, double taper) {
    for (std::size_t i = 0; i + 1 < legs.size(); ++i) round_corner(legs[i], legs[i + 1], radius[i]);
    Bead out;
    for (const Leg& l : legs) {
        append_leg(l, taper, out.curve);
        out.last.push_back(static_cast<std::uint32_t>(out.curve.points.size() - 2));
    }
    return out;
}

// Halves the radii of the corners at both ends of the leg that a segment belongs to. False if all of them are 0.
bool less_round(const Bead& bead, std::uint32_t segment, std::vector<double>& radius) {
    const auto leg =
        static_cast<std::size_t>(std::lower_bound(bead.last.begin(), bead.last.end(), segment) - bead.last.begin());
    bool some = false;
    for (const std::size_t corner : {leg, leg - 1})
        if (corner < radius.size() && radius[corner] > 0) {
            radius[corner] = radius[corner] < toolpath::kLeastMove / 2 ? 0 : radius[corner] / 2;
            some = true;
        }
    return some;
}

} // namespace

Passes passes(const StrandGraph& graph, const StrandWalk& walk) {
    Passes out{std::vector<std::uint32_t>(graph.strands, 0), std::vector<std::uint32_t>(graph.arcs.size(), 0)};
    for (const auto& trail : walk.trails)
        for (const Step& s : trail) ++(s.strand ? out.strand : out.arc)[s.id];
    return out;
}

toolpath::Curve strand_bead(const StrandGraph& graph, std::span<const Step> trail, const Passes& passes, double width,
                            double radius) {
    std::vector<Leg> legs;
    for (const Step& s : trail) legs.push_back(leg(graph, s, passes, width));
    std::vector<double> radii(legs.empty() ? 0 : legs.size() - 1, radius);
    toolpath::Curve out;
    for (bool again = true; again;) {
        const Bead bead = joined(legs, radii, rings::kMostOff * width);
        again = false;
        for (const auto& [i, j] : join::crossing_pairs({bead.curve}, width)) {
            again |= less_round(bead, i, radii);
            again |= less_round(bead, j, radii);
        }
        out = bead.curve;
    }
    if (std::all_of(out.width.begin(), out.width.end(), [&](double w) { return w == width; })) out.width = {width};
    return out;
}

} // namespace filum::fill::scaffold
