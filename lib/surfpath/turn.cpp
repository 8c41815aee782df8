#include "surfpath/turn.hpp"

#include <numbers>
#include <optional>

namespace filum::surfpath {

namespace {

constexpr double kArcStep = 3.0 / 180 * std::numbers::pi;
constexpr double kAllowed = 0.01; // mm beyond the bound
constexpr int kPushes = 6;

// A row with what is needed to lay circles beside it.
class Side {
  public:
    Side(std::span<const Vec2> row, bool inner_left) : row_(row) {
        ways_.push_back(0);
        for (std::size_t i = 1; i < row.size(); ++i) ways_.push_back(ways_.back() + distance(row[i - 1], row[i]));
        for (std::size_t i = 0; i < row.size(); ++i) {
            const Vec2 d = row[std::min(i + 1, row.size() - 1)] - row[i > 0 ? i - 1 : 0];
            const double l = norm(d);
            const Vec2 n = l > 0 ? 1 / l * geom::left_of(d) : Vec2{1, 0};
            inward_.push_back(inner_left ? n : -1 * n);
        }
    }

    struct Touch {
        Vec2 centre, foot;
        double way; // of the foot
    };

    // The circle of radius `r` whose centre has the height `y`, touching the row from its inner side.
    [[nodiscard]] std::optional<Touch> touch(double r, double y) const {
        for (std::size_t i = 1; i < row_.size(); ++i) {
            const Vec2 a = row_[i - 1] + r * inward_[i - 1], b = row_[i] + r * inward_[i];
            if (i == 1 && a.y < y) return Touch{{a.x, y}, row_[0], 0};
            if (a.y < y || b.y > y) continue;
            const double t = a.y > b.y ? (a.y - y) / (a.y - b.y) : 0;
            return Touch{lerp(a, b, t), lerp(row_[i - 1], row_[i], t), ways_[i - 1] + t * (ways_[i] - ways_[i - 1])};
        }
        return std::nullopt;
    }

  private:
    std::span<const Vec2> row_;
    std::vector<double> ways_;
    std::vector<Vec2> inward_;
};

// Appends the arc about `c` from `a` clockwise to `b`, without `a`.
void arc(std::vector<Vec2>& out, Vec2 c, Vec2 a, Vec2 b) {
    const Vec2 u = a - c, v = b - c;
    double sweep = -std::atan2(cross(u, v), dot(u, v));
    if (sweep < -1e-9) sweep += 2 * std::numbers::pi;
    const int n = std::max(1, static_cast<int>(std::ceil(sweep / kArcStep)));
    for (int i = 1; i < n; ++i) {
        const double t = -sweep * i / n, co = std::cos(t), si = std::sin(t);
        out.push_back(c + Vec2{co * u.x - si * u.y, si * u.x + co * u.y});
    }
    out.push_back(b);
}

struct Sides {
    Side first, second;
};

// Two arcs and a straight stretch on the height `top`; none if the arcs are in each other's way.
FlatTurn wide(const Sides& s, double r, double top) {
    const auto a = s.first.touch(r, top - r), b = s.second.touch(r, top - r);
    if (!a || !b || a->centre.x > b->centre.x) return {};
    FlatTurn out{{a->foot}, r, a->way, b->way, 0};
    arc(out.points, a->centre, a->foot, {a->centre.x, top});
    if (b->centre.x > a->centre.x + 1e-6) out.points.push_back({b->centre.x, top});
    arc(out.points, b->centre, {b->centre.x, top}, b->foot);
    return out;
}

// The arc that touches both rows, its top on the height `top`.
FlatTurn narrow(const Sides& s, double most, double top) {
    double depth = most;
    FlatTurn out;
    for (int round = 0; round < 20; ++round) {
        double lo = 0, hi = most * 1.5;
        for (int i = 0; i < 40; ++i) {
            const double r = (lo + hi) / 2;
            const auto a = s.first.touch(r, top - depth), b = s.second.touch(r, top - depth);
            if (a && b && a->centre.x < b->centre.x) lo = r;
            else hi = r;
        }
        if (std::abs(lo - depth) < 1e-6 || round == 19) {
            const auto a = s.first.touch(lo, top - depth), b = s.second.touch(lo, top - depth);
            if (!a || !b || !(lo > 0)) return {};
            out = {{a->foot}, lo, a->way, b->way, 0};
            arc(out.points, 0.5 * (a->centre + b->centre), a->foot, b->foot);
            return out;
        }
        depth = lo;
    }
    return out;
}

// How far the turn goes beyond the bound, mm.
double beyond(std::span<const Vec2> turn, std::span<const Vec2> bound) {
    double out = 0;
    for (const Vec2 p : turn) {
        double least = 1e300, side = 0;
        for (std::size_t i = 1; i < bound.size(); ++i) {
            const Vec2 d = bound[i] - bound[i - 1];
            const double l2 = norm2(d);
            if (!(l2 > 0)) continue;
            const double t = std::clamp(dot(p - bound[i - 1], d) / l2, 0.0, 1.0);
            const double far = distance(p, bound[i - 1] + t * d);
            if (far < least) least = far, side = cross(d, p - bound[i - 1]);
        }
        if (side > 0 && least < 1e300) out = std::max(out, least);
    }
    return out;
}

} // namespace

FlatTurn turn(const TurnRoom& room, double radius) {
    const Sides sides{{room.first, true}, {room.second, false}};
    double top = 0;
    for (const Vec2 p : room.bound) top = std::min(top, p.y);
    FlatTurn out;
    for (int push = 0; push < kPushes; ++push) {
        out = wide(sides, radius, top);
        if (out.points.empty()) out = narrow(sides, radius, top);
        if (out.points.empty()) return out;
        const double over = beyond(out.points, room.bound);
        if (over <= kAllowed) break;
        if (push + 1 == kPushes) return {};
        top -= over;
    }
    for (std::size_t i = 1; i < out.points.size(); ++i) out.length += distance(out.points[i - 1], out.points[i]);
    return out;
}

} // namespace filum::surfpath
