#include "polygon/medial_axis.hpp"

#include "base/error.hpp"
#include "geom/segment.hpp"
#include "polygon/sites.hpp"
#include "polygon/voronoi.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace filum::polygon {

namespace {

// Axes of the grid. Coincidences that lead the sweep astray, such as equal legs nearly along the axes, rarely do so
// along others.
constexpr Vec2 kTurns[] = {{1, 0}, {0.8, 0.6}, {5.0 / 13, 12.0 / 13}};
constexpr double kNoHeight = 1e-2; // grid units; a focus nearer to its line makes no parabola

// The point of the cell's part of the outline nearest to p, grid units.
Vec2 foot_in(const Sites& sites, const Diagram& d, std::uint32_t cell, Vec2 p) {
    const std::uint32_t v = vertex_of(sites, d, cell), i = d.segment[cell];
    return v != kNone ? sites.at(v) : geom::nearest_point(sites.at(i), sites.at(sites.next[i]), p);
}

// A curved edge. Its radius and slope at the place x along its line depend only on the height h. Between a vertex (the
// focus) and a segment it is a parabola: x runs along the segment from the focus' foot, and h is the focus' height.
// Between two vertices it is a straight line: x runs from the middle between them, and h is half their distance. Only
// its radius is curved.
struct CurvedEdge {
    Vec2 origin, along; // unit
    double h = 0, from = 0, to = 0;
    bool parabola = false;

    [[nodiscard]] Vec2 at(double x) const {
        if (!parabola) return origin + x * along;
        return origin + x * along + ((x * x + h * h) / (2 * h)) * geom::left_of(along);
    }
    // The largest distance from x to the next node for which the sagitta of radius and position is `tolerance`.
    [[nodiscard]] double step(double x, double tolerance) const {
        const double u = 1 + (x / h) * (x / h);
        return std::sqrt(8 * tolerance * h) * (parabola ? std::sqrt(std::sqrt(u)) : std::sqrt(u * std::sqrt(u)));
    }
};

CurvedEdge curve_of(const Sites& sites, const Diagram& d, std::uint32_t e) {
    const std::uint32_t cell = d.cell[e], other = d.cell[e ^ 1];
    const std::uint32_t p = vertex_of(sites, d, cell), q = vertex_of(sites, d, other);
    CurvedEdge out;
    if (p != kNone && q != kNone) {
        const Vec2 across = sites.at(q) - sites.at(p);
        out.origin = geom::lerp(sites.at(p), sites.at(q), 0.5);
        out.h = geom::norm(across) / 2;
        out.along = (1 / std::max(1.0, 2 * out.h)) * geom::left_of(across);
    } else if (p != kNone || q != kNone) {
        const std::size_t i = d.segment[p != kNone ? other : cell];
        const Vec2 focus = sites.at(p != kNone ? p : q), begin = sites.at(i);
        const Vec2 along = sites.at(sites.next[i]) - begin;
        out.along = (1 / geom::norm(along)) * along;
        out.h = cross(out.along, focus - begin);
        out.origin = begin + dot(focus - begin, out.along) * out.along;
        out.parabola = true;
    }
    out.from = dot(d.vertex[d.from[e]] - out.origin, out.along);
    out.to = dot(d.vertex[d.to(e)] - out.origin, out.along);
    return out;
}

// Adds places strictly between x0 and x1 > x0, by halving until the steps are small enough.
void add_steps(const CurvedEdge& c, double x0, double x1, double tolerance, std::vector<double>& out) {
    const double nearest = x0 * x1 < 0 ? 0 : std::min(std::abs(x0), std::abs(x1));
    if (x1 - x0 <= c.step(nearest, tolerance)) return;
    const double mid = (x0 + x1) / 2;
    add_steps(c, x0, mid, tolerance, out);
    out.push_back(mid);
    add_steps(c, mid, x1, tolerance, out);
}

// The places of the nodes between the edge's two vertices, from its first to its last.
std::vector<double> places(const CurvedEdge& c, double tolerance, double slope) {
    std::vector<double> out;
    if (c.h < kNoHeight) return out;
    const double lo = std::min(c.from, c.to), hi = std::max(c.from, c.to);
    const double steep = c.h * slope / std::sqrt(1 - slope * slope); // where the slope equals `slope`
    double last = lo;
    for (const double x : {-steep, 0.0, steep, hi}) {
        if (x <= last || x > hi) continue;
        add_steps(c, last, x, tolerance, out);
        if (x < hi) out.push_back(x);
        last = x;
    }
    if (c.from > c.to) std::reverse(out.begin(), out.end());
    return out;
}

class Builder {
  public:
    Builder(const Sites& sites, Diagram diagram, double tolerance, double slope)
        : sites_(&sites), d_(std::move(diagram)), tolerance_(tolerance * kGridPerMm), slope_(slope) {}

