#include "fill/least_radius.hpp"

#include "fill/join/ring_graph.hpp"
#include "geom/segment.hpp"
#include "polygon/clip.hpp"
#include "toolpath/radius.hpp"

#include <cmath>
#include <limits>

namespace filum::fill {

using geom::Vec2;
using polygon::Loops;

namespace {

constexpr double kRoundingMargin = 1.05; // factor of the radius: rounding tightens arcs

bool sliver(const Loops& piece, double tolerance) {
    return polygon::signed_area(piece) < 1.5 * tolerance * polygon::perimeter(piece[0]);
}

// The part without the corners, tips and specks that no disc of `radius` reaches. Arms (pieces larger than radius
// squared) stay, and so do slivers beside an arm.
Loops rounded_off(const Loops& part, double radius, double tolerance) {
    const Loops open = polygon::opened(part, radius, tolerance);
    Loops corners;
    bool arms = false;
    for (const Loops& piece : polygon::split(polygon::subtract(part, open)).part) {
        const bool arm = polygon::signed_area(piece) > radius * radius; // more than a corner
        arms = arms || arm;
        if (arm || sliver(piece, tolerance)) continue;
        for (std::size_t i = 0; i < piece.size(); ++i) corners.add(piece[i]);
    }
    if (!arms) return open;
    Loops out;
    for (const Loops& piece : polygon::split(polygon::simplify(polygon::subtract(part, corners), tolerance)).part)
        for (std::size_t i = 0; i < piece.size() && !sliver(piece, tolerance); ++i) out.add(piece[i]);
    return out;
}

// Adds loops as rings of a lane. Each point gets the width of that lane at the nearest place.
void add_lane(const Loops& loops, int lane, const rings::Rings& from, const join::RingGraph& graph, double reach,
              rings::Rings& out) {
    for (std::size_t l = 0; l < loops.size(); ++l) {
        toolpath::Curve ring;
        for (const Vec2 p : loops[l]) {
            std::optional<join::Place> at;
            for (double far = reach; !at; far *= 4)
                at = graph.nearest(p, far, [&](std::uint32_t i) { return from.lane[i] == lane; });
            ring.add(p, graph.width(at->ring, at->s));
        }
        out.add(ring, lane);
    }
}

double laid(const Loops& loops, double width) {
    double length = 0;
    for (std::size_t l = 0; l < loops.size(); ++l) length += polygon::perimeter(loops[l]);
    return width * length;
}

} // namespace

rings::Rings with_round_corners(const rings::Rings& lanes, double width, double tolerance, double radius, Note& open) {
    rings::Rings out;
    if (lanes.size() == 0) return out;
    const join::RingGraph graph(lanes, 1.5 * width);
    Loops outer; // the previous lane, rounded
    double most = 0;
    for (std::size_t first = 0, next = 0; first < lanes.size(); first = next) {
        const int lane = lanes.lane[first];
        Loops now;
        for (; next < lanes.size() && lanes.lane[next] == lane; ++next)
            now.add(std::span(lanes.points).subspan(lanes.start[next], lanes.start[next + 1] - lanes.start[next]));
        now = lane == 1 ? polygon::unite(now) : polygon::intersect(now, polygon::offset(outer, -width / 2, tolerance));
        Loops kept;
        const auto parts = polygon::split(now).part;
        for (const Loops& part : parts) {
            const Loops round = rounded_off(part, kRoundingMargin * radius, tolerance);
            const std::size_t pieces = polygon::split(round).part.size();
            const bool stays = pieces > 1 || (pieces == 0 && lane == 1);
            const Loops& used = stays ? part : round;
            for (std::size_t i = 0; i < used.size(); ++i) kept.add(used[i]);
            if (stays) continue;
            const double lost = laid(part, width) - laid(used, width);
            if (lost < tolerance * radius) continue;
            open.amount += lost;
            ++open.count;
            if (lost > most) {
                most = lost;
                open.x = part[0][0].x;
                open.y = part[0][0].y;
            }
        }
        add_lane(kept, lane, lanes, graph, width + radius, out);
        outer = std::move(kept);
    }
    return out;
}

double drawn_radius(double radius, double scale, double off) {
    return radius / (1 - std::min(0.5, 2 * off * radius / (scale * scale)));
}

Note tight_turns(const std::vector<toolpath::Curve>& curves, double scale, double radius) {
    Note out{NoteCode::turn_too_tight, 0, 0};
    double tightest = radius;
    for (const auto& c : curves) {
        double since = std::numeric_limits<double>::infinity(); // mm since the last tight vertex
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            if (i > 0) since += geom::distance(c.points[i - 1], c.points[i]);
            const double r = toolpath::radius_at(c.points, true, i, scale);
            if (r >= radius) continue;
            if (since > 2 * scale) {
                ++out.count;
                ++out.amount;
            }
            since = 0;
            if (r < tightest) {
                tightest = r;
                out.x = c.points[i].x;
                out.y = c.points[i].y;
            }
        }
    }
    return out;
}

} // namespace filum::fill
