#include "curve/carry.hpp"

#include "curve/locate.hpp"
#include "curve/walk.hpp"

#include <algorithm>
#include <limits>

namespace filum::curve {

namespace {

constexpr double far = std::numeric_limits<double>::infinity();
constexpr double kCounts = 1e-9; // weights below it do not
constexpr double kNear = 0.1;    // mean edges: as near as the nearest place

struct Corners {
    std::uint32_t vertex[3];
    double weight[3];
};

Corners corners_at(const Surface& s, const Place& place) {
    const auto w = barycentric(s, place);
    Corners out{};
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        out.vertex[k] = s.triangles[place.triangle][k];
        sum += out.weight[k] = w[k] > kCounts ? w[k] : 0;
    }
    for (double& w : out.weight) w /= sum;
    return out;
}

double number(const surface::Field& f, const Corners& c) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (c.weight[k] == 0) continue;
        if (!std::isfinite(f.values[c.vertex[k]])) return far;
        sum += c.weight[k] * f.values[c.vertex[k]];
    }
    return sum;
}

Vec3 vector(const surface::Field& f, const Corners& c) {
    const Vec3 lead = f.vector(c.vertex[std::max_element(c.weight, c.weight + 3) - c.weight]);
    Vec3 sum;
    double length = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (c.weight[k] == 0) continue;
        const Vec3 v = f.vector(c.vertex[k]);
        if (!std::isfinite(norm(v))) return {far, far, far};
        sum = sum + (dot(v, lead) < 0 ? -c.weight[k] : c.weight[k]) * v;
        length += c.weight[k] * norm(v);
    }
    return norm(sum) > 0 ? length / norm(sum) * sum : Vec3{};
}

} // namespace

std::vector<surface::Field> carried(const Surface& from, std::span<const surface::Field> fields, const Surface& to) {
    std::vector<surface::Field> out;
    if (fields.empty()) return out;
    for (const auto& f : fields) out.push_back({f.name, {}, f.components});
    const Locator locator(from);
    const auto normals = vertex_normals(to);
    const double near = kNear * surface::mean_edge(to);
    for (std::size_t v = 0; v < to.vertices.size(); ++v) {
        const Place any = locator.nearest(to.vertices[v]), facing = locator.nearest(to.vertices[v], normals[v]);
        const double more = facing.triangle == kNone ? far : distance(facing.point, to.vertices[v]);
        const bool turned = more > distance(any.point, to.vertices[v]) + near; // as at a sharp edge
        const Corners c = corners_at(from, turned ? any : facing);
        for (std::size_t i = 0; i < fields.size(); ++i) {
            if (fields[i].components == 1) {
                out[i].values.push_back(number(fields[i], c));
                continue;
            }
            const Vec3 d = vector(fields[i], c);
            out[i].values.insert(out[i].values.end(), {d.x, d.y, d.z});
        }
    }
    return out;
}

} // namespace filum::curve
