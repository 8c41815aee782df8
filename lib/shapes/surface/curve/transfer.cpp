#include "surface/curve/transfer.hpp"

#include "parallel/parallel.hpp"
#include "surface/curve/walk.hpp"

#include <algorithm>
#include <limits>

namespace filum::surface::curve {

namespace {

constexpr double far = std::numeric_limits<double>::infinity();
constexpr double kCounts = 1e-9;              // smaller weights do not count
constexpr std::size_t kVerticesAtOnce = 1024; // vertices per task
constexpr double kNear = 0.1;                 // mean edges: places this much farther count as equally near

struct CornerWeights {
    std::uint32_t vertex[3];
    double weight[3];
};

CornerWeights corners_at(const Surface& s, const Place& place) {
    const auto w = barycentric(s, place);
    CornerWeights out{};
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        out.vertex[k] = s.triangles[place.triangle][k];
        sum += out.weight[k] = w[k] > kCounts ? w[k] : 0;
    }
    for (double& w : out.weight) w /= sum;
    return out;
}

double number(const surface::Field& f, const CornerWeights& c) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (c.weight[k] == 0) continue;
        if (!std::isfinite(f.values[c.vertex[k]])) return far;
        sum += c.weight[k] * f.values[c.vertex[k]];
    }
    return sum;
}

Vec3 vector(const surface::Field& f, const CornerWeights& c) {
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

// The nearest place to p; if one that faces as `normal` is at most `near` mm farther, that one.
Place place_like(const Locator& locator, const Vec3& p, const Vec3& normal, double near) {
    const Place any = locator.nearest(p), facing = locator.nearest(p, normal);
    const double more = facing.triangle == kNone ? far : distance(facing.point, p);
    return more > distance(any.point, p) + near ? any : facing; // as at a sharp edge
}

} // namespace

std::vector<std::uint32_t> transferred_faces(const Surface& from, std::span<const std::uint32_t> faces,
                                             const Surface& to) {
    std::vector<std::uint32_t> out;
    if (faces.empty()) return out;
    out.reserve(to.triangles.size());
    const Locator locator(from);
    const double near = kNear * surface::mean_edge(to);
    for (std::uint32_t t = 0; t < to.triangles.size(); ++t) {
        const auto& [a, b, c] = to.triangles[t];
        const Vec3 middle = 1.0 / 3 * (to.vertices[a] + to.vertices[b] + to.vertices[c]);
        out.push_back(faces[place_like(locator, middle, surface::normal(to, t), near).triangle]);
    }
    return out;
}

std::vector<surface::Field> transferred(const Surface& from, std::span<const surface::Field> fields,
                                        const Surface& to) {
    return fields.empty() ? std::vector<surface::Field>{} : transferred(from, Locator(from), fields, to);
}

std::vector<surface::Field> transferred(const Surface& from, const Locator& locator,
                                        std::span<const surface::Field> fields, const Surface& to) {
    std::vector<surface::Field> out;
    for (const auto& f : fields)
        out.push_back({f.name, std::vector<double>(to.vertices.size() * f.components), f.components});
    const auto normals = vertex_normals(to);
    const double near = kNear * surface::mean_edge(to);
    parallel::for_chunks(to.vertices.size(), kVerticesAtOnce, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const CornerWeights c = corners_at(from, place_like(locator, to.vertices[v], normals[v], near));
            for (std::size_t i = 0; i < fields.size(); ++i) {
                auto& values = out[i].values;
                if (fields[i].components == 1) {
                    values[v] = number(fields[i], c);
                    continue;
                }
                const Vec3 d = vector(fields[i], c);
                values[3 * v] = d.x;
                values[3 * v + 1] = d.y;
                values[3 * v + 2] = d.z;
            }
        }
    });
    return out;
}

} // namespace filum::surface::curve
