#include "collision/tree.hpp"

#include "kinematics/chain.hpp"

#include <algorithm>
#include <cmath>

namespace filum::collision {

namespace {

constexpr std::uint32_t kLeaf = 4;

Vec3 centre(const Solid& s) { return 0.25 * (s.corner[0] + s.corner[1] + s.corner[2] + s.corner[3]); }

// Extent of a box from its middle along the unit vector d.
double extent(const Vec3& half, const Vec3& d) {
    return half.x * std::abs(d.x) + half.y * std::abs(d.y) + half.z * std::abs(d.z);
}

Frame frame(const ToolFrame& s) {
    Vec3 x = s.side - dot(s.side, s.axis) * s.axis;
    if (dot(x, x) < 1e-12) { // any side, as the carriage is round
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
    for (std::size_t i = 0; i < n; ++i) {
        p[i].z = dot(s.corner[i] - f.tip, f.z);
        top = std::max(top, p[i].z);
    }
    if (top <= low) return;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 d = s.corner[i] - f.tip;
        p[i].x = dot(d, f.x);
        p[i].y = dot(d, f.y);
    }
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 &a = p[i], &b = p[(i + 1) % n];
        if (a.z > low) out.add(a);
        if ((a.z > low) != (b.z > low)) out.add(a + ((low - a.z) / (b.z - a.z)) * (b - a));
    }
}

// The part of the hull of `points` above `low`.
void clip(std::span<const Vec3> points, double low, Corners& out) {
    out.count = 0;
    for (const Vec3& a : points) {
        if (!(a.z > low)) continue;
        out.add(a);
        for (const Vec3& b : points)
            if (!(b.z > low)) out.add(a + ((low - a.z) / (b.z - a.z)) * (b - a));
    }
}

// A lower bound on the distance of the polygon from the head.
double at_least(const Shape& shape, const Corners& polygon) {
    double top = polygon.point[0].z, x0 = polygon.point[0].x, x1 = x0, y0 = polygon.point[0].y, y1 = y0;
    for (const Vec3& p : polygon.all()) {
        top = std::max(top, p.z);
        x0 = std::min(x0, p.x);
        x1 = std::max(x1, p.x);
        y0 = std::min(y0, p.y);
        y1 = std::max(y1, p.y);
    }
    const double x = std::max({0.0, x0, -x1}), y = std::max({0.0, y0, -y1});
    return shape.at_least(std::sqrt(x * x + y * y), top);
}

} // namespace

Solid bead(const ToolFrame& from, const ToolFrame& to, double width, double height, std::uint32_t born) {
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
    for (const Solid& s : solids_) deepest_ = std::max(deepest_, s.radius);
    nodes_.reserve(solids_.size());
    build(0, static_cast<std::uint32_t>(solids_.size()));
}

// Computes the bounds of a node from the corners of its solids, given its box.
void Tree::bound(Node& node, std::uint32_t first, std::uint32_t last) const {
    Vec3 sum{};
    for (std::uint32_t i = first; i < last; ++i) {
        const auto& c = solids_[i].corner;
        sum = sum + cross(c[2] - c[0], c[3] == c[2] ? c[1] - c[0] : c[3] - c[1]);
    }
    const double l = norm(sum);
    node.normal = l > 0 ? (1 / l) * sum : Vec3{0, 0, 1};
    for (std::uint32_t i = first; i < last; ++i) {
        const Solid& s = solids_[i];
        for (const Vec3& p : s.corner) {
            const Vec3 d = p - node.middle;
            const double up = dot(d, node.normal), all = dot(d, d), across = std::sqrt(std::max(0.0, all - up * up));
            node.thick = std::max(node.thick, std::abs(up) + s.radius);
            node.flat = std::max(node.flat, across + s.radius);
            node.ball = std::max(node.ball, std::sqrt(all) + s.radius);
        }
    }
}

// Whether later solids are above or below earlier ones by a considerable part of the total thickness.
bool Tree::layered(const Node& node, std::uint32_t first, std::uint32_t last) const {
    constexpr double kPart = 0.25;
    double age = 0;
    for (std::uint32_t i = first; i < last; ++i) age += solids_[i].born;
    age /= last - first;
    std::array<double, 2> height{}, count{};
    for (std::uint32_t i = first; i < last; ++i) {
        const std::size_t later = solids_[i].born > age ? 1 : 0;
        height[later] += dot(centre(solids_[i]), node.normal);
        count[later] += 1;
    }
    if (count[0] == 0 || count[1] == 0) return false;
    return std::abs(height[1] / count[1] - height[0] / count[0]) > kPart * 2 * node.thick;
}

