#include "infill/opening.hpp"

#include "geom/segment.hpp"
#include "polygon/clip.hpp"
#include "polygon/simple.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace filum::infill {

namespace {

using geom::Box2;
using geom::Vec2;
using polygon::Loops;

constexpr double kFlat = 1e-3; // mm: a corner that moves by less stays as it is
// Radii by which the line may leave an arc in a corner: an eighth of a bead, which nothing beside the line notices,
// since the bead lies between the arc and the corner of its cell.
constexpr double kArcGive = 0.25;

// An edge of a loop. The area is on its left.
struct Edge {
    Vec2 from, along; // a unit vector
    double length = 0;
    [[nodiscard]] Vec2 inward() const { return geom::left_of(along); }
    [[nodiscard]] Vec2 at(double t) const { return from + t * along; }
};

std::vector<Edge> edges_of(std::span<const Vec2> loop) {
    std::vector<Edge> out(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 d = loop[i + 1 == loop.size() ? 0 : i + 1] - loop[i];
        const double length = std::hypot(d.x, d.y);
        out[i] = {loop[i], (1 / length) * d, length};
    }
    return out;
}

double turn(const Edge& a, const Edge& b) {
    return std::atan2(geom::cross(a.along, b.along), geom::dot(a.along, b.along));
}

// Adds the points of an arc from `right`, a unit vector, by `angle` towards `ahead`.
void add_arc(Vec2 centre, Vec2 right, Vec2 ahead, double radius, double angle, Loops& to) {
    const double step = 2 * std::acos(1 - std::min(1.0, polygon::kBeadArc / radius));
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / step)));
    for (int k = 0; k <= steps; ++k) {
        const double t = angle * k / steps;
        to.points.push_back(centre + (radius * std::cos(t)) * right + (radius * std::sin(t)) * ahead);
    }
}

// Adds the fewest points of a line around an arc, from `right` by `angle` towards `ahead`: it touches the arc, begins
// and ends on the tangents at its ends, and is off by at most kArcGive.
void add_tangents(Vec2 centre, Vec2 right, Vec2 ahead, double radius, double angle, Loops& to) {
    const double step = 2 * std::acos(1 / (1 + kArcGive));
    const int points = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / step)));
    const double half = angle / (2 * points), reach = radius / std::cos(half);
    for (int k = 0; k < points; ++k) {
        const double t = (2 * k + 1) * half;
        to.points.push_back(centre + (reach * std::cos(t)) * right + (reach * std::sin(t)) * ahead);
    }
}

// Rolls a disc along the inside of a loop. From edge to edge it passes a corner as it is, or it touches both edges at
// once and leaves an arc. Edges that it does not reach in between are left out.
class RollingDisc {
  public:
    RollingDisc(std::span<const Vec2> loop, double radius) : edge_(edges_of(loop)), radius_(radius) {}

    // True if the disc can roll round the loop, and its centre never comes back to its line. Then the line that it
    // touches, with arcs, is the outline of the opening.
    bool run() {
        const std::size_t n = edge_.size(), first = start();
        kept_ = {{first, 0, {}, false}};
        for (std::size_t k = 1; k <= n; ++k)
            if (!reach((first + k) % n, k == n)) return false;
        return is_clear() && polygon::is_simple(centre_line());
    }

    void add_to(Loops& to) const {
        for (std::size_t k = 1; k < kept_.size(); ++k) {
            const Edge &a = edge_[kept_[k - 1].edge], &b = edge_[kept_[k].edge];
            const bool neighbours = (kept_[k - 1].edge + 1) % edge_.size() == kept_[k].edge;
            if (kept_[k].arc && neighbours)
                add_tangents(kept_[k].centre, -1.0 * a.inward(), a.along, radius_, turn(a, b), to);
            else if (kept_[k].arc)
                add_arc(kept_[k].centre, -1.0 * a.inward(), a.along, radius_, turn(a, b), to);
            else
                to.points.push_back(b.from);
        }
        to.close();
    }

  private:
    struct EdgeContact {
        std::size_t edge;
        double begin; // mm along the edge
        Vec2 centre;  // of the disc where it comes to the edge, if it leaves an arc there
        bool arc;
    };

    // An edge that the disc surely reaches: the one with the most length left between arcs at its ends.
    [[nodiscard]] std::size_t start() const {
        std::size_t best = 0;
        double most = -1e300;
        const std::size_t n = edge_.size();
        for (std::size_t i = 0; i < n; ++i) {
            const double before = cut(edge_[(i + n - 1) % n], edge_[i]), after = cut(edge_[i], edge_[(i + 1) % n]);
            if (edge_[i].length - before - after > most) {
                most = edge_[i].length - before - after;
                best = i;
            }
        }
        return best;
    }
    // How far from a corner the disc touches the edges.
    [[nodiscard]] double cut(const Edge& a, const Edge& b) const {
        return radius_ * std::max(0.0, std::tan(turn(a, b) / 2));
    }

