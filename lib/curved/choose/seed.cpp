#include "choose/seed.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "metrics/surface/load.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/algorithm.hpp"

namespace filum::choose {

namespace {

using surface::curve::Line;
using surface::curve::Place;

constexpr double kPart = 0.5; // mean edges: step along the tension
// relative difference of the tension along and across above which its direction is defined
constexpr double kClear = 1e-6;
constexpr double kLongest = 4; // longest line along the tension, in box diagonals of the patch
constexpr int kDecimals = 3;

std::string words(const Vec3& p) {
    return fixed_text(p.x, kDecimals) + "," + fixed_text(p.y, kDecimals) + "," + fixed_text(p.z, kDecimals);
}

// The rim vertex nearest to `p`, as rim and side; ties: the first.
struct RimVertex {
    std::size_t rim = 0, side = 0;
};
RimVertex nearest_on_rims(const Surface& s, const Vec3& p) {
    RimVertex out;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t r = 0; r < s.rims.size(); ++r)
        for (std::size_t k = 0; k < s.rims[r].sides.size(); ++k)
            if (const double d = distance(s.vertices[s.tail(s.rims[r].sides[k])], p); d < least) {
                least = d;
                out = {r, k};
            }
    return out;
}

surface::Sources rim_side(const Surface& s, const Seed& seed) {
    surface::Sources out;
    if (s.rims.empty()) throw Error(Exit::failure, "the surface is closed");
    const RimVertex from = nearest_on_rims(s, seed.a), to = nearest_on_rims(s, seed.b);
    if (from.rim != to.rim) throw Error(Exit::failure, "the side's ends lie on different rims");
    const auto& sides = s.rims[from.rim].sides;
    std::size_t k = from.side;
    do {
        out.segments.push_back(surface::rim_side(s, sides[k]));
        k = (k + 1) % sides.size();
    } while (k != to.side);
    return out;
}

Vec3 pull_at(const Surface& s, const std::vector<Vec3>& pull, const Place& at, const Vec3& heading, bool across) {
    const auto w = surface::curve::barycentric(s, at);
    const Vec3 n = surface::normal(s, at.triangle);
    Vec3 sum{};
    for (std::size_t k = 0; k < 3; ++k) {
        Vec3 v = pull[s.triangles[at.triangle][k]];
        if (across) v = cross(n, v);
        const Vec3& lead = norm(heading) > 0 ? heading : sum;
        sum = sum + (dot(v, lead) < 0 ? -1 : 1) * std::max(0.0, w[k]) * v;
    }
    return geom::unit(sum, sum);
}

// The line from `from` along the tension up to a rim; it starts towards `heading`.
Line half(const Surface& s, const std::vector<Vec3>& pull, const Place& from, Vec3 heading, bool across, double step,
          double longest) {
    Line out{{from}, false};
    for (double way = 0; way < longest; way += step) {
        // The direction half a step ahead (midpoint rule), so that a line around something does not drift outwards.
        const Place before = out.places.back();
        const Vec3 here = pull_at(s, pull, before, heading, across);
        const Vec3 d = pull_at(s, pull, surface::curve::step(s, before, step / 2 * here), here, across);
        if (!(norm(d) > 0)) throw Error(Exit::failure, "the tension vanishes inside the surface");
        const Place after = surface::curve::step(s, before, step * d, &out);
        if (distance(before.point, after.point) < step / 10) return out;
        heading = d;
    }
    throw Error(Exit::failure, "the line along the tension does not reach a rim");
}

surface::Sources stress_line(const Sheet& sheet, const std::vector<Vec3>& pull, const Seed& seed) {
    if (pull.empty()) throw Error(Exit::failure, "the surface has no stress; run stressfield first");
    const Surface& s = sheet.surface;
    const bool across = seed.kind == Seed::Kind::across;
    const auto spot = surface::nearest(s, seed.a);
    const Place start{spot.triangle, spot.a};
    const Vec3 ahead = pull_at(s, pull, start, {}, across);
    geom::Box3 box = geom::box_of(s.vertices);
    box.add(start.point);
    const double step = kPart * surface::mean_edge(s), longest = kLongest * distance(box.lo, box.hi);
    Line line = half(s, pull, start, -1 * ahead, across, step, longest);
    surface::curve::reverse(line);
    surface::curve::append(line, half(s, pull, start, ahead, across, step, longest));
    surface::Sources out;
    for (std::size_t i = 1; i < line.size(); ++i)
        if (line[i - 1] != line[i]) out.segments.push_back({line.places[i - 1].triangle, line[i - 1], line[i]});
    return out;
}

} // namespace

