#include "laminate/edges.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "geodesic/exact.hpp"
#include "geodesic/lines.hpp"
#include "geodesic/sides.hpp"
#include "geom/bvh.hpp"
#include "geom/segment.hpp"
#include "surface/trace.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace filum::laminate {

namespace {

constexpr double kEverywhere = 1e6; // mm from the edge, on parts of the surface without an edge
constexpr double kOnEdge = 1e-7;    // sides: lines nearer than this to a side run along it, as in geodesic
constexpr double kAsNear = 0.01;    // share of the distance between edges that discs and triangles leave uncertain

// Distances from the lines, negative where `within` is negative.
Edge signed_distances(const Surface& s, const surface::Sources& lines, const std::vector<signed char>& within) {
    Edge out = lines.empty() ? Edge(s.vertices.size(), kEverywhere) : geodesic::exact_distances(s, lines).distance;
    for (std::size_t v = 0; v < out.size(); ++v) out[v] = (within[v] < 0 ? -1 : 1) * std::min(out[v], kEverywhere);
    return out;
}

// Finds what is nearer than `near` mm to a rim.
class RimNeighbourhood {
  public:
    RimNeighbourhood(const Surface& s, double near)
        : sides_(surface::rim_sources(s).segments), near_(near), tree_(boxes()) {}

    [[nodiscard]] bool beside(const Vec3& p) const {
        bool found = false;
        tree_.near(p, near_, [&](std::uint32_t i) {
            const double t = geom::nearest_parameter(sides_[i].a, sides_[i].b, p);
            const double off = distance(p, sides_[i].a + t * (sides_[i].b - sides_[i].a));
            found = found || off < near_;
            return std::min(off, near_);
        });
        return found;
    }

  private:
    [[nodiscard]] std::vector<geom::Box3> boxes() const {
        std::vector<geom::Box3> out;
        for (const auto& side : sides_) out.push_back(geom::box_of(std::array{side.a, side.b}));
        return out;
    }

    std::vector<surface::Segment> sides_;
    double near_;
    geom::Bvh tree_;
};

// Adds lines along edges of the surface in both adjacent triangles, so that both sides have them.
void add_twins(const Surface& s, surface::Sources& lines) {
    const std::size_t n = lines.segments.size();
    for (std::size_t i = 0; i < n; ++i) {
        const surface::Segment line = lines.segments[i];
        for (std::uint32_t h = 3 * line.triangle; h < 3 * line.triangle + 3; ++h) {
            const double off =
                std::max(surface::distance_to_side(s, h, line.a), surface::distance_to_side(s, h, line.b));
            if (s.twin[h] != surface::kNone && off <= kOnEdge * surface::side_length(s, h))
                lines.segments.push_back({s.twin[h] / 3, line.a, line.b});
        }
    }
}

// Negative on the left of the lines. Vertices of a rim along which lines run get the sign of their inner neighbours.
std::vector<signed char> sides_of(const Surface& s, const surface::Sources& lines) {
    const auto sides = geodesic::sides(s, lines);
    geodesic::check(sides, "a ply's boundary");
    std::vector<signed char> out(s.vertices.size(), 0);
    for (std::uint32_t v = 0; v < out.size(); ++v)
        if (!s.on_rim(v)) out[v] = static_cast<signed char>(-sides.of[v]);
    for (int round = 0; round < 2; ++round) { // a corner of a rim may have neighbours on rims only
        const auto known = out;
        for (std::uint32_t v = 0; v < out.size(); ++v) {
            if (known[v] != 0) continue;
            signed char beside = 0;
            surface::each_outgoing(s, v, [&](std::uint32_t h) {
                if (beside >= 0 && known[s.head(h)] != 0) beside = known[s.head(h)];
            });
            out[v] = beside;
        }
    }
    for (std::uint32_t v = 0; v < out.size(); ++v)
        if (out[v] == 0) out[v] = sides.of[v] > 0 ? -1 : 1;
    return out;
}

Edge edge_of_curves(const Surface& s, const Area& within, double near, Notes& notes) {
    surface::Sources lines;
    for (auto curve : within.curves) {
        curve.push_back(curve.front());
        const surface::Trace on = surface::trace(s, curve);
        lines.segments.insert(lines.segments.end(), on.segments.begin(), on.segments.end());
        if (on.off > near) notes.push_back({NoteCode::boundary_moved, on.off});
    }
    add_twins(s, lines);
    const auto side = sides_of(s, lines);
    const RimNeighbourhood rims(s, near);
    std::erase_if(lines.segments, [&](const surface::Segment& l) { return rims.beside(0.5 * (l.a + l.b)); });
    return signed_distances(s, lines, side);
}

Edge edge_of_faces(const BaseSurface& base, const Area& within) {
    const Surface& s = base.surface;
    const auto is_within = [&](std::uint32_t t) {
        return !base.faces.empty() &&
               std::find(within.faces.begin(), within.faces.end(), base.faces[t]) != within.faces.end();
    };
    surface::Sources lines;
    std::vector<signed char> side(s.vertices.size(), 1);
    bool any = false;
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        if (!is_within(h / 3)) continue;
        any = true;
        side[s.tail(h)] = -1; // those of the border are at distance 0
        if (s.twin[h] != surface::kNone && !is_within(s.twin[h] / 3)) lines.segments.push_back(surface::rim_side(s, h));
    }
    if (!any)
        throw Error(Exit::bad_input,
                    "no triangle belongs to such a face; 'peek --text' lists the faces that a STEP file "
                    "gave it");
    return signed_distances(s, lines, side);
}

