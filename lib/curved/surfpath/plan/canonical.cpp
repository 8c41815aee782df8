#include "surfpath/plan/canonical.hpp"

#include "base/mix.hpp"
#include "parallel/parallel.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace filum::surfpath::plan {

namespace {

constexpr std::array<std::array<int, 3>, 6> kOrders{{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};

using Cell = std::array<std::int64_t, 3>;

Cell cell(const Vec3& p, double grid) {
    return {std::llround(p.x / grid), std::llround(p.y / grid), std::llround(p.z / grid)};
}

// The 24 frames, those with the axes as they are first.
std::vector<AxisFrame> frames(const Vec3& centre) {
    std::vector<AxisFrame> out;
    for (std::size_t i = 0; i < kOrders.size(); ++i)
        for (unsigned flips = 0; flips < 8; ++flips) {
            const bool odd_order = i >= 3, odd_flips = std::popcount(flips) % 2 == 1;
            if (odd_order != odd_flips) continue;
            AxisFrame f{kOrders[i], {}, centre};
            for (std::size_t k = 0; k < 3; ++k) f.sign[k] = (flips >> k & 1) != 0 ? -1 : 1;
            out.push_back(f);
        }
    return out;
}

// The cell that `c` is in a frame.
Cell into(const AxisFrame& f, const Cell& c) {
    Cell out{};
    for (std::size_t k = 0; k < 3; ++k) out[k] = (f.sign[k] < 0 ? -1 : 1) * c[static_cast<std::size_t>(f.axis[k])];
    return out;
}

std::uint64_t code(const Cell& c) {
    std::uint64_t out = 0;
    for (const std::int64_t x : c) out = mixed(out + static_cast<std::uint64_t>(x));
    return out;
}

// The products of the components of a direction, which do not depend on its sign, in steps of kGrid.
std::array<Cell, 2> products(const Vec3& d) {
    const auto step = [](double x) { return std::isfinite(x) ? std::llround(std::clamp(x, -1.0, 1.0) / kGrid) : 0; };
    return {Cell{step(d.x * d.x), step(d.y * d.y), step(d.z * d.z)},
            Cell{step(d.y * d.z), step(d.z * d.x), step(d.x * d.y)}};
}

std::uint64_t code(const Vec3& direction) {
    const auto [squares, mixed_ones] = products(direction);
    return mixed(code(squares) + code(mixed_ones));
}

// The direction without its last bits, in steps of kGrid squared.
Vec3 without_rounding(const Vec3& v) {
    const double l = norm(v);
    if (!(l > 0) || !std::isfinite(l)) return v;
    const double fine = l * kGrid * kGrid;
    const auto step = [&](double x) { return fine * std::round(x / fine); };
    return {step(v.x), step(v.y), step(v.z)};
}

// A number for what a sheet looks like in a frame: sums over triangles and vertices, so that their order does not
// count. `direction` is one that lines may follow.
std::uint64_t look(const surface::Sheet& sheet, const std::vector<Cell>& cells, const AxisFrame& f,
                   const Vec3& direction) {
    std::vector<std::uint64_t> vertex;
    vertex.reserve(cells.size());
    for (const Cell& c : cells) vertex.push_back(code(into(f, c)));
    std::uint64_t out = code(f.into(geom::unit(direction, {})));
    const Surface& s = sheet.surface;
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) out += mixed(vertex[s.tail(h)] + 2 * vertex[s.head(h)]);
    for (const surface::Field& field : sheet.fields) {
        if (field.components != 3) continue;
        for (std::size_t v = 0; v < cells.size(); ++v)
            out += mixed(code(f.into(geom::unit(field.vector(v), {}))) + vertex[v]);
    }
    return out;
}

// Per vertex, whether it can be moved by a cell: every triangle around it has a height of at least `lowest` mm.
std::vector<char> movable(const Surface& s, double lowest) {
    std::vector<char> out(s.vertices.size(), 1);
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        double longest = 0;
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) longest = std::max(longest, surface::side_length(s, h));
        if (2 * surface::area(s, t) >= lowest * longest) continue;
        for (const std::uint32_t v : s.triangles[t]) out[v] = 0;
    }
    return out;
}

