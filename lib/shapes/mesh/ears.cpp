#include "mesh/ears.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

namespace filum::mesh {

namespace {

using geom::Vec2;

constexpr std::uint32_t kNobody = ~std::uint32_t{0};
constexpr double kStraight = 1e-10;     // sine of an angle; below it three corners count as collinear
constexpr std::size_t kLeafCorners = 8; // most corners of a leaf

double doubled_area(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

// The corners of the polygon that are not convex, as a k-d tree (Bentley 1975). So the corners in a triangle are found
// without a look at distant ones.
class Reflex {
  public:
    Reflex(std::span<const Vec2> points, std::vector<std::uint32_t> corners)
        : points_(points), order_(std::move(corners)), leaf_(points.size(), kNobody) {
        if (!order_.empty()) build(0, order_.size(), kNobody);
    }

    void erase(std::uint32_t corner) {
        if (leaf_[corner] == kNobody) return;
        for (std::uint32_t n = leaf_[corner]; n != kNobody; n = nodes_[n].parent) --nodes_[n].left;
        leaf_[corner] = kNobody;
    }
    [[nodiscard]] bool holds(std::uint32_t corner) const { return leaf_[corner] != kNobody; }

    // The first corner inside the closed triangle for which `stops` is true.
    template <class Stops>
    std::uint32_t find(const std::array<Vec2, 3>& t, const Stops& stops) const {
        std::vector<std::uint32_t> open;
        if (!nodes_.empty()) open.push_back(0);
        while (!open.empty()) {
            const std::uint32_t at = open.back();
            const Node& n = nodes_[at];
            open.pop_back();
            if (n.left == 0 || beside(t, n)) continue;
            if (n.second != kNobody) {
                open.push_back(n.second);
                open.push_back(at + 1);
                continue;
            }
            for (std::size_t k = n.begin; k < n.end; ++k)
                if (leaf_[order_[k]] != kNobody && stops(order_[k])) return order_[k];
        }
        return kNobody;
    }

  private:
    struct Node {
        Vec2 lo, hi;
        std::size_t begin, end, left; // range of corners, and how many of them remain
        std::uint32_t parent, second; // node of the second half; the first half is the next node; none: a leaf
    };

    std::uint32_t build(std::size_t begin, std::size_t end, std::uint32_t parent) {
        const auto self = static_cast<std::uint32_t>(nodes_.size());
        Node n{points_[order_[begin]], points_[order_[begin]], begin, end, end - begin, parent, kNobody};
        for (std::size_t k = begin; k < end; ++k) {
            const Vec2 p = points_[order_[k]];
            n.lo = {std::min(n.lo.x, p.x), std::min(n.lo.y, p.y)};
            n.hi = {std::max(n.hi.x, p.x), std::max(n.hi.y, p.y)};
        }
        nodes_.push_back(n);
        if (end - begin <= kLeafCorners) {
            for (std::size_t k = begin; k < end; ++k) leaf_[order_[k]] = self;
            return self;
        }
        const std::size_t middle = (begin + end) / 2;
        const bool wide = n.hi.x - n.lo.x > n.hi.y - n.lo.y;
        const auto first = order_.begin();
        std::nth_element(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(middle),
                         first + static_cast<std::ptrdiff_t>(end), [&](std::uint32_t i, std::uint32_t j) {
                             const double a = wide ? points_[i].x : points_[i].y,
                                          b = wide ? points_[j].x : points_[j].y;
                             return a != b ? a < b : i < j;
                         });
        build(begin, middle, self);
        const std::uint32_t second = build(middle, end, self);
        nodes_[self].second = second;
        return self;
    }

    // True if the node lies beyond one side of the triangle.  Tests its box corner farthest along the inner normal.
    static bool beside(const std::array<Vec2, 3>& t, const Node& n) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 a = t[k], d = t[(k + 1) % 3] - a;
            const Vec2 p{d.y < 0 ? n.hi.x : n.lo.x, d.x > 0 ? n.hi.y : n.lo.y};
            if (cross(d, p - a) < -kStraight * dot(d, d)) return true;
        }
        return false;
    }

    std::span<const Vec2> points_;
    std::vector<std::uint32_t> order_, leaf_; // leaf_: per point its leaf, or kNobody
    std::vector<Node> nodes_;
};

class Clipping {
  public:
    explicit Clipping(std::span<const Vec2> points)
        : points_(points), next_(points.size()), last_(points.size()), version_(points.size(), 0),
          waiting_(points.size()), reflex_(points, link()) {}

    Ears run() {
        for (std::uint32_t i = 0; i < points_.size(); ++i) consider(i);
        std::size_t left = points_.size();
        for (; left > 3; --left) {
            const std::uint32_t ear = best();
            if (ear == kNobody) break;
            clip(ear);
        }
        finish(left);
        return std::move(out_);
    }

  private:
    struct Candidate {
        double shape;
        std::uint32_t corner, version;
        bool operator<(const Candidate& o) const { return shape != o.shape ? shape < o.shape : corner > o.corner; }
    };