// Halves the solids by number: layers by age, so that solids of the future do not enlarge boxes of present ones;
// others along the longest side of the box of centres. Ties: the older first.
std::uint32_t Tree::build(std::uint32_t first, std::uint32_t last) {
    const auto at = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    geom::Box3 all, centres;
    std::uint32_t born = solids_[first].born;
    for (std::uint32_t i = first; i < last; ++i) {
        const Solid& s = solids_[i];
        for (const Vec3& p : s.corner) all.add(geom::grown({p, p}, s.radius));
        centres.add(centre(s));
        born = std::min(born, s.born);
    }
    Node node;
    node.middle = 0.5 * (all.lo + all.hi);
    node.half = 0.5 * all.size();
    node.born = born;
    node.first = first;
    node.count = last - first;
    bound(node, first, last);
    if (last - first > kLeaf) {
        const bool by_age = layered(node, first, last);
        const int axis = geom::longest_axis(centres.size());
        const std::uint32_t half = first + (last - first) / 2;
        const auto begin = solids_.begin();
        std::nth_element(begin + first, begin + half, begin + last, [&](const Solid& a, const Solid& b) {
            const double u = coordinate(centre(a), axis), v = coordinate(centre(b), axis);
            return !by_age && u != v ? u < v : a.born < b.born;
        });
        build(first, half);
        node.first = build(half, last);
        node.count = 0;
    }
    nodes_[at] = node;
    return at;
}

// Extent of a node from its middle along the unit vector d.
double Tree::Node::reach(const Vec3& d) const {
    const double lean = dot(normal, d);
    return std::min(extent(half, d), std::abs(lean) * thick + std::sqrt(std::max(0.0, 1 - lean * lean)) * flat);
}

// The frame of `to`, rotated from `from` by the shortest way.
Frame carried(const Frame& from, const ToolFrame& to) {
    const Vec3 turn = cross(from.z, to.axis);
    const double c = dot(from.z, to.axis);
    Vec3 x = from.x + cross(turn, from.x);
    if (c > -0.999) x = x + (1 / (1 + c)) * cross(turn, cross(turn, from.x));
    x = x - dot(x, to.axis) * to.axis;
    return {to.tip, (1 / norm(x)) * x, cross(to.axis, (1 / norm(x)) * x), to.axis};
}

// The solids as seen from a head during a sweep. In the head's frame a solid moves almost straight: it deviates from
// the line between its end positions by at most an eighth of its acceleration, which is twice the tip's speed times
// the rotation, plus the squared rotation times the solid's distance.
class Tree::View {
  public:
    View(const Shape& shape, const Probe& probe, const Sweep* sweep)
        : shape_(shape), p_(probe), middle_(frame(probe.stance)), round_(probe.stance.side == Vec3{}), a_(middle_),
          b_(middle_) {
        if (sweep == nullptr) return;
        moves_ = true;
        a_ = frame(sweep->from);
        b_ = round_ ? carried(a_, sweep->to) : frame(sweep->to);
        // Axis and side rotate independently; twice the side's angle covers the effect on the frame.
        const double turn = geom::angle(a_.z, b_.z) + (round_ ? 0 : 2 * geom::angle(a_.x, b_.x));
        stray_ = sweep->stray + turn * distance(a_.tip, b_.tip) / 4;
        lean_ = sweep->lean + turn * turn / 8;
        wild_ = turn > 1;
    }

    // Bounds for a node: least distance, distance of its farthest point (mm), and movement of points of the head
    // nearer than the cutoff.
    struct Bounds {
        double least = 0, far = 0, allowance = 0;
    };

    // False if nothing in the node needs to be checked.
    bool may(const Node& node, double cutoff, Bounds& out) const {
        if (node.born >= p_.before) return false;
        const Vec3 d = node.middle - a_.tip;
        const double z = dot(d, a_.z), square = dot(d, d);
        double top = z + node.reach(a_.z), off, beside = 0;
        if (moves_) {
            const Vec3 e = node.middle - b_.tip;
            top = std::max(top, dot(e, b_.z) + node.reach(b_.z));
            off = from_origin({dot(d, a_.x), dot(d, a_.y)}, {dot(e, b_.x), dot(e, b_.y)});
            out.far = std::sqrt(std::max(square, dot(e, e))) + node.ball + stray_;
            beside = stray_ + lean_ * out.far;
        } else {
            off = std::sqrt(std::max(0.0, square - z * z));
            out.far = std::sqrt(square) + node.ball;
        }
        out.allowance = p_.shift;
        if (p_.turn > 0) out.allowance += p_.turn * (out.far + p_.shift + std::max(0.0, cutoff));
        if (wild_) return true;
        if (top + beside <= p_.press) return false;
        // The head only widens upwards, so a point that is lower and farther from the axis has a greater distance.
        out.least = shape_.at_least(std::max(0.0, off - node.ball - beside), top + beside);
        return !(out.least > 0 && out.least >= cutoff);
    }

