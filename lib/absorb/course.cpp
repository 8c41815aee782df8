#include "absorb/course.hpp"

#include "geom/segment.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace filum::absorb {

namespace {

int count(const Mask& a, const Mask& b) {
    int n = 0;
    for (std::size_t y = 0; y < 64; ++y)
        if (const std::uint64_t both = a.rows[y] & b.rows[y]) n += std::popcount(both);
    return n;
}

bool one_of(const std::vector<std::uint32_t>& list, std::uint32_t i) {
    return std::find(list.begin(), list.end(), i) != list.end();
}

} // namespace

Vec2 snapped(Vec2 p) { return {std::round(p.x * 1e3) / 1e3, std::round(p.y * 1e3) / 1e3}; }

Pixel window(const Tile& tile, Vec2 middle) {
    const Pixel p = tile.at(middle);
    return {std::clamp(p.x - 32, 0, std::max(0, tile.width() - 64)),
            std::clamp(p.y - 32, 0, std::max(0, tile.height() - 64))};
}

Scores::Scores(const Tile& tile, const Chain& chain, std::uint32_t from, std::uint32_t to, Pixel corner,
               const Prices& prices)
    : tile_(tile), corner_(corner), prices_(prices), from_(chain[from].knot), to_(chain[to].knot) {
    Part old;
    std::vector<Bead> beads;
    for (std::uint32_t i = from; i != to; i = chain[i].next) {
        beads.push_back(chain.bead(i));
        add(old, chain[i].knot, chain[chain[i].next].knot);
    }
    tile.uncovered(corner, beads, in_, out_);
    now_ = sum(old);
}

void Scores::add(Part& part, const Knot& a, const Knot& b) const {
    const Bead bead{a.at, b.at, (a.width + b.width) / 2};
    tile_.stamp(bead, corner_, part.mask);
    part.laid += geom::distance(a.at, b.at) * bead.width / (tile_.pixel() * tile_.pixel());
}

Scores::Sum Scores::sum(const Part& part) const {
    return {static_cast<double>(count(part.mask, in_)), static_cast<double>(count(part.mask, out_)), part.laid};
}

double Scores::operator()(const Part& part, std::span<const Knot> knots) const {
    Part all = part;
    for (std::size_t k = 0; k + 1 < knots.size(); ++k) add(all, knots[k], knots[k + 1]);
    const Sum then = sum(all);
    const double covered = then.covered - now_.covered, outside = then.outside - now_.outside;
    const double twice = then.laid - now_.laid - covered - outside;
    return covered - prices_.outside * outside - (twice > 0 ? prices_.twice * twice : -prices_.starved * twice);
}

double Scores::operator()(std::span<const Knot> knots) const {
    Part ends;
    add(ends, from_, knots.front()), add(ends, knots.back(), to_);
    return (*this)(ends, knots);
}

bool clear(const Chain& chain, const Near& near, const Course& course, double distance) {
    std::vector<Vec2> line{chain.point(course.from)};
    for (const Knot& k : course.knots) line.push_back(k.at);
    line.push_back(chain.point(course.to));
    std::vector<std::uint32_t> own{course.from}, kin;
    own.insert(own.end(), course.nodes.begin(), course.nodes.end());
    for (std::uint32_t i = course.from, k = 0; k < 3; ++k) kin.push_back(i = chain[i].before);
    for (std::uint32_t i = course.to, k = 0; k < 3; ++k) kin.push_back(i), i = chain[i].next;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        const Vec2 a = line[k], b = line[k + 1];
        if (a == b) return false;
        for (std::size_t m = k + 2; m + 1 < line.size(); ++m)
            if (geom::segment_distance(a, b, line[m], line[m + 1]) < distance && m > k + 2)
                return false;
            else if (geom::cross_properly(a, b, line[m], line[m + 1]))
                return false;
        bool ok = true;
        const Vec2 d{distance, distance};
        const Vec2 lo{std::min(a.x, b.x), std::min(a.y, b.y)}, hi{std::max(a.x, b.x), std::max(a.y, b.y)};
        near.visit(lo - d, hi + d, [&](std::uint32_t s) {
            if (!ok || one_of(own, s)) return;
            const Vec2 p = chain.point(s), q = chain.point(chain[s].next);
            ok =
                !geom::cross_properly(a, b, p, q) && (one_of(kin, s) || geom::segment_distance(a, b, p, q) >= distance);
        });
        if (!ok) return false;
    }
    return true;
}

void make(Tile& tile, Chain& chain, Near& near, const Course& course) {
    const auto paint = [&](int times) {
        for (std::uint32_t i = course.from; i != course.to; i = chain[i].next) tile.add(chain.bead(i), times);
    };
    paint(-1);
    std::uint32_t at = course.from;
    for (std::size_t k = 0; k < course.knots.size(); ++k) {
        if (k < course.nodes.size())
            chain.set(at = course.nodes[k], course.knots[k]);
        else
            at = chain.put_after(at, course.knots[k]);
    }
    paint(1);
    for (std::uint32_t i = course.from; i != course.to; i = chain[i].next) near.add(i);
}

} // namespace filum::absorb
