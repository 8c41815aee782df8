// From functions to triangles, and what spoils them.
#include "shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace filum::trials {

namespace {

using Corners = std::vector<std::uint32_t>;

// Cuts triangles, or tetrahedra's edges, where values change their sign: one vertex per edge.
template <class Point>
class Edges {
  public:
    Edges(std::vector<Point>& points, const std::vector<double>& value) : points_(points), value_(value) {}
    std::uint32_t cut(std::uint32_t a, std::uint32_t b) {
        if (a > b) std::swap(a, b);
        const auto [it, fresh] = on_.insert({{a, b}, static_cast<std::uint32_t>(points_.size())});
        if (fresh) {
            const double t = std::clamp(value_[a] / (value_[a] - value_[b]), 0.02, 0.98);
            points_.push_back(points_[a] + t * (points_[b] - points_[a]));
        }
        return it->second;
    }

  private:
    std::vector<Point>& points_;
    const std::vector<double>& value_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> on_;
};

// Without vertices that no triangle has.
void drop_loose(Mesh& mesh) {
    std::vector<std::uint32_t> number(mesh.vertices.size(), ~0U);
    std::vector<Vec3> kept;
    for (auto& t : mesh.triangles)
        for (auto& v : t) {
            if (number[v] == ~0U) {
                number[v] = static_cast<std::uint32_t>(kept.size());
                kept.push_back(mesh.vertices[v]);
            }
            v = number[v];
        }
    mesh.vertices = std::move(kept);
}

// The part of a tetrahedron's level set, facing from what is positive to what is not.
void march(const std::array<std::uint32_t, 4>& corner, const std::vector<double>& value, Edges<Vec3>& edges,
           const std::vector<Vec3>& points, Mesh& out) {
    Corners in, off;
    for (const auto c : corner) (value[c] > 0 ? in : off).push_back(c);
    if (in.empty() || off.empty()) return;
    Corners loop;
    if (in.size() == 2)
        loop = {edges.cut(in[0], off[0]), edges.cut(in[0], off[1]), edges.cut(in[1], off[1]), edges.cut(in[1], off[0])};
    else
        for (const auto a : in)
            for (const auto b : off) loop.push_back(edges.cut(a, b));
    const Vec3 n = cross(points[loop[1]] - points[loop[0]], points[loop[2]] - points[loop[0]]);
    if (dot(n, points[off[0]] - points[in[0]]) < 0) std::reverse(loop.begin(), loop.end());
    for (std::size_t k = 2; k < loop.size(); ++k) out.triangles.push_back({loop[0], loop[k - 1], loop[k]});
}

// Splits some triangles in three; two of these are slivers.
void splinter(Mesh& mesh, Random& r) {
    const std::size_t n = mesh.triangles.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (!r.chance(0.2)) continue;
        const auto [a, b, c] = mesh.triangles[i];
        const double u = r.in(0.005, 0.03), v = r.in(0.005, 0.03);
        const auto m = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back((1 - u - v) * mesh.vertices[a] + u * mesh.vertices[b] + v * mesh.vertices[c]);
        mesh.triangles[i] = {a, b, m};
        mesh.triangles.push_back({b, c, m});
        mesh.triangles.push_back({c, a, m});
    }
}

} // namespace

void split_in_four(Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
    const auto between = [&](std::uint32_t a, std::uint32_t b) {
        const auto [it, fresh] = middle.insert({std::minmax(a, b), static_cast<std::uint32_t>(mesh.vertices.size())});
        if (fresh) mesh.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
        return it->second;
    };
    std::vector<mesh::Triangle> out;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto p = between(a, b), q = between(b, c), r = between(c, a);
        for (const mesh::Triangle& t : {mesh::Triangle{a, p, r}, {p, b, q}, {r, q, c}, {p, q, r}}) out.push_back(t);
    }
    mesh.triangles = std::move(out);
}

void shuffle(Mesh& mesh, Random& r) {
    std::vector<std::uint32_t> to(mesh.vertices.size());
    std::iota(to.begin(), to.end(), 0U);
    for (std::size_t i = to.size(); i > 1; --i) std::swap(to[i - 1], to[r.below(i)]);
    std::vector<Vec3> moved(to.size());
    for (std::size_t i = 0; i < to.size(); ++i) moved[to[i]] = mesh.vertices[i];
    mesh.vertices = std::move(moved);
    for (auto& t : mesh.triangles) {
        for (auto& v : t) v = to[v];
        std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(r.below(3)), t.end());
    }
    for (std::size_t i = mesh.triangles.size(); i > 1; --i)
        std::swap(mesh.triangles[i - 1], mesh.triangles[r.below(i)]);
}

