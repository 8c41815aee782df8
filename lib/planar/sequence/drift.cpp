#include "sequence/drift.hpp"

#include "geom/segment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::sequence {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();
bool same_loops(const polygon::Loops& a, const polygon::Loops& b) { return a.start == b.start && a.points == b.points; }

// The middle of the area inside a loop, and the square root of this area. Neither depends on how the loop is turned or
// where its vertices are. Without an area, the middle of its box.
struct Size {
    geom::Vec2 middle;
    double side = 0; // mm
};

Size size(std::span<const geom::Vec2> loop) {
    geom::Vec2 sum;
    double area = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const geom::Vec2 p = loop[k] - loop[0], q = loop[k + 1 < loop.size() ? k + 1 : 0] - loop[0];
        const double twice = geom::cross(p, q);
        area += twice / 2;
        sum = sum + twice / 6 * (p + q);
    }
    const geom::Box2 box = polygon::bounds(loop);
    const geom::Vec2 middle = loop[0] + 1 / area * sum;
    const bool inside = middle.x >= box.lo.x && middle.x <= box.hi.x && middle.y >= box.lo.y && middle.y <= box.hi.y;
    if (!(area > 0) || !inside) return {0.5 * (box.lo + box.hi), 0};
    return {middle, std::sqrt(area)};
}

// A point that walks once round a loop, from a point of one of its edges, always ahead on the edge up to `next`.
class Walker {
  public:
    Walker(std::span<const geom::Vec2> loop, std::size_t edge, geom::Vec2 at)
        : loop_(loop), first_(at), at_(at), next_(edge + 1), left_(loop.size() + 1) {}
    [[nodiscard]] bool arrived() const { return left_ == 0; }
    [[nodiscard]] geom::Vec2 at() const { return at_; }
    [[nodiscard]] geom::Vec2 next() const {
        return left_ == 0 ? at_ : left_ == 1 ? first_ : loop_[next_ < loop_.size() ? next_ : next_ - loop_.size()];
    }
    [[nodiscard]] geom::Vec2 nearest(geom::Vec2 p) const { return geom::nearest_point(at_, next(), p); }
    void move(geom::Vec2 to) { at_ = to; } // on the edge
    void pass() {                          // to the edge's end
        at_ = next();
        ++next_;
        --left_;
    }

  private:
    std::span<const geom::Vec2> loop_;
    geom::Vec2 first_, at_;
    std::size_t next_, left_;
};

// A walker on `loop` that begins at the point nearest to `p`.
Walker walker(std::span<const geom::Vec2> loop, geom::Vec2 p) {
    std::size_t edge = 0;
    geom::Vec2 at = loop[0];
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const geom::Vec2 q = geom::nearest_point(loop[k], loop[k + 1 < loop.size() ? k + 1 : 0], p);
        if (geom::norm2(q - p) < geom::norm2(at - p)) {
            at = q;
            edge = k;
        }
    }
    return {loop, edge, at};
}

// The greatest distance of two walkers round the loops, after `a` was scaled and shifted. At each step one of them
// passes the next vertex, the one that stays nearer to the other; both move evenly, so the distance is greatest at the
// ends of steps. Every such walk bounds the movement (Frechet's distance is the least of them).
double walk(std::span<const geom::Vec2> original, const Movement& by, std::span<const geom::Vec2> b) {
    std::vector<geom::Vec2> a(original.size());
    for (std::size_t k = 0; k < a.size(); ++k) a[k] = by.scale * original[k] + by.shift;
    Walker of_a(a, 0, a[0]), of_b = walker(b, a[0]);
    double worst = geom::norm2(a[0] - of_b.at());
    while (!of_a.arrived() || !of_b.arrived()) {
        const geom::Vec2 pa = of_a.next(), near_a = of_b.nearest(pa);
        const geom::Vec2 pb = of_b.next(), near_b = of_a.nearest(pb);
        const double by_a = geom::norm2(pa - near_a), by_b = geom::norm2(near_b - pb);
        if (of_b.arrived() || (!of_a.arrived() && by_a <= by_b)) {
            of_a.pass();
            of_b.move(near_a);
            worst = std::max(worst, by_a);
        } else {
            of_b.pass();
            of_a.move(near_b);
            worst = std::max(worst, by_b);
        }
    }
    return std::sqrt(worst);
}

// The movement over `first`, then `second`; its rest is that of `first` alone.
Movement then(const Movement& first, const Movement& second) {
    return {second.scale * first.scale, second.scale * first.shift + second.shift, first.rest};
}

// The movement from where `from` leads to where `to` leads, both from the same foot.
Movement across(const Movement& from, const Movement& to, double rest) {
    const double scale = to.scale / from.scale;
    return {scale, to.shift - scale * from.shift, rest};
}

// The way of a point of the box under the movement, mm, at most.
double way(const Movement& m, geom::Vec2 middle, double radius) {
    return geom::norm((m.scale - 1) * middle + m.shift) + std::abs(m.scale - 1) * radius;
}

} // namespace