    MedialAxis run() {
        for (auto* v : {&out_.from, &out_.next}) v->reserve(d_.edges());
        out_.foot.reserve(d_.edges());
        node_.assign(d_.vertex.size(), kNone);
        first_.assign(d_.edges(), kNone);
        last_.assign(d_.edges(), kNone);
        std::vector<char> walked(d_.edges(), 0);
        for (std::uint32_t first = 0; first < d_.edges(); ++first)
            for (std::uint32_t e = first; d_.inside[e] && !walked[e]; e = following(e)) {
                walked[e] = 1;
                if (first_[e] == kNone) add(e & ~1U);
            }
        for (std::uint32_t e = 0; e < d_.edges(); ++e)
            if (d_.inside[e]) out_.next[last_[e]] = first_[following(e)];
        for (Vec2& p : out_.node) p = sites_->place(p);
        for (Vec2& p : out_.foot) p = sites_->place(p);
        for (double& r : out_.radius) r /= kGridPerMm;
        return std::move(out_);
    }

  private:
    [[nodiscard]] Vec2 foot(std::uint32_t cell, Vec2 p) const { return foot_in(*sites_, d_, cell, p); }

    std::uint32_t add_node(Vec2 p, double radius) {
        out_.node.push_back(p);
        out_.radius.push_back(radius);
        return out_.nodes() - 1;
    }
    std::uint32_t node_of(std::uint32_t vertex, std::uint32_t cell) {
        std::uint32_t& known = node_[vertex];
        if (known != kNone) return known;
        constexpr double kOnOutline = 1e-3; // grid units
        const Vec2 p = d_.vertex[vertex];
        const double r = geom::distance(p, foot(cell, p));
        return known = add_node(p, r < kOnOutline ? 0 : r);
    }

    // Adds the pieces of an edge, from its end to its begin. That is along the outline, because cells lie on the left.
    void add(std::uint32_t e) {
        const std::uint32_t cell = d_.cell[e], other = d_.cell[e + 1];
        std::vector<std::uint32_t> nodes{node_of(d_.from[e], cell)};
        if (d_.part[cell] != Diagram::Part::segment || d_.part[other] != Diagram::Part::segment) {
            const CurvedEdge curved = curve_of(*sites_, d_, e);
            for (const double x : places(curved, tolerance_, slope_)) {
                const Vec2 p = curved.at(x);
                nodes.push_back(add_node(p, geom::distance(p, foot(cell, p))));
            }
        }
        nodes.push_back(node_of(d_.to(e), cell));
        const auto pieces = static_cast<std::uint32_t>(nodes.size() - 1), base = out_.half_edges();
        for (std::uint32_t j = 0; j < pieces; ++j) {
            out_.from.insert(out_.from.end(), {nodes[j + 1], nodes[j]});
            out_.foot.push_back(foot(cell, out_.node[nodes[j + 1]]));
            out_.foot.push_back(foot(other, out_.node[nodes[j]]));
            out_.next.insert(out_.next.end(), {base + 2 * j - 2, base + 2 * j + 3}); // corrected at both ends later
        }
        first_[e] = base + 2 * (pieces - 1);
        first_[e + 1] = base + 1;
        last_[e] = base;
        last_[e + 1] = base + 2 * (pieces - 1) + 1;
    }