std::string spoken(const Seed& seed) {
    const Vec3& n = seed.plane.normal;
    switch (seed.kind) {
    case Seed::Kind::rims:
        return "boundary";
    case Seed::Kind::plane:
        return "plane:" + words(n) + "," + fixed_text(seed.plane.offset, kDecimals);
    case Seed::Kind::point:
        return "point:" + words(seed.a);
    case Seed::Kind::side:
        return "side:" + words(seed.a) + ":" + words(seed.b);
    case Seed::Kind::stress:
        return "stress";
    case Seed::Kind::direction:
        return "direction:" + words(seed.a);
    case Seed::Kind::along:
        return "along:" + words(seed.a);
    case Seed::Kind::across:
        return "across:" + words(seed.a);
    case Seed::Kind::given:
        break;
    }
    return "given";
}

std::vector<Vec3> pulls(const Sheet& sheet) {
    const auto loads = metrics::surface::load_cases(sheet);
    std::vector<Vec3> out;
    if (loads.empty()) return out;
    const auto normals = surface::curve::vertex_normals(sheet.surface);
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const Vec3& n = normals[v];
        const Vec3 axis = std::abs(n.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        Vec3 x = axis - dot(axis, n) * n;
        x = 1 / norm(x) * x;
        const Vec3 y = cross(n, x);
        double xx = 0, xy = 0, yy = 0;
        for (const auto& load : loads) {
            const Vec3 d = load.d1->vector(v);
            const double s = load.s1 != nullptr ? std::max(0.0, load.s1->values[v]) : 1;
            if (!std::isfinite(d.x + d.y + d.z + s)) continue;
            const double a = dot(d, x), b = dot(d, y);
            xx += s * a * a;
            xy += s * a * b;
            yy += s * b * b;
        }
        // The principal axis of a symmetric matrix is at half the angle of (xx - yy, 2 xy).
        const double size = std::hypot(xx - yy, 2 * xy), angle = std::atan2(2 * xy, xx - yy) / 2;
        const bool clear = size > kClear * (xx + yy);
        out.push_back(clear ? std::cos(angle) * x + std::sin(angle) * y : Vec3{});
    }
    return out;
}

surface::Sources sources(const Sheet& sheet, const std::vector<Vec3>& pull, const Seed& seed) {
    const Surface& s = sheet.surface;
    surface::Sources out;
    switch (seed.kind) {
    case Seed::Kind::rims:
        out = surface::rim_sources(s);
        if (out.empty()) throw Error(Exit::failure, "the surface is closed");
        break;
    case Seed::Kind::side:
        return rim_side(s, seed);
    case Seed::Kind::plane:
        out.segments = surface::section(s, seed.plane);
        if (out.empty()) throw Error(Exit::failure, "the plane does not meet the surface");
        break;
    case Seed::Kind::point:
        out.segments.push_back(surface::nearest(s, seed.a));
        break;
    case Seed::Kind::along:
    case Seed::Kind::across:
        return stress_line(sheet, pull, seed);
    case Seed::Kind::given:
        return sheet.sources;
    case Seed::Kind::stress:
    case Seed::Kind::direction:
        break;
    }
    return out;
}

void put(Sheet& sheet, const std::vector<Vec3>& pull, const Seed& seed) {
    sheet.sources = sources(sheet, pull, seed);
    if (seed.kind == Seed::Kind::given) return;
    std::erase_if(sheet.fields, [](const surface::Field& f) { return f.name == surfpath::kDirection; });
    if (seed.kind != Seed::Kind::direction) return;
    surface::Field out{surfpath::kDirection, {}, 3};
    for (std::size_t v = 0; v < sheet.surface.vertices.size(); ++v)
        out.values.insert(out.values.end(), {seed.a.x, seed.a.y, seed.a.z});
    sheet.fields.push_back(std::move(out));
}

} // namespace filum::choose
