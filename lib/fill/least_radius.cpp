#include "fill/least_radius.hpp"

#include "geom/segment.hpp"
#include "polygon/clip.hpp"

#include <cmath>
#include <limits>

namespace filum::fill {

namespace {

constexpr double kRoundingMargin = 1.05; // for what rounding takes off an arc
constexpr double kArm = 1;               // radii squared: what is larger is more than a corner

// The point `s` along the curve from vertex i, forwards (step 1) or backwards.
Vec2 along(const std::vector<Vec2>& points, std::size_t i, bool forwards, double s) {
    const std::size_t n = points.size();
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t next = forwards ? (i + 1 == n ? 0 : i + 1) : (i == 0 ? n - 1 : i - 1);
        const double l = geom::distance(points[i], points[next]);
        if (l >= s && l > 0) return geom::lerp(points[i], points[next], s / l);
        s -= l, i = next;
    }
    return points[i];
}

bool sliver(const Loops& piece, double tolerance) {
    return polygon::signed_area(piece) < 1.5 * tolerance * polygon::perimeter(piece[0]);
}

// The part without the corners, tips and specks that no disc of `radius` reaches; arms larger than those stay, and so
// do slivers.
Loops rounded_off(const Loops& part, double radius, double tolerance) {
    const Loops open = polygon::offset(polygon::offset(part, -radius, tolerance), radius, tolerance);
    Loops corners;
    bool arms = false;
    for (const Loops& piece : polygon::split(polygon::subtract(part, open)).part) {
        const bool arm = polygon::signed_area(piece) > kArm * radius * radius;
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

// mm2 inside and under beads along the outline.
double reached(const Loops& part, double bead, double tolerance) {
    return polygon::signed_area(polygon::offset(part, bead / 2, tolerance));
}

} // namespace

Rings nested_round_rings(const Loops& first, double spacing, double min_length, double tolerance, double radius,
                         Note& open) {
    Rings out;
    Loops now = first;
    double most = 0;
    for (int level = 0; !now.empty(); ++level) {
        Loops kept;
        const auto parts = polygon::split(now).part;
        for (const Loops& part : parts) {
            const Loops round = rounded_off(part, kRoundingMargin * radius, tolerance);
            const std::size_t pieces = polygon::split(round).part.size();
            const bool touching = level == 0 && parts.size() > 1; // those must go on touching
            const bool stays = touching || pieces > 1 || (pieces == 0 && level == 0);
            const Loops& used = stays ? part : round;
            for (std::size_t i = 0; i < used.size(); ++i) kept.add(used[i]);
            if (stays) continue;
            const double lost = reached(part, spacing, tolerance) - reached(used, spacing, tolerance);
            if (lost < tolerance * radius) continue;
            open.amount += lost, ++open.count;
            if (lost > most) most = lost, open.x = part[0][0].x, open.y = part[0][0].y;
        }
        for (std::size_t i = 0; i < kept.size(); ++i) {
            if (level > 0 && polygon::perimeter(kept[i]) < min_length) continue;
            out.loops.add(kept[i]);
            out.level.push_back(level);
        }
        now = polygon::simplify(polygon::offset(kept, -spacing, tolerance), tolerance);
    }
    return out;
}

double drawn_radius(double radius, double scale, double off) {
    return radius / (1 - std::min(0.5, 2 * off * radius / (scale * scale)));
}

double radius_at(const toolpath::Curve& curve, std::size_t i, double scale) {
    const auto& p = curve.points;
    const std::size_t n = p.size();
    const Vec2 u = p[i] - p[(i + n - 1) % n], v = p[(i + 1) % n] - p[i];
    const double straight = std::numeric_limits<double>::infinity();
    if (std::abs(geom::cross(u, v)) < 1e-6 * geom::norm(u) * geom::norm(v) && dot(u, v) > 0) return straight;
    const Vec2 a = along(p, i, false, scale), b = p[i], c = along(p, i, true, scale);
    const double twice_area = std::abs(geom::orient(a, b, c));
    if (twice_area <= 1e-9 * geom::norm2(c - a) && dot(b - a, c - b) > 0) return straight;
    if (twice_area == 0) return 0; // straight back
    return geom::distance(a, b) * geom::distance(b, c) * geom::distance(c, a) / (2 * twice_area);
}

Note tight_turns(const std::vector<toolpath::Curve>& curves, double scale, double radius) {
    Note out{"", "turn tighter than the least radius", 0, "turns", 0};
    double tightest = radius;
    for (const auto& c : curves) {
        double since = std::numeric_limits<double>::infinity(); // the last tight vertex
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            if (i > 0) since += geom::distance(c.points[i - 1], c.points[i]);
            const double r = radius_at(c, i, scale);
            if (r >= radius) continue;
            if (since > 2 * scale) ++out.count, ++out.amount;
            since = 0;
            if (r < tightest) tightest = r, out.x = c.points[i].x, out.y = c.points[i].y;
        }
    }
    return out;
}

} // namespace filum::fill
