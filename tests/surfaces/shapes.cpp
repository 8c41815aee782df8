#include "shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::trials {

namespace {

using std::numbers::pi;

double box(Vec2 p, Vec2 lo, Vec2 hi) { return std::min({p.x - lo.x, hi.x - p.x, p.y - lo.y, hi.y - p.y}); }

double capsule(Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 d = b - a;
    const double l2 = norm2(d), t = l2 > 0 ? std::clamp(dot(p - a, d) / l2, 0.0, 1.0) : 0;
    return distance(p, a + t * d);
}

// One outline within [0, a] x [0, b].
Domain outline(Vec2 size, Random& r, std::string& name) {
    const Vec2 c = 0.5 * size;
    const double least = std::min(size.x, size.y) / 2;
    switch (r.below(8)) {
    case 0:
        name += "rectangle";
        return [=](Vec2 p) { return box(p, {0, 0}, size); };
    case 1:
        name += "disc";
        return [=](Vec2 p) { return least - distance(p, c); };
    case 2: {
        name += "annulus";
        const double hole = r.in(0.2, 0.7) * least;
        return [=](Vec2 p) { return std::min(least - distance(p, c), distance(p, c) - hole); };
    }
    case 3: {
        name += "el";
        const Vec2 notch{r.in(0.3, 0.7) * size.x, r.in(0.3, 0.7) * size.y};
        return [=](Vec2 p) { return std::min(box(p, {0, 0}, size), std::max(notch.x - p.x, notch.y - p.y)); };
    }
    case 4: {
        name += "dumbbell";
        const double neck = r.in(0.08, 0.3) * size.y, from = 0.35 * size.x;
        return [=](Vec2 p) {
            const double waist = std::max(std::abs(p.x - c.x) - (c.x - from), neck - std::abs(p.y - c.y));
            return std::min(box(p, {0, 0}, size), waist);
        };
    }
    case 5: {
        name += "blob";
        double amplitude[4], phase[4];
        for (int k = 0; k < 4; ++k) {
            amplitude[k] = r.in(0, 0.3) / (k + 1);
            phase[k] = r.in(0, 2 * pi);
        }
        std::vector<double> a(amplitude, amplitude + 4), f(phase, phase + 4);
        return [=](Vec2 p) {
            const double t = std::atan2(p.y - c.y, p.x - c.x);
            double radius = 0.6 * least;
            for (int k = 0; k < 4; ++k)
                radius +=
                    least * a[static_cast<std::size_t>(k)] * std::cos((k + 2) * t + f[static_cast<std::size_t>(k)]);
            return std::max(radius, 0.15 * least) - distance(p, c);
        };
    }
    case 6: {
        name += "comb";
        const double tooth = size.x / static_cast<double>(3 + r.below(5)), part = r.in(0.3, 0.6), root = r.in(0.2, 0.6);
        return [=](Vec2 p) {
            const double gap = std::abs(std::fmod(p.x, tooth) / tooth - 0.5) * tooth - part * tooth / 2;
            return std::min(box(p, {0, 0}, size), std::max(gap, root * size.y - p.y));
        };
    }
    default: {
        name += "triangle";
        const double top = r.in(0.1, 0.9) * size.x;
        return [=](Vec2 p) {
            const Vec2 q[3] = {{0, 0}, {size.x, 0}, {top, size.y}};
            double out = 1e9;
            for (int k = 0; k < 3; ++k) {
                const Vec2 a = q[k], d = q[(k + 1) % 3] - a;
                out = std::min(out, cross(d, p - a) / norm(d));
            }
            return out;
        };
    }
    }
}

// With holes and slits cut out of it.
Domain pierced(Vec2 size, Domain inside, Random& r, std::string& name) {
    const auto at = [&] { return Vec2{r.in(0.1, 0.9) * size.x, r.in(0.1, 0.9) * size.y}; };
    const std::size_t holes = r.chance(0.5) ? 0 : 1 + r.below(r.chance(0.3) ? 9 : 3);
    for (std::size_t i = 0; i < holes; ++i) {
        const Vec2 c = at();
        const double radius = r.in(0.03, 0.14) * std::min(size.x, size.y);
        inside = [=](Vec2 p) { return std::min(inside(p), distance(p, c) - radius); };
    }
    const std::size_t slits = r.chance(0.6) ? 0 : 1 + r.below(3);
    for (std::size_t i = 0; i < slits; ++i) {
        const Vec2 a = at(), b = r.chance(0.5) ? at() : Vec2{a.x, r.chance(0.5) ? -1 : size.y + 1};
        const double half = r.in(0.1, 1.5);
        inside = [=](Vec2 p) { return std::min(inside(p), capsule(p, a, b) - half); };
    }
    if (holes > 0) name += "+" + std::to_string(holes) + "holes";
    if (slits > 0) name += "+" + std::to_string(slits) + "slits";
    return inside;
}

Lift lift(Vec2 size, Random& r, std::string& name) {
    const Vec2 c = 0.5 * size;
    const double s = std::max(size.x, size.y);
    switch (r.below(11)) {
    case 0:
    case 1:
        name = "plate:" + name;
        return [](Vec2 p) -> Vec3 { return {p.x, p.y, 0}; };
    case 2: {
        name = "cap:" + name;
        const double radius = r.in(0.75, 1.5) * s;
        return [=](Vec2 p) -> Vec3 { return {p.x, p.y, std::sqrt(std::max(0.0, radius * radius - norm2(p - c)))}; };
    }
    case 3: {
        name = "saddle:" + name;
        const double flat = r.in(1, 3) * s;
        return [=](Vec2 p) -> Vec3 {
            return {p.x, p.y, ((p.x - c.x) * (p.x - c.x) - (p.y - c.y) * (p.y - c.y)) / flat};
        };
    }
    case 4: {
        name = "cylinder:" + name;
        const double radius = size.x / r.in(2, 5);
        return [=](Vec2 p) -> Vec3 { return {radius * std::sin(p.x / radius), p.y, -radius * std::cos(p.x / radius)}; };
    }
    case 5: { // round its tip, which is a place or a rim
        name = "cone:" + name;
        const double sine = r.in(0.3, 0.8), from = r.chance(0.5) ? 0 : r.in(1, 8), cosine = std::sqrt(1 - sine * sine);
        const double turn = std::min(5.5, size.y / (sine * (from + 0.6 * size.x)));
        return [=](Vec2 p) -> Vec3 {
            const double t = turn * p.y / size.y, far = from + p.x;
            return {sine * far * std::cos(t), sine * far * std::sin(t), cosine * far};
        };
    }
    case 6: { // storeys one above the other
        name = "helicoid:" + name;
        const double inner = r.in(3, 10), pitch = r.in(6, 14), turn = size.y / (inner + size.x / 2);
        return [=](Vec2 p) -> Vec3 {
            const double t = turn * p.y / size.y, far = inner + p.x;
            return {far * std::cos(t), far * std::sin(t), pitch * t / (2 * pi)};
        };
    }
    case 7: { // layers that face each other's backs
        name = "roll:" + name;
        const double first = r.in(4, 8), growth = r.in(0.5, 1);
        return [=](Vec2 p) -> Vec3 { // Archimedes' spiral: first + growth t
            const double t = (std::sqrt(first * first + 2 * growth * p.x) - first) / growth;
            const double far = first + growth * t;
            return {far * std::cos(t), far * std::sin(t), p.y};
        };
    }
    case 8: {
        name = "fold:" + name;
        const double at = r.in(0.3, 0.7) * size.x, a = r.in(0.3, 1.9);
        return [=](Vec2 p) -> Vec3 {
            const double over = std::max(0.0, p.x - at);
            return {std::min(p.x, at) + over * std::cos(a), p.y, over * std::sin(a)};
        };
    }
    case 9: {
        name = "wave:" + name;
        const double high = r.in(0.5, 4), length = r.in(12, 40);
        return [=](Vec2 p) -> Vec3 {
            return {p.x, p.y, high * std::sin(2 * pi * p.x / length) * std::cos(2 * pi * p.y / length)};
        };
    }
    default: {
        name = "torus:" + name;
        const double tube = r.in(0.25, 0.6) * size.x, big = tube + r.in(0.3, 1) * size.y;
        return [=](Vec2 p) -> Vec3 {
            const double a = p.x / tube, b = p.y / big;
            const double far = big + tube * std::cos(a);
            return {far * std::cos(b), far * std::sin(b), tube * std::sin(a)};
        };
    }
    }
}

// Bumps that flow into each other, or tubes that do.
std::function<double(const Vec3&)> solid(Random& r, std::string& name, Vec3& lo, Vec3& hi) {
    struct Part {
        Vec3 a, b;
        double radius;
    };
    std::vector<Part> parts;
    if (r.chance(0.6)) {
        name = "bust";
        parts.push_back({{0, 0, 0}, {0, 0, r.in(0, 6)}, r.in(6, 10)});
        for (std::size_t i = 0, n = 1 + r.below(4); i < n; ++i) {
            const Vec3 d = r.direction(), from = r.in(5, 8) * d;
            parts.push_back({from, from + r.in(0, 9) * r.direction(), r.in(1.5, 4)});
        }
    } else {
        name = "tee";
        const double radius = r.in(4, 7);
        parts.push_back({{-18, 0, 0}, {18, 0, 0}, radius});
        for (std::size_t i = 0, n = 1 + r.below(2); i < n; ++i) {
            const Vec3 from{r.in(-8, 8), 0, 0}, d = r.direction();
            parts.push_back({from, from + r.in(12, 18) * Vec3{0.3 * d.x, d.y, d.z}, r.in(0.5, 0.95) * radius});
        }
    }
    lo = {1e9, 1e9, 1e9}, hi = {-1e9, -1e9, -1e9};
    for (const Part& p : parts)
        for (const Vec3& e : {p.a, p.b}) {
            lo = {std::min(lo.x, e.x - p.radius - 2), std::min(lo.y, e.y - p.radius - 2),
                  std::min(lo.z, e.z - p.radius - 2)};
            hi = {std::max(hi.x, e.x + p.radius + 2), std::max(hi.y, e.y + p.radius + 2),
                  std::max(hi.z, e.z + p.radius + 2)};
        }
    const double soft = r.in(0.5, 2);
    return [=](const Vec3& p) { // smooth maximum
        double sum = 0;
        for (const Part& q : parts) {
            const Vec3 d = q.b - q.a;
            const double l2 = dot(d, d), t = l2 > 0 ? std::clamp(dot(p - q.a, d) / l2, 0.0, 1.0) : 0;
            sum += std::exp((q.radius - distance(p, q.a + t * d)) / soft);
        }
        return soft * std::log(std::max(sum, 1e-300));
    };
}

Shape flat_shape(Random& r) {
    Shape out;
    Vec2 size{r.in(12, 45), r.in(12, 45)};
    if (r.chance(0.15)) size = {r.in(40, 90), r.in(2.5, 7)};
    Grid grid;
    grid.u = grid.v = r.in(0.5, 2);
    if (r.chance(0.2)) grid.u *= r.in(4, 20); // long and thin
    grid.jitter = r.chance(0.4) ? r.in(0.1, 0.4) : 0;
    grid.snapped = r.chance(0.2);
    if (grid.snapped) grid = {1, 1, 0, true}, size = {std::round(size.x), std::max(3.0, std::round(size.y))};
    const Domain inside = pierced(size, outline(size, r, out.name), r, out.name);
    const Lift into = lift(size, r, out.name);
    out.mesh = sheet(size, grid, inside, into, r);
    return out;
}

} // namespace

Shape random_shape(Random& r) {
    if (r.chance(0.75)) {
        Shape out = flat_shape(r);
        if (r.chance(0.12)) { // beside it another one
            const Shape more = flat_shape(r);
            const auto n = static_cast<std::uint32_t>(out.mesh.vertices.size());
            const Vec3 by = r.chance(0.3) ? Vec3{0, 0, -r.in(1, 4)} : Vec3{100, 0, 0}; // a wall's other skin, too
            for (const Vec3& v : more.mesh.vertices) out.mesh.vertices.push_back(v + by);
            for (const auto& [a, b, c] : more.mesh.triangles) out.mesh.triangles.push_back({a + n, b + n, c + n});
            out.name += "&" + more.name;
        }
        return out;
    }
    Shape out;
    Vec3 lo, hi;
    const auto field = solid(r, out.name, lo, hi);
    out.mesh = level_set(lo, hi, r.in(0.7, 1.3), field);
    return out;
}

} // namespace filum::trials