// Whether `a` lies inside `b`, up to `near` mm.
bool lies_within(const Edge& a, const Edge& b, double near) {
    for (std::size_t v = 0; v < a.size(); ++v)
        if (a[v] < -near && b[v] > near) return false;
    return true;
}

double area_within(const Surface& s, const Edge& edge) {
    double sum = 0;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t)
        for (const std::uint32_t v : s.triangles[t]) sum += edge[v] < 0 ? surface::area(s, t) / 3 : 0;
    return sum;
}

// Adds a note for the edges of two plies that cross: the place where they are nearest without having been moved.
void note_crossing(const Surface& s, const Edge& a, const Edge& b, std::size_t ply, double apart, Notes& notes) {
    double least = apart * (1 - kAsNear);
    const Vec3* at = nullptr;
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        const std::uint32_t v = s.tail(h), w = s.head(h);
        if ((a[v] < 0) == (a[w] < 0)) continue; // the edge of a does not cross here
        const double off = std::min(std::abs(b[v]), std::abs(b[w]));
        if (!(off < least)) continue;
        least = off;
        at = &s.vertices[v];
    }
    if (at == nullptr) return;
    Note n{NoteCode::edges_cross, least};
    n.layer = static_cast<std::int64_t>(ply);
    n.x = at->x;
    n.y = at->y;
    n.z = at->z;
    notes.push_back(n);
}

} // namespace

Edge edge_of(const BaseSurface& base, const Area& within, double near, Notes& notes) {
    if (within.empty()) return {};
    return within.faces.empty() ? edge_of_curves(base.surface, within, near, notes) : edge_of_faces(base, within);
}

std::vector<std::vector<double>> heights_below(std::span<const Ply> plies, std::span<const Edge> edges,
                                               std::size_t vertices, double ratio) {
    std::vector<std::vector<double>> out;
    std::vector<double> height[2] = {std::vector<double>(vertices, 0), std::vector<double>(vertices, 0)};
    for (std::size_t k = 0; k < plies.size(); ++k) {
        auto& side = height[plies[k].under ? 1 : 0];
        out.push_back(side);
        const double run = std::max(ratio * plies[k].height, plies[k].spacing);
        for (std::size_t v = 0; v < vertices; ++v) {
            const double beside = edges[k].empty() ? 0 : std::clamp(edges[k][v] / run, 0.0, 1.0);
            side[v] += plies[k].height * (1 - beside);
        }
    }
    return out;
}

void make_ramps(const Surface& s, std::span<const Ply> plies, double ratio, std::vector<Edge>& edges, Notes& notes) {
    std::vector<std::size_t> order; // the largest first; ties: the lower one
    std::vector<double> area(plies.size());
    for (std::size_t k = 0; k < plies.size(); ++k) {
        if (edges[k].empty()) continue;
        area[k] = area_within(s, edges[k]);
        order.push_back(k);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return area[a] > area[b]; });
    const std::vector<Edge> asked = edges;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t k = order[i];
        for (std::size_t j = 0; j < i; ++j) {
            const std::size_t wider = order[j];
            if (plies[wider].under != plies[k].under) continue;
            const double apart = ratio * std::max(plies[k].height, plies[wider].height);
            if (!lies_within(asked[k], asked[wider], plies[k].spacing)) {
                note_crossing(s, edges[k], edges[wider], k, apart, notes);
                continue;
            }
            for (std::size_t v = 0; v < edges[k].size(); ++v)
                edges[k][v] = std::max(edges[k][v], edges[wider][v] + apart);
        }
        double moved = 0;
        for (std::size_t v = 0; v < edges[k].size(); ++v) // as far as the edge itself was moved
            if (asked[k][v] < 0) moved = std::max(moved, std::min(-asked[k][v], edges[k][v] - asked[k][v]));
        if (!(area_within(s, edges[k]) > 0))
            throw Error(Exit::failure, ply_name(k) + ": nothing of it is left within the ramp of those that end around "
                                                     "it; ask for a steeper --ramp, or smaller boundaries");
        if (!(moved > kAsNear * ratio * plies[k].height)) continue;
        Note n{NoteCode::edge_moved, moved};
        n.layer = static_cast<std::int64_t>(k);
        notes.push_back(n);
    }
}

} // namespace filum::laminate
