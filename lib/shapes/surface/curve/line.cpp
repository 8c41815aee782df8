#include "surface/curve/line.hpp"

#include "surface/curve/walk.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surface::curve {

namespace {

constexpr double kSame = 1e-9;     // mm: nearer points are equal
constexpr double kNoNormal = 1e-6; // rad: a shorter sum of unit normals weighted by angles has no direction

// Limits `way` to the line, or wraps it around a closed one.
double wrapped(const Line& line, std::span<const double> ways, double way) {
    const double all = ways.back();
    if (!line.closed || !(all > 0)) return std::clamp(way, 0.0, all);
    way = std::fmod(way, all);
    return way < 0 ? way + all : way;
}

// The segment that contains the wrapped arc length `way`.
std::size_t stretch(std::span<const double> ways, double way) {
    const auto after = std::upper_bound(ways.begin(), ways.end(), way);
    const auto i = static_cast<std::size_t>(after - ways.begin());
    return std::min(i > 0 ? i - 1 : 0, ways.size() >= 2 ? ways.size() - 2 : 0);
}

} // namespace

Line line(const surface::Isoline& isoline) {
    Line out{{}, isoline.closed};
    out.places.reserve(isoline.points.size());
    for (std::size_t i = 0; i < isoline.points.size(); ++i)
        out.places.push_back({isoline.triangles[std::min(i, isoline.triangles.size() - 1)], isoline.points[i]});
    return out;
}

std::vector<double> arc_lengths(const Line& line) {
    std::vector<double> out;
    out.reserve(line.size() + 1);
    if (line.size() > 0) out.push_back(0);
    for (std::size_t i = 1; i < line.size(); ++i) out.push_back(out.back() + distance(line[i - 1], line[i]));
    if (line.closed && line.size() > 0) out.push_back(out.back() + distance(line[line.size() - 1], line[0]));
    return out;
}

double length(const Line& line) { return line.size() == 0 ? 0 : arc_lengths(line).back(); }

Place at(const Line& line, std::span<const double> ways, double way) {
    if (line.size() == 1) return line.places[0];
    way = wrapped(line, ways, way);
    const std::size_t i = stretch(ways, way);
    const Place &a = line.places[i], &b = line.places[(i + 1) % line.size()];
    const double l = ways[i + 1] - ways[i], f = l > 0 ? std::min(1.0, (way - ways[i]) / l) : 0;
    return {f < 1 ? a.triangle : b.triangle, a.point + f * (b.point - a.point)};
}

Line part(const Line& line, std::span<const double> ways, double from, double to) {
    Line out;
    if (line.size() == 0) return out;
    const double all = ways.back();
    if (!line.closed) {
        from = std::clamp(from, 0.0, all);
        to = std::clamp(to, from, all);
    } else {
        const double rest = to - from;
        from = wrapped(line, ways, from);
        to = from + (rest < 0 ? rest + all * std::ceil(-rest / all) : std::min(rest, all));
    }
    out.places.push_back(at(line, ways, from));
    const std::size_t n = ways.size() - 1;
    for (std::size_t i = stretch(ways, from) + 1; n > 0; ++i) {
        const std::size_t laps = i / n;
        const double here = ways[i % n] + (line.closed ? all * static_cast<double>(laps) : 0);
        if (!(here < to - kSame) || (!line.closed && i >= n)) break;
        // A point just behind the start replaces it: the next segment is in that point's triangle.
        if (here > from + kSame)
            out.places.push_back(line.places[i % n % line.size()]);
        else
            out.places.back() = line.places[i % n % line.size()];
    }
    if (to - from > kSame) out.places.push_back(at(line, ways, line.closed ? to : std::min(to, all)));
    return out;
}

Line resampled(const Line& line, double step) {
    const auto w = arc_lengths(line);
    const double all = w.empty() ? 0 : w.back();
    const auto n = static_cast<std::size_t>(std::max(line.closed ? 3.0 : 1.0, std::round(all / step)));
    Line out{{}, line.closed};
    if (line.size() < 2 || !(all > 0)) return line;
    for (std::size_t i = 0; i < n + (line.closed ? 0 : 1); ++i)
        out.places.push_back(i == n ? line.places.back()
                                    : at(line, w, all * static_cast<double>(i) / static_cast<double>(n)));
    return out;
}

void reverse(Line& line) {
    std::vector<Place>& p = line.places;
    if (p.empty()) return;
    const std::uint32_t first = p.front().triangle, last = p.back().triangle;
    std::reverse(p.begin(), p.end());
    for (std::size_t i = 0; i + 1 < p.size(); ++i) p[i].triangle = p[i + 1].triangle;
    p.back().triangle = line.closed ? last : first;
}

void append(Line& line, const Line& more) {
    if (line.size() > 0 && more.size() > 0 && distance(line.places.back().point, more[0]) < kSame)
        line.places.pop_back();
    line.places.insert(line.places.end(), more.places.begin(), more.places.end());
}

// Where slivers are folded over their neighbours, normals weighted by angles may cancel; there they are weighted by
// area.
static void by_area(const Surface& s, std::vector<Vec3>& normals) {
    std::vector<char> none(normals.size(), 0);
    for (std::size_t v = 0; v < normals.size(); ++v)
        if (!(norm(normals[v]) > kNoNormal)) {
            none[v] = 1;
            normals[v] = {};
        }
    if (std::find(none.begin(), none.end(), 1) == none.end()) return;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t)
        for (const std::uint32_t v : s.triangles[t])
            if (none[v] != 0) normals[v] = normals[v] + surface::area(s, t) * surface::normal(s, t);
    for (std::size_t v = 0; v < normals.size(); ++v)
        if (const double l = norm(normals[v]); none[v] != 0 && l > 0) normals[v] = 1 / l * normals[v];
}

std::vector<Vec3> vertex_normals(const Surface& s) {
    std::vector<Vec3> out(s.vertices.size());
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const Vec3 n = surface::normal(s, t);
        for (std::uint32_t k = 0; k < 3; ++k) {
            const Vec3& p = s.vertices[s.triangles[t][k]];
            const double a =
                angle(s.vertices[s.triangles[t][(k + 1) % 3]] - p, s.vertices[s.triangles[t][(k + 2) % 3]] - p);
            Vec3& to = out[s.triangles[t][k]];
            to = to + a * n;
        }
    }
    for (Vec3& n : out)
        if (const double l = norm(n); l > kNoNormal) n = 1 / l * n;
    by_area(s, out);
    return out;
}

Vec3 normal_at(const Surface& s, std::span<const Vec3> vertex_normals, const Place& place) {
    const auto w = barycentric(s, place);
    const auto& t = s.triangles[place.triangle];
    const Vec3 n = w[0] * vertex_normals[t[0]] + w[1] * vertex_normals[t[1]] + w[2] * vertex_normals[t[2]];
    const double l = norm(n);
    return l > 1e-6 ? 1 / l * n : surface::normal(s, place.triangle);
}

} // namespace filum::surface::curve
