#include "collision/tree.hpp"

#include <algorithm>
#include <cmath>

namespace filum::collision {

namespace {

constexpr std::uint32_t kLeaf = 4;

double along(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

Vec3 least(const Vec3& a, const Vec3& b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3 most(const Vec3& a, const Vec3& b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

Vec3 centre(const Solid& s) { return 0.25 * (s.corner[0] + s.corner[1] + s.corner[2] + s.corner[3]); }

// How far from its middle a box reaches along the unit vector d.
double extent(const Vec3& half, const Vec3& d) {
    return half.x * std::abs(d.x) + half.y * std::abs(d.y) + half.z * std::abs(d.z);
}

struct Frame {
    Vec3 tip, x, y, z;
};

Frame frame(const Stance& s) {
    Vec3 x = s.side - dot(s.side, s.axis) * s.axis;
    if (dot(x, x) < 1e-12) { // any side will do: the carriage is round
        const Vec3 other = std::abs(s.axis.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        x = other - dot(other, s.axis) * s.axis;
    }
    x = (1 / norm(x)) * x;
    return {s.tip, x, cross(s.axis, x), s.axis};
}

// The part of the solid's polygon above `low`, in the head's frame.
void clip(const Solid& s, const Frame& f, double low, Corners& out) {
    std::array<Vec3, 4> p;
    const std::size_t n = s.corner[2] == s.corner[3] ? 3 : 4;
    out.count = 0;
    double top = low;
    for (std::size_t i = 0; i < n; ++i) p[i].z = dot(s.corner[i] - f.tip, f.z), top = std::max(top, p[i].z);
    if (top <= low) return;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 d = s.corner[i] - f.tip;
        p[i].x = dot(d, f.x), p[i].y = dot(d, f.y);
    }
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 &a = p[i], &b = p[(i + 1) % n];
        if (a.z > low) out.add(a);
        if ((a.z > low) != (b.z > low)) out.add(a + ((low - a.z) / (b.z - a.z)) * (b - a));
    }
}

// No more than the distance of the polygon from the head.
double at_least(const Shape& shape, const Corners& polygon) {
    double top = polygon.point[0].z, x0 = polygon.point[0].x, x1 = x0, y0 = polygon.point[0].y, y1 = y0;
    for (const Vec3& p : polygon.all()) {
        top = std::max(top, p.z);
        x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
        y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
    }
    const double x = std::max({0.0, x0, -x1}), y = std::max({0.0, y0, -y1});
    return shape.at_least(std::sqrt(x * x + y * y), top);
}

} // namespace

Solid bead(const Stance& from, const Stance& to, double width, double height, std::uint32_t born) {
    const Vec3 way = to.tip - from.tip;
    const auto aside = [&](const Vec3& axis) {
        const Vec3 side = cross(axis, way);
        const double l = norm(side);
        return l > 0 ? (std::max(0.0, width - height) / 2 / l) * side : Vec3{};
    };
    const Vec3 a = from.tip - (height / 2) * from.axis, b = to.tip - (height / 2) * to.axis;
    const Vec3 p = aside(from.axis), q = aside(to.axis);
    return {{a - p, a + p, b + q, b - q}, height / 2, born};
}

void add(const mesh::Mesh& mesh, std::vector<Solid>& to) {
    to.reserve(to.size() + mesh.triangles.size());
    for (const auto& t : mesh.triangles)
        to.push_back({{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]], mesh.vertices[t[2]]}, 0, 0});
}

Tree::Tree(std::vector<Solid> solids) : solids_(std::move(solids)) {
    if (solids_.empty()) return;
    nodes_.reserve(solids_.size());
    build(0, static_cast<std::uint32_t>(solids_.size()));
}

// Halved by number along the longest side of the box of centres; ties: the older first.
std::uint32_t Tree::build(std::uint32_t first, std::uint32_t last) {
    const auto at = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    constexpr double inf = std::numeric_limits<double>::infinity();
    Vec3 lo{inf, inf, inf}, hi = -1 * lo, low = lo, high = hi; // of all, of centres
    std::uint32_t born = solids_[first].born;
    for (std::uint32_t i = first; i < last; ++i) {
        const Solid& s = solids_[i];
        const Vec3 r{s.radius, s.radius, s.radius};
        for (const Vec3& p : s.corner) lo = least(lo, p - r), hi = most(hi, p + r);
        const Vec3 c = centre(s);
        low = least(low, c), high = most(high, c);
        born = std::min(born, s.born);
    }
    const Vec3 extents = 0.5 * (hi - lo);
    Node node{0.5 * (lo + hi), extents, norm(extents), born, first, last - first};
    if (last - first > kLeaf) {
        const Vec3 size = high - low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::uint32_t half = first + (last - first) / 2;
        const auto begin = solids_.begin();
        std::nth_element(begin + first, begin + half, begin + last, [&](const Solid& a, const Solid& b) {
            const double u = along(centre(a), axis), v = along(centre(b), axis);
            return u != v ? u < v : a.born < b.born;
        });
        build(first, half);
        node.first = build(half, last), node.count = 0;
    }
    nodes_[at] = node;
    return at;
}

// Calls meet(distance, piece, allowance) for whatever may be nearer than `cutoff` + allowance, where the allowance is
// what the probe's bounds can bring it nearer; stops once that is true.  Boxes of which skip(allowance) is true are
// left out.
template <class Skip, class Meet>
void Tree::visit(const Shape& shape, const Probe& probe, const double& cutoff, const Skip& skip,
                 const Meet& meet) const {
    if (nodes_.empty() || shape.none()) return;
    const Frame f = frame(probe.stance);
    const bool round = probe.stance.side == Vec3{};
    std::array<std::uint32_t, 64> stack;
    stack[0] = 0;
    std::size_t left = 1;
    Corners corners;
    while (left > 0) {
        const Node& node = nodes_[stack[--left]];
        if (node.born >= probe.before) continue;
        const Vec3 d = node.middle - f.tip;
        const double far = norm(d) + node.ball + probe.shift;
        const double low = probe.press - probe.sink - probe.turn * far;
        const double z = dot(d, f.z), top = z + extent(node.half, f.z);
        if (top <= low) continue;
        const double x = dot(d, f.x), y = dot(d, f.y), off = std::sqrt(x * x + y * y);
        const double allowance = probe.shift + (probe.turn > 0 ? probe.turn * (far + std::max(0.0, cutoff)) : 0);
        if (skip(allowance)) continue;
        const double limit = cutoff + allowance;
        // the head only widens upwards, so what is lower and farther from the axis is farther from it
        const double box = shape.at_least(std::max(0.0, off - node.ball), top);
        if (box > 0 && box >= limit) continue;
        if (shape.at_least(off, z) - node.ball >= limit) continue;
        if (node.count == 0) {
            stack[left++] = node.first;
            stack[left++] = static_cast<std::uint32_t>(&node - nodes_.data()) + 1;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const Solid& s = solids_[i];
            const double most = cutoff + allowance + s.radius; // the cutoff may have come down
            if (s.born >= probe.before || most <= 0) continue;
            clip(s, f, low - s.radius, corners);
            if (corners.count == 0 || at_least(shape, corners) >= most) continue;
            const auto near = shape.nearest(corners.all(), round, most);
            if (near.distance < most && meet(near.distance - s.radius, near.piece, allowance)) return;
        }
    }
}

Tree::Hit Tree::nearest(const Shape& shape, const Probe& probe) const {
    Hit hit{probe.cutoff, Piece::nozzle, false};
    const auto none = [](double) { return false; };
    visit(shape, probe, hit.distance, none, [&](double d, Piece piece, double) {
        hit = {d, piece, true};
        return false;
    });
    return hit;
}

Tree::Near Tree::any(const Shape& shape, const Probe& probe, double step) const {
    Near found = Near::nothing;
    const auto told = [&](double allowance) { return found == Near::steady && 2 * allowance <= step; };
    visit(shape, probe, probe.cutoff, told, [&](double, Piece, double allowance) {
        found = 2 * allowance <= step ? Near::steady : Near::moving;
        return found == Near::moving;
    });
    return found;
}

} // namespace filum::collision
