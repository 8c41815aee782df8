#include "partition/lines.hpp"

#include "base/error.hpp"
#include "surface/curve/walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::partition {

namespace {

constexpr double kNear = 0.05; // share of an edge: a point nearer to a vertex is moved to it
constexpr double kFlat = 1e-9; // share of a triangle: a point nearer to an edge is moved onto it

// Draws lines into a mesh, splitting its triangles.
class LineInserter {
  public:
    LineInserter(Sheet& sheet, std::vector<char>& drawn) : sheet_(sheet), s_(sheet.surface), drawn_(drawn) {}

    // The vertex at the place nearest to `p`; it is inserted if necessary.
    std::uint32_t put(const Vec3& p, double& off) {
        const surface::Segment at = surface::nearest(s_, p);
        off = std::max(off, distance(at.a, p));
        const auto w = surface::curve::barycentric(s_, {at.triangle, at.a});
        const std::uint32_t h = 3 * at.triangle;
        for (std::uint32_t k = 0; k < 3; ++k)
            if (w[k] > 1 - kNear) return s_.tail(h + k);
        for (std::uint32_t k = 0; k < 3; ++k)
            if (w[(k + 2) % 3] < kFlat) return split(h + k, w[(k + 1) % 3] / (w[k] + w[(k + 1) % 3]));
        // Splits from the corner through the point to the opposite side, then on the new edge.
        const std::uint32_t corner = s_.tail(h + 2), across = split(h, w[1] / (w[0] + w[1]));
        return split(side(corner, across), w[0] + w[1]);
    }

    // Inserts the line from vertex to vertex; returns false if the surface ends on the way.
    bool go(std::uint32_t from, std::uint32_t to) {
        if (from == to) return true;
        const auto normals = [&](std::uint32_t v) {
            Vec3 sum;
            surface::each_outgoing(s_, v, [&](std::uint32_t h) { sum = sum + surface::normal(s_, h / 3); });
            return sum;
        };
        Vec3 heading = s_.vertices[to] - s_.vertices[from];
        upright_ = cross(heading, normals(from) + normals(to));
        foot_ = s_.vertices[from];
        if (!(norm(upright_) > 0)) return false;
        const std::size_t most = 4 * s_.triangles.size();
        for (std::size_t step = 0; step < most; ++step) {
            if (const std::uint32_t h = side(from, to); h != kNone) {
                mark(h);
                return true;
            }
            const std::uint32_t on = next(from, heading);
            if (on == kNone) return false;
            mark(side(from, on));
            heading = s_.vertices[on] - s_.vertices[from];
            from = on;
        }
        return false;
    }

  private:
    // The half-edge from a to b, or from b to a at a rim; kNone if they are not neighbours.
    [[nodiscard]] std::uint32_t side(std::uint32_t a, std::uint32_t b) const {
        std::uint32_t out = kNone;
        surface::each_outgoing(s_, a, [&](std::uint32_t h) {
            if (s_.head(h) == b) out = h;
            if (s_.tail(surface::prev(h)) == b && out == kNone) out = surface::prev(h);
        });
        return out;
    }

    void mark(std::uint32_t h) {
        drawn_[h] = 1;
        if (s_.twin[h] != kNone) drawn_[s_.twin[h]] = 1;
    }

    [[nodiscard]] double height(std::uint32_t v) const { return dot(upright_, s_.vertices[v] - foot_); }

    // The vertex on the opposite sides of the fan around `v` where the plane leaves it, in the direction nearest to
    // the heading.
    std::uint32_t next(std::uint32_t v, const Vec3& heading) {
        std::uint32_t best = kNone;
        double most = 0, share = 0;
        surface::each_outgoing(s_, v, [&](std::uint32_t h) {
            const std::uint32_t across = surface::next(h);
            const double a = height(s_.tail(across)), b = height(s_.head(across));
            if ((a < 0) == (b < 0) && a != 0 && b != 0) return;
            const double at = a == b ? 0 : a / (a - b);
            const Vec3 way = s_.vertices[s_.tail(across)] +
                             at * (s_.vertices[s_.head(across)] - s_.vertices[s_.tail(across)]) - s_.vertices[v];
            const double ahead = dot(way, heading) / (norm(way) * norm(heading));
            if (ahead > most) {
                most = ahead;
                best = across;
                share = at;
            }
        });
        if (best == kNone || share < kNear) return best == kNone ? kNone : s_.tail(best);
        return share > 1 - kNear ? s_.head(best) : split(best, share);
    }

