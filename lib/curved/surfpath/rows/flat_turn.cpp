#include "surfpath/rows/flat_turn.hpp"

#include "geom/angle.hpp"
#include "geom/polyline.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace filum::surfpath::rows {

namespace {

constexpr double kAsWide = 0.97; // radii: a single arc of this radius is accepted without trying a bulb

// A row from its end inwards, with functions to place circles beside it.
class RowSide {
  public:
    RowSide(std::span<const Vec2> row, bool inner_left) : row_(row), arcs_(geom::arc_lengths(row)) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            const Vec2 d = row[std::min(i + 1, row.size() - 1)] - row[i > 0 ? i - 1 : 0];
            const double l = norm(d);
            const Vec2 n = l > 0 ? 1 / l * geom::left_of(d) : Vec2{1, 0};
            inward_.push_back(inner_left ? n : -1 * n);
        }
    }

    struct TangentCircle {
        Vec2 centre, foot; // foot: the place of contact
        double arc;        // arc length of the foot
    };

    // The circle of radius `r` with its centre at height `y` that touches the row on the inner side.
    [[nodiscard]] std::optional<TangentCircle> touch(double r, double y) const {
        for (std::size_t i = 1; i < row_.size(); ++i) {
            const Vec2 a = row_[i - 1] + r * inward_[i - 1], b = row_[i] + r * inward_[i];
            if (i == 1 && a.y < y) return TangentCircle{{a.x, y}, row_[0], 0};
            if (a.y < y || b.y > y) continue;
            const double t = a.y > b.y ? (a.y - y) / (a.y - b.y) : 0;
            return TangentCircle{lerp(a, b, t), lerp(row_[i - 1], row_[i], t),
                                 arcs_[i - 1] + t * (arcs_[i] - arcs_[i - 1])};
        }
        return std::nullopt;
    }

    // The circle of radius `r` that touches the row on the outer side and, below, a circle of the same radius around
    // `c`.
    [[nodiscard]] std::optional<TangentCircle> outer_touch(double r, Vec2 c) const {
        for (std::size_t i = 1; i < row_.size(); ++i) {
            const Vec2 a = row_[i - 1] - r * inward_[i - 1], b = row_[i] - r * inward_[i];
            const double da = distance(a, c) - 2 * r, db = distance(b, c) - 2 * r;
            if (b.y > c.y || da > 0 || db < 0) continue;
            const double t = db > da ? -da / (db - da) : 0;
            return TangentCircle{lerp(a, b, t), lerp(row_[i - 1], row_[i], t),
                                 arcs_[i - 1] + t * (arcs_[i] - arcs_[i - 1])};
        }
        return std::nullopt;
    }

    // The x coordinate of the row at height `y`.
    [[nodiscard]] double at(double y) const {
        for (std::size_t i = 1; i < row_.size(); ++i)
            if (row_[i].y <= y) return row_[i].x;
        return row_.back().x;
    }

  private:
    std::span<const Vec2> row_;
    std::vector<double> arcs_;
    std::vector<Vec2> inward_;
};

// Appends the arc around `c` from `a` (excluded) to `b`: clockwise if `sign` is 1, counter-clockwise if it is -1.
void arc(std::vector<Vec2>& out, Vec2 c, Vec2 a, Vec2 b, double sign = 1) {
    const Vec2 u = a - c, v = b - c;
    double sweep = -sign * std::atan2(cross(u, v), dot(u, v));
    if (sweep < -1e-9) sweep += 2 * std::numbers::pi;
    const int n = std::max(1, static_cast<int>(std::ceil(sweep / geom::kDegree)));
    for (int i = 1; i < n; ++i) {
        const double t = -sign * sweep * i / n, co = std::cos(t), si = std::sin(t);
        out.push_back(c + Vec2{co * u.x - si * u.y, si * u.x + co * u.y});
    }
    out.push_back(b);
}

struct RowPair {
    RowSide first, second;
};

// Two arcs connected by a straight line at height `top`; none if the arcs would overlap.
FlatTurn arc_line_arc(const RowPair& s, double r, double top) {
    const auto a = s.first.touch(r, top - r), b = s.second.touch(r, top - r);
    if (!a || !b || a->centre.x > b->centre.x) return {};
    FlatTurn out{{a->foot}, r, a->arc, b->arc, 0, false};
    arc(out.points, a->centre, a->foot, {a->centre.x, top});
    if (b->centre.x > a->centre.x + 1e-6) out.points.push_back({b->centre.x, top});
    arc(out.points, b->centre, {b->centre.x, top}, b->foot);
    return out;
}

