#include "surfpath/bare.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace filum::surfpath {

namespace {

constexpr double kPart = 1.0 / 3;         // of the spacing, between points of a triangle
constexpr double kTold = 0.01;            // of the surface: more is told aloud
constexpr double kSought = 4;             // spacings: up to where the farthest place is sought
constexpr std::uint32_t kMostParts = 256; // of a triangle's side

// The stretches of a plan by the cubes, one spacing wide, that they touch with one spacing around.
class Stretches {
  public:
    Stretches(const Surface& s, const Plan& plan, double reach) : surface_(s), reach_(reach) {
        for (const Stroke& stroke : plan.strokes)
            for (const Piece& piece : stroke.pieces)
                for (std::size_t i = 0; i + 1 < piece.line.size(); ++i)
                    add(piece.line[i], piece.line[i + 1], piece.line.places[i].triangle);
    }

    // mm; beyond the reach: infinite.  Any distance that is not above `enough` will do.
    [[nodiscard]] double distance_to(const Vec3& p, const Vec3& normal, double enough) const {
        double least = std::numeric_limits<double>::infinity();
        const auto found = cubes_.find(key(p.x, p.y, p.z));
        if (found == cubes_.end()) return least;
        for (const std::uint32_t k : found->second) {
            const Stretch& l = all_[k];
            if (!(dot(normal, surface::normal(surface_, l.triangle)) > 0)) continue;
            const Vec3 d = l.b - l.a;
            const double dd = dot(d, d), t = dd > 0 ? std::clamp(dot(p - l.a, d) / dd, 0.0, 1.0) : 0;
            least = std::min(least, distance(p, l.a + t * d));
            if (least <= enough) break;
        }
        return least <= reach_ ? least : std::numeric_limits<double>::infinity();
    }

  private:
    struct Stretch {
        Vec3 a, b;
        std::uint32_t triangle;
    };

    [[nodiscard]] std::int64_t cell(double v) const { return static_cast<std::int64_t>(std::floor(v / reach_)); }
    [[nodiscard]] std::uint64_t key(double x, double y, double z) const { return key(cell(x), cell(y), cell(z)); }
    static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
        constexpr std::uint64_t mask = (1U << 21) - 1; // far apart cubes may share a key: distances tell them apart
        return (static_cast<std::uint64_t>(x) & mask) << 42 | (static_cast<std::uint64_t>(y) & mask) << 21 |
               (static_cast<std::uint64_t>(z) & mask);
    }

    void add(const Vec3& a, const Vec3& b, std::uint32_t triangle) {
        const auto parts = static_cast<std::uint32_t>(distance(a, b) / reach_) + 1;
        for (std::uint32_t i = 0; i < parts; ++i) {
            const Vec3 from = a + i / static_cast<double>(parts) * (b - a);
            const Vec3 to = a + (i + 1) / static_cast<double>(parts) * (b - a);
            all_.push_back({from, to, triangle});
            spread(from, to);
        }
    }

    void spread(const Vec3& a, const Vec3& b) {
        const auto id = static_cast<std::uint32_t>(all_.size() - 1);
        const auto low = [&](double u, double v) { return cell(std::min(u, v) - reach_); };
        const auto high = [&](double u, double v) { return cell(std::max(u, v) + reach_); };
        for (auto x = low(a.x, b.x); x <= high(a.x, b.x); ++x)
            for (auto y = low(a.y, b.y); y <= high(a.y, b.y); ++y)
                for (auto z = low(a.z, b.z); z <= high(a.z, b.z); ++z) cubes_[key(x, y, z)].push_back(id);
    }

    const Surface& surface_;
    double reach_;
    std::vector<Stretch> all_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cubes_; // only ever asked for one key
};

} // namespace

void tell_bare(const Surface& s, Plan& plan, double spacing) {
    struct Point {
        Vec3 p, normal;
    };
    std::vector<Point> bare;
    double area = 0;
    const Stretches near(s, plan, spacing);
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const Vec3 &a = s.vertices[s.triangles[t][0]], u = s.vertices[s.triangles[t][1]] - a,
                   v = s.vertices[s.triangles[t][2]] - a, n = surface::normal(s, t);
        const double side = std::max({norm(u), norm(v), norm(u - v)});
        const auto k =
            static_cast<std::uint32_t>(std::clamp(std::ceil(side / (kPart * spacing)), 1.0, 1.0 * kMostParts));
        const double part = norm(cross(u, v)) / 2 / (static_cast<double>(k) * k);
        for (std::uint32_t i = 0; i < k; ++i)
            for (std::uint32_t j = 0; j < 2 * (k - i) - 1; ++j) { // triangles that stand up, and between them down
                const double turn = j % 2 == 0 ? 1.0 / 3 : 2.0 / 3;
                const Vec3 p = a + (i + turn) / k * u + (j / 2 + turn) / k * v;
                if (near.distance_to(p, n, spacing) <= spacing) continue;
                area += part;
                bare.push_back({p, n});
            }
    }
    plan.facts.push_back({"", "bare", area, "mm2"});
    if (!(area > kTold * surface::area(s))) return;
    const Stretches far(s, plan, kSought * spacing);
    double worst = 0;
    Vec3 at = bare.front().p;
    for (const Point& b : bare)
        if (const double d = far.distance_to(b.p, b.normal, worst); d > worst) worst = d, at = b.p;
    plan.notes.push_back({"", "no line within a spacing", area, "mm2", 1, -1, at.x, at.y});
}

} // namespace filum::surfpath
