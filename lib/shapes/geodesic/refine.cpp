// Inserts points of isolines inside triangles.
#include "geodesic/isolines.hpp"

namespace filum::geodesic {

namespace {

constexpr int kDepth = 6;  // most halvings of a segment
constexpr int kSteps = 30; // most steps towards the level; each is as long as the error, since slopes are at most 1

class Refiner {
  public:
    Refiner(const Surface& s, double level, const Inside& at, double tolerance)
        : surface_(s), level_(level), at_(at), tolerance_(tolerance) {}

    // Appends points between a and b.
    void between(std::uint32_t triangle, const Vec3& a, const Vec3& b, int depth, std::vector<Vec3>& out) const {
        const Vec3 along = b - a;
        const double length = norm(along);
        if (depth == kDepth || !(length > tolerance_)) return;
        const Vec3 left = 1 / length * cross(surface::normal(surface_, triangle), along);
        Vec3 p = a + 0.5 * along;
        double off = at_(triangle, p) - level_;
        if (std::abs(off) <= tolerance_) return;
        for (int i = 0; i < kSteps && std::abs(off) > tolerance_ / 100; ++i) {
            p = p + off * left; // smaller distances are on the left
            if (!inside(triangle, p)) return;
            off = at_(triangle, p) - level_;
        }
        if (std::abs(off) > tolerance_) return;
        between(triangle, a, p, depth + 1, out);
        out.push_back(p);
        between(triangle, p, b, depth + 1, out);
    }

  private:
    [[nodiscard]] bool inside(std::uint32_t triangle, const Vec3& p) const {
        const Vec3 n = surface::normal(surface_, triangle);
        const auto& t = surface_.triangles[triangle];
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 &a = surface_.vertices[t[k]], &b = surface_.vertices[t[(k + 1) % 3]];
            if (dot(cross(b - a, p - a), n) < 0) return false;
        }
        return true;
    }

    const Surface& surface_;
    double level_;
    const Inside& at_;
    double tolerance_;
};

} // namespace

void refine(const Surface& s, Isoline& line, const Inside& at, double tolerance) {
    const Refiner refiner(s, line.level, at, tolerance);
    Isoline out{line.level, line.closed, {}, {}};
    for (std::size_t i = 0; i < line.triangles.size(); ++i) {
        out.points.push_back(line.points[i]);
        refiner.between(line.triangles[i], line.points[i], line.points[(i + 1) % line.points.size()], 0, out.points);
        out.triangles.resize(out.points.size(), line.triangles[i]);
    }
    if (!line.closed) out.points.push_back(line.points.back());
    line = std::move(out);
}

} // namespace filum::geodesic
