#include "parallel/parallel.hpp"
#include "stressfield/stencil.hpp"
#include "stressfield/triangle.hpp"

#include <Eigen/Dense>

namespace filum::stressfield {

namespace {

constexpr std::size_t kNear = 12; // number of samples that determine a vertex
constexpr double kSteep = 0.7;    // slope between a sample and the plane of a vertex: 35 degrees
constexpr double kAlike = 0.5;    // least cosine between normals of one side: 60 degrees
constexpr double kHole = 2;       // spacings without a sample: a hole in the data
constexpr double kRound = 1e-9;   // of a triangle: tolerance of rounding
constexpr double kRidge = 1e-6;   // regularisation: slopes are 0 in directions without samples

struct Neighbour {
    double distance;
    std::uint32_t index;
    friend bool operator<(const Neighbour& a, const Neighbour& b) {
        return a.distance < b.distance || (a.distance == b.distance && a.index < b.index);
    }
};

geom::Bvh tree_of(const std::vector<Vec3>& points) {
    std::vector<Box3> boxes(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) boxes[i].add(points[i]);
    return geom::Bvh(boxes);
}

// The `count` nearest to `p` of those that pass, nearest first.
template <class Pass>
std::vector<Neighbour> nearest(const geom::Bvh& tree, const std::vector<Vec3>& points, const Vec3& p, std::size_t count,
                               const Pass& pass) {
    std::vector<Neighbour> heap;
    tree.near(p, kInfinity, [&](std::uint32_t i) {
        const Neighbour n{distance(p, points[i]), i};
        const bool full = heap.size() == count;
        if (pass(i) && (!full || n < heap.front())) {
            if (full) {
                std::pop_heap(heap.begin(), heap.end());
                heap.pop_back();
            }
            heap.push_back(n);
            std::push_heap(heap.begin(), heap.end());
        }
        return heap.size() == count ? heap.front().distance : kInfinity;
    });
    std::sort_heap(heap.begin(), heap.end());
    return heap;
}

// A sample relative to the surface.
struct Foot {
    bool used = false;
    Vec3 normal;        // of the surface at the nearest place
    double off = 0;     // distance from the plane there
    double reach = 0;   // greatest accepted distance
    double spacing = 0; // to the sixth neighbour
};

std::vector<Foot> feet(const Surface& s, const std::vector<Vec3>& points, const geom::Bvh& tree, double reach,
                       int threads) {
    const TriangleTree triangles(s.vertices, s.triangles);
    std::vector<Foot> out(points.size());
    parallel::for_chunks(points.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Foot& f = out[i];
            const auto others = nearest(tree, points, points[i], 7, [](std::uint32_t) { return true; });
            const double next = others.size() > 1 ? others[1].distance : kInfinity;
            f.reach = reach > 0 ? reach : next / 4;
            f.spacing = others.back().distance > 0 ? others.back().distance : kInfinity;
            const auto hit = triangles.nearest(points[i], kInfinity, [](std::uint32_t) { return true; });
            f.normal = surface::normal(s, hit.triangle);
            const Vec3 e = points[i] - hit.at;
            f.off = std::abs(dot(e, f.normal));
            const double beyond = std::sqrt(std::max(0.0, dot(e, e) - f.off * f.off));
            f.used = f.off <= f.reach && beyond <= 4 * f.spacing;
        }
    });
    return out;
}

