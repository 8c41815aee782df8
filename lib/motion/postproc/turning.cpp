#include "postproc/turning.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "geom/angle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace filum::postproc {

namespace {

using geom::kDegree;
constexpr double kAnglesPerDegree = 1e4;

struct Ball {
    Vec3 centre;
    double radius = -1;
    [[nodiscard]] bool holds(const Vec3& p) const { return distance(p, centre) <= radius + 1e-12; }
};

// The smallest ball with two to four points all on its surface; nothing if they are degenerate.
std::optional<Ball> around(std::span<const Vec3> p) {
    const std::size_t n = p.size() - 1;
    std::array<std::array<double, 4>, 3> m{}; // 2 (d_i . d_j) l_j = d_i . d_i
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) m[i][j] = 2 * dot(p[i + 1] - p[0], p[j + 1] - p[0]);
        m[i][3] = m[i][i] / 2;
    }
    for (std::size_t i = 0; i < n; ++i) {
        std::size_t best = i;
        for (std::size_t r = i + 1; r < n; ++r)
            if (std::abs(m[r][i]) > std::abs(m[best][i])) best = r;
        std::swap(m[i], m[best]);
        if (std::abs(m[i][i]) < 1e-14) return std::nullopt;
        for (std::size_t r = 0; r < n; ++r) {
            if (r == i) continue;
            const double f = m[r][i] / m[i][i];
            for (std::size_t c = i; c < 4; ++c) m[r][c] -= f * m[i][c];
        }
    }
    Vec3 centre = p[0];
    for (std::size_t i = 0; i < n; ++i) centre = centre + (m[i][3] / m[i][i]) * (p[i + 1] - p[0]);
    return Ball{centre, distance(centre, p[0])};
}

// The smallest ball around up to five points.  Afterwards the points are those on its surface that define it.
Ball smallest(std::vector<Vec3>& points) {
    Ball best;
    std::vector<Vec3> fixed, chosen;
    for (unsigned set = 1; set < 1U << points.size(); ++set) {
        chosen.clear();
        for (std::size_t i = 0; i < points.size(); ++i)
            if ((set >> i & 1U) != 0) chosen.push_back(points[i]);
        if (chosen.size() > 4) continue;
        const auto ball = chosen.size() == 1 ? Ball{chosen[0], 0} : around(chosen);
        if (!ball || (best.radius >= 0 && ball->radius >= best.radius)) continue;
        if (std::ranges::all_of(points, [&](const Vec3& p) { return ball->holds(p); })) {
            best = *ball;
            fixed = chosen;
        }
    }
    points = fixed;
    return best;
}

Turning of_columns(const Vec3& x, const Vec3& y, const Vec3& z) {
    const double ry = std::asin(std::clamp(-x.z, -1.0, 1.0));
    const bool level = std::hypot(x.x, x.y) > 1e-9;
    const double rx = level ? std::atan2(y.z, z.z) : std::atan2(-z.y, y.y), rz = level ? std::atan2(x.y, x.x) : 0;
    const auto rounded = [](double rad) {
        return std::round(rad / kDegree * kAnglesPerDegree) / kAnglesPerDegree + 0.0;
    };
    return turning({rounded(rx), rounded(ry), rounded(rz)});
}

} // namespace

Turning turning(const std::array<double, 3>& degrees) {
    const auto turned = [&](Vec3 v) {
        const auto by = [](double a, double& from, double& to) {
            const double c = std::cos(a * kDegree), s = std::sin(a * kDegree), f = from;
            from = c * f - s * to;
            to = s * f + c * to;
        };
        by(degrees[0], v.y, v.z);
        by(degrees[1], v.z, v.x);
        by(degrees[2], v.x, v.y);
        return v;
    };
    return {degrees, turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1})};
}

Turning upright(const Vec3& up) {
    const Vec3 u = 1 / norm(up) * up;
    const double c = u.z;
    if (c < -1 + 1e-12) return turning({180, 0, 0});
    // Rodrigues about u x z: v -> c v + (u x z) x v + (u x z . v) / (1 + c) (u x z)
    const Vec3 k = cross(u, Vec3{0, 0, 1});
    const auto turned = [&](const Vec3& v) { return c * v + cross(k, v) + dot(k, v) / (1 + c) * k; };
    return of_columns(turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1}));
}

Orient parse_orient(const std::string& text) {
    if (text == "as-is") return {};
    if (text == "auto") return {true, {}};
    const bool up = text.starts_with("up:");
    std::array<double, 3> numbers{};
    std::size_t at = up ? 3 : 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t end = k < 2 ? text.find(',', at) : text.size();
        if (end == std::string::npos)
            throw Error(Exit::usage, "--orient takes as-is, auto, RX,RY,RZ in degrees or up:X,Y,Z, not '" + text + "'");
        numbers[k] = parse_number(std::string_view(text).substr(at, end - at), "--orient");
        if (!(std::abs(numbers[k]) <= 1e6))
            throw Error(Exit::usage, "--orient: a number is out of range in '" + text + "'");
        at = end + 1;
    }
    if (!up) return {false, turning(numbers)};
    const Vec3 v{numbers[0], numbers[1], numbers[2]};
    if (!(norm(v) > 1e-9)) throw Error(Exit::usage, "--orient up:X,Y,Z needs a direction, not '" + text + "'");
    return {false, upright(v)};
}

Cone narrowest_cone(std::span<const Vec3> axes) {
    if (axes.empty()) return {};
    std::vector<Vec3> fixed{axes[0]};
    Ball ball{axes[0], 0};
    for (int round = 0; round < 1000; ++round) {
        const auto farthest = std::ranges::max_element(
            axes, [&](const Vec3& a, const Vec3& b) { return distance(a, ball.centre) < distance(b, ball.centre); });
        if (ball.holds(*farthest)) break;
        fixed.push_back(*farthest);
        const Ball next = smallest(fixed);
        if (!(next.radius > ball.radius)) break; // as exact as rounding allows
        ball = next;
    }
    const double size = norm(ball.centre);
    if (size < 1e-6) return {{0, 0, 1}, std::numbers::pi};
    Cone out{1 / size * ball.centre, 0};
    for (const Vec3& a : axes) out.half = std::max(out.half, angle(a, out.axis));
    return out;
}

std::string placed_text(const Turning& t, const Vec3& shift) {
    const auto three = [](double a, double b, double c, int decimals) {
        return fixed_text(a, decimals) + ", " + fixed_text(b, decimals) + ", " + fixed_text(c, decimals);
    };
    std::string out = "placed: the toolpath";
    if (!t.none())
        out += " turned by " + three(t.degrees[0], t.degrees[1], t.degrees[2], 4) +
               " degrees about x, then y, then z, and";
    return out + " moved by " + three(shift.x, shift.y, shift.z, 3) + " mm";
}

} // namespace filum::postproc