    // Lets the disc come to an edge; leaves out those before it that it cannot touch, or this one. False if it gets
    // stuck. The last edge is the first one again.
    bool reach(std::size_t next, bool last) {
        const Edge& b = edge_[next];
        while (true) {
            const Edge& a = edge_[kept_.back().edge];
            const double angle = turn(a, b), arc = std::tan(std::abs(angle) / 2) * std::tan(std::abs(angle) / 4);
            const bool neighbours = (kept_.back().edge + 1) % edge_.size() == next;
            if (neighbours && (angle <= 0 || radius_ * arc < kFlat)) {
                kept_.push_back({next, 0, {}, false});
                return true;
            }
            if (!(angle > 0)) return false;
            // where lines at the radius beside both edges meet
            const Vec2 p = a.from + radius_ * a.inward(), q = b.from + radius_ * b.inward();
            const double sine = geom::cross(a.along, b.along);
            const double t = geom::cross(q - p, b.along) / sine, u = geom::cross(q - p, a.along) / sine;
            if (!(t > kept_.back().begin)) {
                if (kept_.size() == 1) return false;
                kept_.pop_back();
                continue;
            }
            if (t > a.length || u < 0) return false;
            const double end = !last || kept_.size() < 2 ? b.length : leaves_first();
            if (!(u < end)) return !last;
            kept_.push_back({next, u, p + t * a.along, true});
            return true;
        }
    }
    // Where the disc leaves the first edge, mm along it.
    [[nodiscard]] double leaves_first() const {
        const Edge& a = edge_[kept_[0].edge];
        return kept_[1].arc ? geom::dot(kept_[1].centre - a.from, a.along) : a.length;
    }

    // True if no edge that was left out reaches into the disc.
    [[nodiscard]] bool is_clear() const {
        for (std::size_t k = 1; k < kept_.size(); ++k)
            for (std::size_t e = (kept_[k - 1].edge + 1) % edge_.size(); e != kept_[k].edge; e = (e + 1) % edge_.size())
                if (geom::point_segment_distance(edge_[e].from, edge_[e].at(edge_[e].length), kept_[k].centre) <
                    radius_ - kFlat)
                    return false;
        return true;
    }

    [[nodiscard]] Loops centre_line() const {
        Loops out;
        for (std::size_t k = 1; k < kept_.size(); ++k) {
            const Edge &a = edge_[kept_[k - 1].edge], &b = edge_[kept_[k].edge];
            const double angle = turn(a, b);
            if (kept_[k].arc)
                out.points.push_back(kept_[k].centre);
            else if (radius_ * std::tan(std::abs(angle) / 2) * std::tan(std::abs(angle) / 4) < kFlat)
                out.points.push_back(b.from +
                                     (radius_ / (1 + geom::dot(a.along, b.along))) * (a.inward() + b.inward()));
            else // around a concave corner
                add_arc(b.from, a.inward(), a.along, radius_, -angle, out);
        }
        out.close();
        return out;
    }

    std::vector<Edge> edge_;
    double radius_;
    std::vector<EdgeContact> kept_; // the last one is the first one again
};

// The loops that are holes, or may have holes.
std::vector<char> about_holes(const Loops& cells) {
    std::vector<char> out(cells.size(), 0);
    std::vector<Box2> holes;
    for (std::size_t l = 0; l < cells.size(); ++l)
        if (polygon::signed_area(cells[l]) < 0) {
            out[l] = 1;
            holes.push_back(polygon::bounds(cells[l]));
        }
    for (std::size_t l = 0; l < cells.size() && !holes.empty(); ++l)
        if (out[l] == 0) {
            const Box2 box = polygon::bounds(cells[l]);
            out[l] = static_cast<char>(
                std::any_of(holes.begin(), holes.end(), [&](const Box2& hole) { return geom::meet(hole, box); }));
        }
    return out;
}

} // namespace

Loops opened_cells(const Loops& cells, double radius) {
    Loops out, others;
    const std::vector<char> holed = about_holes(cells);
    for (std::size_t l = 0; l < cells.size(); ++l) {
        RollingDisc disc(cells[l], radius);
        if (holed[l] == 0 && disc.run())
            disc.add_to(out);
        else
            others.add(cells[l]);
    }
    if (!others.empty()) out.add(polygon::opened(others, radius, polygon::kBeadArc));
    return out;
}

} // namespace filum::infill