    // Whether the solid may come nearer than the cutoff on the way. `out` is the distance at the probe's stance or,
    // for sweeps, a lower bound.
    bool meets(const Solid& s, const Bounds& b, double cutoff, Shape::NearestPiece& out) {
        const bool straight = moves_ && !wild_;
        const double beside = straight ? stray_ + lean_ * b.far : b.allowance, most = cutoff + beside + s.radius;
        if (s.born >= p_.before || most <= 0) return false;
        if (straight)
            along(s, p_.press - s.radius - beside);
        else
            clip(s, middle_, p_.press - p_.sink - p_.turn * (b.far + p_.shift) - s.radius, corners_);
        if (corners_.count == 0 || at_least(shape_, corners_) >= most) return false;
        out = shape_.nearest(corners_.all(), round_, most);
        out.distance -= s.radius;
        return out.distance < cutoff + beside;
    }

  private:
    // Distance from the origin to the segment from p to q.
    static double from_origin(geom::Vec2 p, geom::Vec2 q) {
        const geom::Vec2 way = q - p;
        const double l = norm2(way), share = l > 0 ? std::clamp(-dot(p, way) / l, 0.0, 1.0) : 0;
        return norm(p + share * way);
    }

    // Sets the region that the solid's polygon sweeps above `low`, between its positions at both ends.
    void along(const Solid& s, double low) {
        const std::size_t n = s.corner[2] == s.corner[3] ? 3 : 4;
        std::array<Vec3, 8> points;
        for (std::size_t i = 0; i < n; ++i) {
            points[i] = a_(s.corner[i]);
            points[n + i] = b_(s.corner[i]);
        }
        clip({points.data(), 2 * n}, low, corners_);
    }

    const Shape& shape_;
    const Probe& p_;
    const Frame middle_;
    const bool round_;
    bool moves_ = false, wild_ = false; // wild_: it rotates so far that only the probe's bounds hold
    Frame a_, b_;
    double stray_ = 0, lean_ = 0;
    Corners corners_;
};

// Calls meet(distance, piece, allowance) for every solid that may be nearer than `cutoff`; the allowance is the
// movement that the probe's bounds permit. Stops when meet() returns true. Skips nodes for which skip(allowance) is
// true.
template <class Skip, class Meet>
void Tree::visit(View& view, const double& cutoff, const Skip& skip, const Meet& meet) const {
    struct PendingNode {
        std::uint32_t node = 0;
        View::Bounds bounds;
    };
    std::array<PendingNode, 64> stack;
    std::size_t left = 0;
    if (!nodes_.empty() && view.may(nodes_[0], cutoff, stack[0].bounds)) left = 1;
    while (left > 0) {
        const auto [at, bounds] = stack[--left];
        // The cutoff may have decreased.
        if (skip(bounds.allowance) || (bounds.least > 0 && bounds.least >= cutoff)) continue;
        const Node& node = nodes_[at];
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            Shape::NearestPiece near;
            if (view.meets(solids_[i], bounds, cutoff, near) && meet(near.distance, near.piece, bounds.allowance))
                return;
        }
        if (node.count > 0) continue;
        PendingNode a{at + 1, {}}, b{node.first, {}};
        const bool left_one = view.may(nodes_[a.node], cutoff, a.bounds);
        const bool right_one = view.may(nodes_[b.node], cutoff, b.bounds);
        const bool turned = a.bounds.least > b.bounds.least; // the nearer child first
        if (left_one && turned) stack[left++] = a;
        if (right_one) stack[left++] = b;
        if (left_one && !turned) stack[left++] = a;
    }
}

Tree::Hit Tree::nearest(const Shape& shape, const Probe& probe) const {
    Hit hit{probe.cutoff, HeadPiece::nozzle, false};
    if (shape.none()) return hit;
    View view(shape, probe, nullptr);
    const auto none = [](double) { return false; };
    visit(view, hit.distance, none, [&](double d, HeadPiece piece, double) {
        hit = {d, piece, true};
        return d <= -deepest_;
    });
    return hit;
}

Tree::Proximity Tree::any(const Shape& shape, const Probe& probe, const Sweep& sweep, double step) const {
    Proximity found = Proximity::nothing;
    if (shape.none()) return found;
    View view(shape, probe, &sweep);
    const auto told = [&](double allowance) { return found == Proximity::steady && 2 * allowance <= step; };
    visit(view, probe.cutoff, told, [&](double, HeadPiece, double allowance) {
        found = 2 * allowance <= step ? Proximity::steady : Proximity::moving;
        return found == Proximity::moving;
    });
    return found;
}

} // namespace filum::collision