// Weights of the corners of the triangle of `flat` that contains the origin and whose circumcircle contains no other
// point (Delaunay); ties: the first; empty if no triangle contains the origin.
std::vector<double> in_triangle(const std::vector<geom::Vec2>& flat) {
    const std::size_t n = flat.size();
    const geom::Vec2 o{0, 0};
    const auto empty = [&](std::size_t i, std::size_t j, std::size_t k) {
        const geom::Vec2 a = flat[j] - flat[i], b = flat[k] - flat[i];
        const double twice = 2 * cross(a, b), aa = norm2(a), bb = norm2(b);
        const geom::Vec2 centre{(b.y * aa - a.y * bb) / twice, (a.x * bb - b.x * aa) / twice};
        const double radius2 = norm2(centre);
        for (std::size_t m = 0; m < n; ++m)
            if (m != i && m != j && m != k && norm2(flat[m] - flat[i] - centre) < (1 - kRound) * radius2) return false;
        return true;
    };
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j)
            for (std::size_t k = j + 1; k < n; ++k) {
                const double all = orient(flat[i], flat[j], flat[k]), size = norm2(flat[k] - flat[i]);
                if (!(std::abs(all) > kRound * size)) continue;
                const double wi = orient(o, flat[j], flat[k]) / all, wj = orient(flat[i], o, flat[k]) / all;
                if (std::min({wi, wj, 1 - wi - wj}) < -kRound || !empty(i, j, k)) continue;
                std::vector<double> out(n, 0);
                out[i] = std::max(0.0, wi);
                out[j] = std::max(0.0, wj);
                out[k] = 1 - out[i] - out[j];
                return out;
            }
    return {};
}

// Weights of `found` at `p`: linear in their triangle around it; outside of all, by the affine function that fits them
// best with weights that are infinite at distance 0 and 0 from the farthest on.
std::vector<double> weights(const std::vector<Neighbour>& found, const std::vector<Vec3>& points, const Vec3& p,
                            const Vec3& normal) {
    std::vector<double> out(found.size(), 0);
    const double radius = 1.01 * found.back().distance;
    if (found.front().distance <= 1e-9 * radius || found.size() == 1) {
        out.front() = 1;
        return out;
    }
    const Vec3 u = across(normal), v = cross(normal, u);
    std::vector<geom::Vec2> flat;
    for (const Neighbour& f : found) {
        const Vec3 e = (1 / radius) * (points[f.index] - p);
        flat.push_back({dot(e, u), dot(e, v)});
    }
    if (auto linear = in_triangle(flat); !linear.empty()) return linear;
    Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
    std::vector<Eigen::Vector3d> rows(found.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
        const double d = found[k].distance, w = (radius - d) / d;
        const Eigen::Vector3d b(1, flat[k].x, flat[k].y);
        rows[k] = w * w * b;
        m += rows[k] * b.transpose();
    }
    const double ridge = kRidge * m.trace();
    m(1, 1) += ridge;
    m(2, 2) += ridge;
    const Eigen::Vector3d c = m.ldlt().solve(Eigen::Vector3d::UnitX());
    for (std::size_t k = 0; k < found.size(); ++k) out[k] = rows[k].dot(c);
    return out;
}

} // namespace

Stencils in_cloud(const Surface& s, const std::vector<Vec3>& points, double reach, int threads) {
    const geom::Bvh tree = tree_of(points);
    const auto foot = feet(s, points, tree, reach, threads);
    const auto normal = normals(s);
    const std::size_t n = s.vertices.size();
    std::vector<std::vector<Neighbour>> found(n);
    std::vector<std::vector<double>> weight(n);
    Stencils out;
    out.gap.assign(n, kInfinity);
    parallel::for_chunks(n, kGrain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const Vec3 p = s.vertices[v];
            auto near = nearest(tree, points, p, kNear, [&](std::uint32_t i) {
                if (!foot[i].used || dot(foot[i].normal, normal[v]) < kAlike) return false;
                const Vec3 e = points[i] - p;
                const double off = std::abs(dot(e, normal[v]));
                return off <= foot[i].reach + kSteep * std::sqrt(dot(e, e) - off * off);
            });
            if (near.empty()) continue;
            out.gap[v] = near.front().distance;
            if (out.gap[v] > kHole * foot[near.front().index].spacing) continue;
            weight[v] = weights(near, points, p, normal[v]);
            found[v] = std::move(near);
        }
    });
    for (std::size_t v = 0; v < n; ++v) {
        out.start.push_back(static_cast<std::uint32_t>(out.sample.size()));
        for (const Neighbour& f : found[v]) out.sample.push_back(f.index);
        out.weight.insert(out.weight.end(), weight[v].begin(), weight[v].end());
    }
    out.start.push_back(static_cast<std::uint32_t>(out.sample.size()));
    return out;
}

} // namespace filum::stressfield