// mm, in the frame: how far a place of the triangle on the canonical surface lies from there on the given one, a mean
// over the triangle's corners. `place` is on surface `s`, one of both.
Vec3 moved_by(const CanonicalSheet& canonical, const Surface& given, const Place& place, const Surface& s) {
    const auto weights = surface::curve::barycentric(s, place);
    Vec3 out;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = given.triangles[place.triangle][k];
        const Vec3 there = canonical.frame.into(given.vertices[v] - canonical.frame.centre);
        out = out + std::clamp(weights[k], 0.0, 1.0) * (there - canonical.sheet.surface.vertices[v]);
    }
    return out;
}

} // namespace

Vec3 AxisFrame::into(const Vec3& d) const {
    return {sign[0] * geom::coordinate(d, axis[0]), sign[1] * geom::coordinate(d, axis[1]),
            sign[2] * geom::coordinate(d, axis[2])};
}

Vec3 AxisFrame::out_of(const Vec3& d) const {
    std::array<double, 3> out{};
    for (std::size_t k = 0; k < 3; ++k)
        out[static_cast<std::size_t>(axis[k])] = sign[k] * geom::coordinate(d, static_cast<int>(k));
    return {out[0], out[1], out[2]};
}

CanonicalSheet canonical(const surface::Sheet& given, double spacing, const Vec3& direction) {
    const Surface& s = given.surface;
    const double grid = kGrid * spacing;
    const auto box = geom::box_of(s.vertices);
    const Vec3 centre = 0.5 * (box.lo + box.hi);
    std::vector<Cell> cells;
    cells.reserve(s.vertices.size());
    for (const Vec3& v : s.vertices) cells.push_back(cell(v - centre, grid));
    const auto all = frames(centre);
    std::vector<std::uint64_t> looks(all.size());
    parallel::for_chunks(all.size(), 1, 0,
                         [&](std::size_t i, std::size_t) { looks[i] = look(given, cells, all[i], direction); });
    const auto least = std::min_element(looks.begin(), looks.end()) - looks.begin();
    CanonicalSheet out{given, all[static_cast<std::size_t>(least)], {}};
    const AxisFrame& f = out.frame;
    out.direction = without_rounding(f.into(geom::unit(direction, {})));
    const auto moves = movable(s, rules::kFineGrain * spacing);
    for (std::size_t v = 0; v < cells.size(); ++v) {
        const Cell c = into(f, cells[v]);
        const Vec3 at{static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
        out.sheet.surface.vertices[v] = moves[v] != 0 ? grid * at : f.into(s.vertices[v] - centre);
    }
    for (surface::Field& field : out.sheet.fields) {
        if (field.components != 3) continue;
        for (std::size_t v = 0; v < cells.size(); ++v) {
            const Vec3 d = without_rounding(f.into(field.vector(v)));
            field.values[3 * v] = d.x;
            field.values[3 * v + 1] = d.y;
            field.values[3 * v + 2] = d.z;
        }
    }
    for (surface::Segment& g : out.sheet.sources.segments)
        for (Vec3* p : {&g.a, &g.b}) *p = f.into(*p - centre) - moved_by(out, s, {g.triangle, *p}, s);
    return out;
}

void from_canonical(Plan& plan, const CanonicalSheet& canonical, const surface::Sheet& given) {
    const auto back = [&](const Vec3& p) { return canonical.frame.centre + canonical.frame.out_of(p); };
    for (Stroke& stroke : plan.strokes)
        for (Section& piece : stroke.sections)
            for (Place& p : piece.line.places)
                p.point = back(p.point + moved_by(canonical, given.surface, p, canonical.sheet.surface));
    for (Vec3& p : plan.births) p = back(p);
    for (Note& n : plan.notes) {
        if (std::isnan(n.x)) continue;
        const Vec3 p = back({n.x, n.y, n.z});
        n.x = p.x;
        n.y = p.y;
        n.z = p.z;
    }
}

} // namespace filum::surfpath::plan