Motion turned(Random& r) {
    const Vec3 x = r.direction(), side = cross(x, r.direction()), y = 1 / norm(side) * side;
    return {x, y, cross(x, y), {r.in(-100, 100), r.in(-100, 100), r.in(-100, 100)}};
}

Mesh sheet(Vec2 size, const Grid& grid, const Domain& inside, const Lift& lift, Random& r) {
    const auto n = std::max(1, static_cast<int>(std::round(size.x / grid.u))),
               m = std::max(1, static_cast<int>(std::round(size.y / grid.v)));
    std::vector<Vec2> points;
    std::vector<double> value;
    for (int j = 0; j <= m; ++j)
        for (int i = 0; i <= n; ++i) {
            const auto at = [&](int k, int all) {
                return k == 0 || k == all ? k : k + grid.jitter * r.in(-1, 1); // the border stays
            };
            points.push_back({size.x * at(i, n) / n, size.y * at(j, m) / m});
            value.push_back(inside(points.back()));
            // What lies on the border counts as inside, so that outlines along the grid are not cut.
            if (std::abs(value.back()) < 1e-9 * size.x) value.back() = 1e-12;
        }
    Edges<Vec2> edges(points, value);
    Mesh out;
    const auto add = [&](Corners corner) {
        Corners kept;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto a = corner[k], b = corner[(k + 1) % 3];
            if (value[a] > 0) kept.push_back(a);
            if ((value[a] > 0) != (value[b] > 0)) kept.push_back(edges.cut(a, b));
        }
        for (std::size_t k = 2; k < kept.size(); ++k) out.triangles.push_back({kept[0], kept[k - 1], kept[k]});
    };
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const auto a = static_cast<std::uint32_t>(j * (n + 1) + i), b = a + 1,
                       d = a + static_cast<std::uint32_t>(n) + 1, c = d + 1;
            add({a, b, c});
            add({a, c, d});
        }
    for (const Vec2& p : points) out.vertices.push_back(lift(p));
    drop_loose(out);
    return out;
}

Mesh level_set(Vec3 lo, Vec3 hi, double step, const std::function<double(const Vec3&)>& solid) {
    const auto count = [&](double a, double b) { return static_cast<std::uint32_t>(std::ceil((b - a) / step)); };
    const std::uint32_t nx = count(lo.x, hi.x), ny = count(lo.y, hi.y), nz = count(lo.z, hi.z);
    std::vector<Vec3> points;
    std::vector<double> value;
    for (std::uint32_t k = 0; k <= nz; ++k)
        for (std::uint32_t j = 0; j <= ny; ++j)
            for (std::uint32_t i = 0; i <= nx; ++i) {
                points.push_back({lo.x + i * step, lo.y + j * step, lo.z + k * step});
                value.push_back(solid(points.back()));
            }
    Edges<Vec3> edges(points, value);
    const auto at = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        return (k * (ny + 1) + j) * (nx + 1) + i;
    };
    constexpr std::uint32_t kPaths[6][3] = {{1, 3, 7}, {1, 5, 7}, {2, 3, 7}, {2, 6, 7}, {4, 5, 7}, {4, 6, 7}};
    Mesh out;
    for (std::uint32_t k = 0; k < nz; ++k)
        for (std::uint32_t j = 0; j < ny; ++j)
            for (std::uint32_t i = 0; i < nx; ++i)
                for (const auto& path : kPaths) { // of bits from corner 0 to corner 7 (Freudenthal, Kuhn)
                    std::array<std::uint32_t, 4> corner{at(i, j, k)};
                    for (std::size_t c = 0; c < 3; ++c)
                        corner[c + 1] = at(i + (path[c] & 1), j + (path[c] >> 1 & 1), k + (path[c] >> 2 & 1));
                    march(corner, value, edges, points, out);
                }
    out.vertices = std::move(points);
    drop_loose(out);
    return out;
}

std::string spoil(Mesh& mesh, Random& r) {
    std::string done;
    if (r.chance(0.15)) {
        coarsen(mesh);
        drop_loose(mesh);
        done += " coarse";
    }
    if (mesh.triangles.size() < 3000 && r.chance(0.15)) {
        split_in_four(mesh);
        done += " split";
    }
    if (r.chance(0.1)) {
        splinter(mesh, r);
        done += " splintered";
    }
    if (r.chance(0.3)) {
        shuffle(mesh, r);
        done += " shuffled";
    }
    if (r.chance(0.2)) {
        for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
        done += " flipped";
    }
    if (r.chance(0.5)) {
        const Motion motion = turned(r);
        for (Vec3& v : mesh.vertices) v = motion.point(v);
        done += " turned";
    }
    return done;
}

} // namespace filum::trials