    // Adds a triangle behind `h` in its triangle, from the new vertex w over the head of h to the third corner.
    std::uint32_t halve(std::uint32_t h, std::uint32_t w) {
        const auto fresh = static_cast<std::uint32_t>(s_.twin.size());
        const std::uint32_t after = surface::next(h), b = s_.head(h), c = s_.head(after), over = s_.twin[after];
        s_.triangles.push_back({w, b, c});
        s_.triangles[h / 3][after % 3] = w;
        s_.twin.insert(s_.twin.end(), {kNone, over, after});
        if (over != kNone) s_.twin[over] = fresh + 1;
        s_.twin[after] = fresh + 2;
        drawn_.insert(drawn_.end(), {drawn_[h], drawn_[after], 0});
        drawn_[after] = 0;
        if (s_.outgoing[b] == after) s_.outgoing[b] = fresh + 1;
        if (!sheet_.faces.empty()) sheet_.faces.push_back(sheet_.faces[h / 3]);
        return fresh;
    }

    // Inserts a vertex on the half-edge, connected to the opposite corners.
    std::uint32_t split(std::uint32_t h, double share) {
        const std::uint32_t a = s_.tail(h), b = s_.head(h), g = s_.twin[h];
        const auto w = static_cast<std::uint32_t>(s_.vertices.size());
        s_.vertices.push_back(s_.vertices[a] + share * (s_.vertices[b] - s_.vertices[a]));
        for (auto& f : sheet_.fields) append_between(f, a, b, share);
        const std::uint32_t behind = halve(h, w);
        s_.outgoing.push_back(behind);
        if (g != kNone) {
            const std::uint32_t other = halve(g, w);
            s_.twin[h] = other;
            s_.twin[other] = h;
            s_.twin[g] = behind;
            s_.twin[behind] = g;
        }
        return w;
    }

    Sheet& sheet_;
    Surface& s_;
    std::vector<char>& drawn_;
    Vec3 upright_, foot_;
};

} // namespace

double draw(Sheet& sheet, std::vector<char>& drawn, std::span<const Vec3> points) {
    drawn.resize(sheet.surface.twin.size(), 0);
    LineInserter pen(sheet, drawn);
    double off = 0;
    std::uint32_t before = pen.put(points[0], off);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const std::uint32_t here = pen.put(points[i], off);
        if (!pen.go(before, here))
            throw Error(Exit::bad_input, "cannot draw a line on the surface: it ends between points " +
                                             std::to_string(i) + " and " + std::to_string(i + 1) +
                                             "; add points between them");
        before = here;
    }
    auto& s = sheet.surface;
    s = surface::assemble(std::move(s.vertices), std::move(s.triangles), std::move(s.twin));
    sheet.isolines.clear();
    sheet.sources = {};
    return off;
}

void append_between(surface::Field& f, std::uint32_t a, std::uint32_t b, double share) {
    constexpr double far = std::numeric_limits<double>::infinity();
    if (f.components == 1) {
        const double x = f.values[a], y = f.values[b];
        f.values.push_back(std::isfinite(x) && std::isfinite(y) ? x + share * (y - x) : far);
        return;
    }
    const Vec3 x = f.vector(a), y = (dot(x, f.vector(b)) < 0 ? -1 : 1) * f.vector(b);
    const double length = (1 - share) * norm(x) + share * norm(y);
    const Vec3 sum = (1 - share) * x + share * y;
    const Vec3 v = !std::isfinite(length) ? Vec3{far, far, far} : (norm(sum) > 0 ? length / norm(sum) * sum : Vec3{});
    f.values.insert(f.values.end(), {v.x, v.y, v.z});
}

} // namespace filum::partition
