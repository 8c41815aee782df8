#include "sequence/drift.hpp"

#include "geom/segment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::sequence {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();
bool same_loops(const polygon::Loops& a, const polygon::Loops& b) { return a.start == b.start && a.points == b.points; }

geom::Vec2 centre(std::span<const geom::Vec2> loop) {
    const geom::Box2 b = polygon::bounds(loop);
    return 0.5 * (b.lo + b.hi);
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

// The greatest distance of two walkers round the loops, after `a` was shifted. At each step one of them passes the
// next vertex, the one that stays nearer to the other; both move evenly, so the distance is greatest at the ends of
// steps. Every such walk bounds the movement (Frechet's distance is the least of them).
double walk(std::span<const geom::Vec2> a, geom::Vec2 shift, std::span<const geom::Vec2> b) {
    Walker of_a(a, 0, a[0]), of_b = walker(b, a[0] + shift);
    double worst = geom::norm2(a[0] + shift - of_b.at());
    while (!of_a.arrived() || !of_b.arrived()) {
        const geom::Vec2 pa = of_a.next() + shift, near_a = of_b.nearest(pa);
        const geom::Vec2 pb = of_b.next(), near_b = of_a.nearest(pb - shift);
        const double by_a = geom::norm2(pa - near_a), by_b = geom::norm2(near_b + shift - pb);
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

} // namespace

// The shift is that of the middle of the outer loop's box, so that the rest is small.
Movement movement(const polygon::Loops& a, const polygon::Loops& b) {
    if (same_loops(a, b)) return {};
    if (a.size() != b.size() || a.size() == 0) return {{}, kUnknown};
    Movement out{centre(b[0]) - centre(a[0]), 0};
    for (std::size_t l = 0; l < a.size(); ++l) {
        if (a[l].empty() || b[l].empty()) return {{}, kUnknown};
        out.rest = std::max(out.rest, walk(a[l], out.shift, b[l]));
    }
    return out;
}

Movement Drift::movement(std::size_t i, std::size_t k) const {
    if (!known(i, k)) return {{}, kUnknown};
    const Movement by_sum{shift[k] - shift[i], std::abs(rest[k] - rest[i])};
    const Movement by_foot{from_foot[k].shift - from_foot[i].shift, from_foot[i].rest + from_foot[k].rest};
    return by_foot.rest < by_sum.rest ? by_foot : by_sum;
}

double Drift::between(std::size_t i, std::size_t k) const {
    return known(i, k) ? std::abs(length[k] - length[i]) : kUnknown;
}

double relative(const Drift& a, std::size_t i, std::size_t k, const Drift& c, std::size_t m, std::size_t n) {
    const Movement of_a = a.movement(i, k), of_c = c.movement(m, n);
    return geom::norm(of_a.shift - of_c.shift) + of_a.rest + of_c.rest;
}

bool Drift::alone(std::size_t i) const {
    return (i == 0 || stretch[i - 1] != stretch[i]) && (i + 1 == stretch.size() || stretch[i + 1] != stretch[i]);
}

Drift drift(std::span<const Index> column, const std::vector<Outline>& outlines) {
    Drift out{{{}}, {0}, {0}, {{}}, {0}};
    if (column.empty()) return out;
    std::size_t foot = 0; // of the stretch
    for (std::size_t i = 1; i < column.size(); ++i) {
        const auto loops = [&](std::size_t place) -> const polygon::Loops& { return outlines[column[place]].loops; };
        Movement by = movement(loops(i - 1), loops(i));
        const bool known = by.rest < kUnknown;
        if (!known) {
            by = {};
            foot = i;
        }
        out.shift.push_back(out.shift.back() + by.shift);
        out.rest.push_back(out.rest.back() + by.rest);
        out.length.push_back(out.length.back() + geom::norm(by.shift) + by.rest);
        out.from_foot.push_back(same_loops(loops(i - 1), loops(i)) ? out.from_foot.back()
                                                                   : movement(loops(foot), loops(i)));
        out.stretch.push_back(out.stretch.back() + (known ? 0 : 1));
    }
    return out;
}

} // namespace filum::sequence