// One arc that touches both rows, with its top at height `top`.
FlatTurn one_arc(const RowPair& s, double most, double top) {
    double depth = most;
    FlatTurn out;
    for (int round = 1; round <= rules::kMostRounds; ++round) {
        double lo = 0, hi = most * 1.5;
        for (int i = 0; i < 40; ++i) {
            const double r = (lo + hi) / 2;
            const auto a = s.first.touch(r, top - depth), b = s.second.touch(r, top - depth);
            if (a && b && a->centre.x < b->centre.x)
                lo = r;
            else
                hi = r;
        }
        if (std::abs(lo - depth) < 1e-6 || round == rules::kMostRounds) {
            const auto a = s.first.touch(lo, top - depth), b = s.second.touch(lo, top - depth);
            if (!a || !b || !(lo > 0)) return {};
            out = {{a->foot}, lo, a->arc, b->arc, 0, false};
            arc(out.points, 0.5 * (a->centre + b->centre), a->foot, b->foot);
            return out;
        }
        depth = lo;
    }
    return out;
}

// A bulb of radius `r`: leaves the first row outwards, turns around, and reaches the second row from outside.
FlatTurn bulb(const RowPair& s, double r, double top) {
    const double y = top - r;
    const Vec2 c{(s.first.at(y) + s.second.at(y)) / 2, y};
    const auto a = s.first.outer_touch(r, c), b = s.second.outer_touch(r, c);
    if (!a || !b) return {};
    const Vec2 p = 0.5 * (a->centre + c), q = 0.5 * (b->centre + c);
    if (p.x > c.x || q.x < c.x) return {};
    FlatTurn out{{a->foot}, r, a->arc, b->arc, 0, true};
    arc(out.points, a->centre, a->foot, p, -1);
    arc(out.points, c, p, q);
    arc(out.points, b->centre, q, b->foot, -1);
    return out;
}

// Distance from `p` to a segment of the bound, and on which side of it `p` lies.
struct BoundDistance {
    double far = 1e300, side = 0;
};
BoundDistance to_bound(Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 d = b - a;
    const double l2 = norm2(d);
    if (!(l2 > 0)) return {};
    const double t = std::clamp(dot(p - a, d) / l2, 0.0, 1.0);
    return {distance(p, a + t * d), cross(d, p - a)};
}

// How far the turn reaches beyond the bound, mm.
double beyond(std::span<const Vec2> turn, std::span<const Vec2> bound) {
    double out = 0;
    std::size_t last = 1; // the segment nearest to the point before, which limits the search
    for (const Vec2 p : turn) {
        BoundDistance least;
        if (last < bound.size()) least = to_bound(p, bound[last - 1], bound[last]);
        for (std::size_t i = 1; i < bound.size(); ++i) {
            const Vec2 a = bound[i - 1], b = bound[i];
            const double x = std::max(std::min(a.x, b.x) - p.x, p.x - std::max(a.x, b.x));
            const double y = std::max(std::min(a.y, b.y) - p.y, p.y - std::max(a.y, b.y));
            if (x > least.far || y > least.far) continue;
            const BoundDistance now = to_bound(p, a, b);
            if (!(now.far < least.far)) continue;
            least = now;
            last = i;
        }
        if (least.side > 0) out = std::max(out, least.far);
    }
    return out;
}

// The turn of a form, moved inwards until it is within the bound; none if that does not succeed.
template <class Form>
FlatTurn fitted(const TurnRoom& room, const Form& form) {
    double top = 0;
    for (const Vec2 p : room.bound) top = std::min(top, p.y);
    top -= room.behind;
    for (int push = 0; push < rules::kMostRounds; ++push) {
        FlatTurn out = form(top);
        if (out.points.empty()) return {};
        const double over = beyond(out.points, room.bound);
        if (over <= rules::kOff) {
            out.length = geom::length(out.points);
            return out;
        }
        top -= over;
    }
    return {};
}

} // namespace

FlatTurn turn(const TurnRoom& room, double radius, bool bulbs) {
    const RowPair sides{{room.first, true}, {room.second, false}};
    FlatTurn out = fitted(room, [&](double top) { return arc_line_arc(sides, radius, top); });
    if (!out.points.empty()) return out;
    out = fitted(room, [&](double top) { return one_arc(sides, radius, top); });
    if (out.radius >= kAsWide * radius || !bulbs) return out;
    FlatTurn round = fitted(room, [&](double top) { return bulb(sides, radius, top); });
    return round.points.empty() ? out : round;
}

} // namespace filum::surfpath::rows