    // Links the corners to a ring.  Returns the corners that are not convex.
    std::vector<std::uint32_t> link() {
        const auto n = static_cast<std::uint32_t>(points_.size());
        for (std::uint32_t i = 0; i < n; ++i) {
            next_[i] = (i + 1) % n;
            last_[i] = (i + n - 1) % n;
        }
        std::vector<std::uint32_t> out;
        for (std::uint32_t i = 0; i < n; ++i)
            if (!convex(i)) out.push_back(i);
        return out;
    }
    [[nodiscard]] bool convex(std::uint32_t i) const {
        const Vec2 a = points_[last_[i]], b = points_[i], c = points_[next_[i]];
        return doubled_area(a, b, c) > kStraight * norm(b - a) * norm(c - b);
    }
    // Quality of an ear: twice its area over its longest side squared; 0.87 for an equilateral triangle.
    [[nodiscard]] double shape(std::uint32_t i) const {
        const Vec2 a = points_[last_[i]], b = points_[i], c = points_[next_[i]];
        return doubled_area(a, b, c) / std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
    }
    void consider(std::uint32_t i) {
        ++version_[i];
        if (convex(i)) queue_.push({shape(i), i, version_[i]});
    }

    // True if corner p prevents the ear from being cut off. It does if it lies inside the triangle or on its border. It
    // also does if it coincides with a corner and has a side that leads into the triangle.
    [[nodiscard]] bool stops(std::uint32_t p, std::uint32_t ear) const {
        const std::uint32_t a = last_[ear], c = next_[ear];
        if (p == a || p == ear || p == c) return false;
        const std::array<Vec2, 3> t{points_[a], points_[ear], points_[c]};
        for (std::size_t k = 0; k < 3; ++k)
            if (points_[p] == t[k]) return leads_into(last_[p], t, k) || leads_into(next_[p], t, k);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 d = t[(k + 1) % 3] - t[k];
            if (cross(d, points_[p] - t[k]) < -kStraight * dot(d, d)) return false;
        }
        return true;
    }
    // True if the line from corner k of the triangle to q starts inside the triangle.
    [[nodiscard]] bool leads_into(std::uint32_t q, const std::array<Vec2, 3>& t, std::size_t k) const {
        const Vec2 p = t[k], to = points_[q] - p, on = t[(k + 1) % 3] - p, back = t[(k + 2) % 3] - p;
        return cross(on, to) > kStraight * norm(on) * norm(to) && cross(to, back) > kStraight * norm(to) * norm(back);
    }

    // The best shaped ear that can be cut off.  A blocked ear waits until the corner that blocks it has changed.
    std::uint32_t best() {
        while (!queue_.empty()) {
            const Candidate c = queue_.top();
            queue_.pop();
            if (c.version != version_[c.corner]) continue;
            const std::array<Vec2, 3> t{points_[last_[c.corner]], points_[c.corner], points_[next_[c.corner]]};
            const std::uint32_t stop = reflex_.find(t, [&](std::uint32_t p) { return stops(p, c.corner); });
            if (stop == kNobody) return c.corner;
            waiting_[stop].push_back(c.corner);
        }
        return kNobody;
    }

    void release(std::uint32_t corner) {
        reflex_.erase(corner);
        for (const std::uint32_t w : waiting_[corner])
            if (next_[w] != kNobody) consider(w);
        waiting_[corner].clear();
    }

    void clip(std::uint32_t ear) {
        const std::uint32_t a = last_[ear], c = next_[ear];
        out_.triangles.push_back({a, ear, c});
        next_[a] = c;
        last_[c] = a;
        next_[ear] = kNobody;
        release(ear);
        for (const std::uint32_t i : {a, c}) {
            if (reflex_.holds(i) && convex(i))
                release(i);
            else if (reflex_.holds(i))
                rouse(i);
            consider(i);
        }
    }
    // Releases the ears that a corner blocked, after its sides have changed.
    void rouse(std::uint32_t corner) {
        std::vector<std::uint32_t> waiting;
        waiting.swap(waiting_[corner]);
        for (const std::uint32_t w : waiting)
            if (next_[w] != kNobody) consider(w);
    }

    // Adds the rest: a triangle, or a fan if the rest is collinear or crosses itself. A triangle that faces the other
    // way shows that the polygon crosses itself, too.
    void finish(std::size_t left) {
        std::uint32_t first = 0;
        while (next_[first] == kNobody) ++first;
        double across = 0;
        for (std::uint32_t b = next_[first]; left > 2; --left, b = next_[b]) {
            out_.triangles.push_back({first, b, next_[b]});
            const Vec2 p = points_[first], q = points_[b], r = points_[next_[b]];
            const double area = doubled_area(p, q, r) / std::max({dot(q - p, q - p), dot(r - q, r - q), 1e-300});
            across = std::max(across, std::abs(area));
            if (area < -kStraight || (left > 3 && across > kStraight)) out_.sound = false;
        }
    }

    std::span<const Vec2> points_;
    std::vector<std::uint32_t> next_, last_; // links of the ring; next_ of a corner that was cut off is kNobody
    std::vector<std::uint32_t> version_;     // per corner: version of its ear
    std::vector<std::vector<std::uint32_t>> waiting_; // per corner: the ears that it blocks
    Reflex reflex_;
    std::priority_queue<Candidate> queue_;
    Ears out_;
};

} // namespace

Ears cut_ears(std::span<const Vec2> polygon) { return Clipping(polygon).run(); }

} // namespace filum::mesh