    // The next edge along the outline: the edge before e in the same cell, or in a cell beyond edges that are not
    // inside.
    [[nodiscard]] std::uint32_t following(std::uint32_t e) const {
        std::uint32_t at = d_.prev[e];
        while (!d_.inside[at]) at = d_.prev[at ^ 1];
        return at;
    }

    const Sites* sites_;
    Diagram d_;
    double tolerance_, slope_;
    std::vector<std::uint32_t> first_, last_; // per edge inside: its first and last half-edge
    std::vector<std::uint32_t> node_;         // the node of each vertex of the diagram
    MedialAxis out_;
};

} // namespace

double MedialAxis::slope(std::uint32_t h) const {
    const double l = length(h), rise = std::abs(radius[from[h]] - radius[to(h)]);
    return l > 0 ? std::min(1.0, rise / l) : 0.0;
}

MedialAxis medial_axis(const Loops& region, double outline_tolerance, double tolerance, double slope) {
    Sites sites = sites_of(region, outline_tolerance);
    for (double by = kGrowBy; by < kGrowAtMost; by *= 4) {
        if (sites.size() == 0) return {};
        for (const Vec2 turn : kTurns) {
            const Sites tried = turn.x == 1 ? sites : turned(sites, turn);
            if (tried.size() == 0) continue;
            if (std::optional<Diagram> diagram = voronoi(tried))
                return Builder(tried, std::move(*diagram), tolerance, slope).run();
        }
        sites = grown_sites_of(region, by);
    }
    throw Error(Exit::failure, "internal error: the medial axis of a region is not sound");
}

MedialAxis refined(const MedialAxis& axis, const std::vector<double>& cuts, const std::vector<std::uint32_t>& start) {
    if (cuts.empty()) return axis;
    MedialAxis out;
    const std::size_t nodes = axis.nodes() + cuts.size(), sides = axis.half_edges() + 2 * cuts.size();
    out.node.reserve(nodes);
    out.radius.reserve(nodes);
    for (auto* v : {&out.from, &out.next}) v->reserve(sides);
    out.foot.reserve(sides);
    out.node = axis.node;
    out.radius = axis.radius;
    const std::uint32_t pieces = axis.half_edges() / 2;
    const auto base = [&](std::uint32_t e) { return e + start[e]; }; // the first new piece of piece e
    const auto first = [&](std::uint32_t h) {
        const std::uint32_t e = h / 2;
        return h % 2 == 0 ? 2 * base(e) : 2 * (base(e + 1) - 1) + 1;
    };
    for (std::uint32_t e = 0; e < pieces; ++e) {
        const std::uint32_t h = 2 * e, a = axis.from[h], b = axis.from[h + 1];
        const std::uint32_t n = start[e + 1] - start[e];
        for (std::uint32_t j = 0; j <= n; ++j) {
            const std::uint32_t p = j == 0 ? a : axis.nodes() + start[e] + j - 1;
            const std::uint32_t q = j == n ? b : axis.nodes() + start[e] + j;
            const double t = j == 0 ? 0 : cuts[start[e] + j - 1], u = j == n ? 1 : cuts[start[e] + j];
            out.from.insert(out.from.end(), {p, q});
            out.foot.push_back(geom::lerp(axis.foot[h], axis.last_foot(h), t));
            out.foot.push_back(geom::lerp(axis.last_foot(h + 1), axis.foot[h + 1], u));
            out.next.push_back(j == n ? first(axis.next[h]) : 2 * (base(e) + j + 1));
            out.next.push_back(j == 0 ? first(axis.next[h + 1]) : 2 * (base(e) + j - 1) + 1);
            if (j == n) continue;
            out.node.push_back(geom::lerp(axis.node[a], axis.node[b], u));
            out.radius.push_back(axis.radius[a] + u * (axis.radius[b] - axis.radius[a]));
        }
    }
    return out;
}

} // namespace filum::polygon