// The scale is that of the outer loops' areas, the shift that of their middles, so that the rest is small. Holes need
// not grow with it: a cone's wall keeps its thickness.
Movement movement(const polygon::Loops& a, const polygon::Loops& b) {
    if (same_loops(a, b)) return {};
    if (a.size() != b.size() || a.size() == 0) return {1, {}, kUnknown};
    for (std::size_t l = 0; l < a.size(); ++l)
        if (a[l].empty() || b[l].empty()) return {1, {}, kUnknown};
    const Size before = size(a[0]), after = size(b[0]);
    Movement out;
    if (before.side > 0 && after.side > 0) out.scale = after.side / before.side;
    out.shift = after.middle - out.scale * before.middle;
    for (std::size_t l = 0; l < a.size(); ++l) out.rest = std::max(out.rest, walk(a[l], out, b[l]));
    return out;
}

Movement Drift::movement(std::size_t i, std::size_t k) const {
    if (!known(i, k)) return {1, {}, kUnknown};
    const double by_sum = summed[k].scale * std::abs(summed[k].rest - summed[i].rest);
    const double by_foot = i == k ? 0 : from_foot[k].rest + from_foot[k].scale / from_foot[i].scale * from_foot[i].rest;
    if (by_foot < by_sum) return across(from_foot[i], from_foot[k], by_foot);
    return across(summed[i], summed[k], by_sum);
}

double Drift::between(std::size_t i, std::size_t k) const {
    return known(i, k) ? std::abs(length[k] - length[i]) : kUnknown;
}

// Let P be the movement of a, Q that of c, without their rests. The distance between P(A) and Q(C) differs from that
// between Q(A) and Q(C), which is that of A and C times Q's scale, by at most the distance between P(x) and Q(x) for a
// point x of A. The same holds with A and C exchanged.
Bounds relative(const Drift& a, std::size_t i, std::size_t k, const Drift& c, std::size_t m, std::size_t n, Bounds d) {
    const Movement p = a.movement(i, k), q = c.movement(m, n);
    const double rest = p.rest + q.rest;
    if (!(rest < kUnknown)) return {-kUnknown, kUnknown};
    const geom::Vec2 shift = p.shift - q.shift;
    const double scale = p.scale - q.scale;
    const double at_a = geom::norm(scale * a.middle[i] + shift) + std::abs(scale) * a.radius[i];
    const double at_c = geom::norm(scale * c.middle[m] + shift) + std::abs(scale) * c.radius[m];
    return {std::max(q.scale * d.least - at_a, p.scale * d.least - at_c) - rest,
            std::min(q.scale * d.most + at_a, p.scale * d.most + at_c) + rest};
}

bool Drift::alone(std::size_t i) const {
    return (i == 0 || stretch[i - 1] != stretch[i]) && (i + 1 == stretch.size() || stretch[i + 1] != stretch[i]);
}

Drift drift(std::span<const Index> column, const std::vector<Outline>& outlines) {
    Drift out;
    std::size_t foot = 0; // of the stretch
    for (std::size_t i = 0; i < column.size(); ++i) {
        const geom::Box2& box = outlines[column[i]].box;
        out.middle.push_back(0.5 * (box.lo + box.hi));
        out.radius.push_back(0.5 * geom::norm(box.hi - box.lo));
        const auto loops = [&](std::size_t place) -> const polygon::Loops& { return outlines[column[place]].loops; };
        Movement by{1, {}, kUnknown};
        if (i > 0) by = movement(loops(i - 1), loops(i));
        if (!(by.rest < kUnknown)) { // a new stretch
            foot = i;
            out.summed.emplace_back();
            out.from_foot.emplace_back();
            out.length.push_back(i > 0 ? out.length.back() : 0);
            out.stretch.push_back(i > 0 ? out.stretch.back() + 1 : 0);
            continue;
        }
        out.summed.push_back(then(out.summed.back(), by));
        out.summed.back().rest += by.rest / out.summed.back().scale;
        out.length.push_back(out.length.back() + way(by, out.middle[i - 1], out.radius[i - 1]) + by.rest);
        out.from_foot.push_back(same_loops(loops(i - 1), loops(i)) ? out.from_foot.back()
                                                                   : movement(loops(foot), loops(i)));
        out.stretch.push_back(out.stretch.back());
    }
    return out;
}

Drift shifted(Drift d, geom::Vec2 way) {
    for (auto* movements : {&d.summed, &d.from_foot})
        for (Movement& m : *movements) m.shift = m.shift + (1 - m.scale) * way;
    for (geom::Vec2& p : d.middle) p = p + way;
    return d;
}

std::size_t RegionDistances::at(long d) const {
    const auto less = [](const RegionDistance& x, long wanted) { return difference(x.i, x.k) < wanted; };
    return static_cast<std::size_t>(std::lower_bound(all_.begin(), all_.end(), d, less) - all_.begin());
}

void RegionDistances::add(const RegionDistance& d) {
    latest_ = at(difference(d.i, d.k));
    const auto place = all_.begin() + static_cast<long>(latest_);
    if (place != all_.end() && difference(place->i, place->k) == difference(d.i, d.k))
        *place = d;
    else
        all_.insert(place, d);
}

} // namespace filum::sequence
