#include "baselines/kipping2022/contours.hpp"

#include "base/error.hpp"
#include "geodesic/isolines.hpp"
#include "geom/polyline.hpp"

#include <cmath>

namespace filum::baselines::kipping2022 {

namespace {

constexpr double kMaxLevels = 1e5;
constexpr double kSame = 1e-9; // mm

Contour contour(const surface::Isoline& line, std::uint32_t level) {
    Contour out{level, line.closed, {}, line.triangles.front()};
    for (const Vec3& p : line.points)
        if (out.points.empty() || distance(out.points.back(), p) > kSame) out.points.push_back(p);
    while (out.closed && out.points.size() > 1 && distance(out.points.back(), out.points.front()) <= kSame)
        out.points.pop_back();
    return out;
}

} // namespace

double length(std::span<const Vec3> points, bool closed) {
    const double open = geom::length(points);
    return closed && points.size() > 1 ? open + distance(points.back(), points.front()) : open;
}

Note lines_note(NoteCode code, double mm, const Vec3& at) {
    return {.code = code, .amount = mm, .count = 1, .layer = -1, .x = at.x, .y = at.y, .z = at.z};
}

std::vector<std::vector<Contour>> contours(const Surface& s, std::span<const double> values, double step, double least,
                                           Notes& notes) {
    double farthest = 0;
    for (const double v : values)
        if (std::isfinite(v)) farthest = std::max(farthest, v);
    if (farthest / step > kMaxLevels)
        throw Error(Exit::usage, "cannot plan more than 100000 levels; raise --spacing or --d-iso");
    std::vector<double> levels;
    for (std::uint32_t i = 1; (i + kAtLevel) * step <= farthest; ++i) levels.push_back(i * step);
    std::vector<double> snapped(values.begin(), values.end());
    for (double& v : snapped)
        if (const double level = step * std::round(v / step); std::abs(v - level) <= kAtLevel * step) v = level;
    std::vector<std::vector<Contour>> out(levels.size());
    for (const auto& line : geodesic::isolines(s, snapped, levels)) {
        const auto i = static_cast<std::uint32_t>(std::lround(line.level / step));
        Contour piece = contour(line, i);
        const double l = length(piece.points, piece.closed);
        if (l >= least && piece.points.size() >= (piece.closed ? 3U : 2U))
            out[i - 1].push_back(std::move(piece));
        else if (l > kSame)
            notes.push_back(lines_note(NoteCode::isocontour_short, l, line.points[0]));
    }
    while (!out.empty() && out.back().empty()) out.pop_back();
    return out;
}

const std::vector<double>& distances(const surface::Sheet& sheet, const char* need) {
    for (const auto& field : sheet.fields)
        if (field.name == "distance" && field.components == 1) return field.values;
    throw Error(Exit::bad_input, std::string("the surface has no field 'distance'; ") + need);
}

void note_unreached(const Surface& s, std::span<const double> values, Notes& notes) {
    double area = 0;
    std::uint32_t worst = surface::kNone;
    std::vector<char> counted(s.components, 0);
    std::uint64_t count = 0;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto& [a, b, c] = s.triangles[t];
        if (std::isfinite(values[a]) && std::isfinite(values[b]) && std::isfinite(values[c])) continue;
        area += surface::area(s, t);
        if (worst == surface::kNone) worst = a;
        if (counted[s.component[t]]++ == 0) ++count;
        counted[s.component[t]] = 1;
    }
    if (worst == surface::kNone) return;
    const Vec3& at = s.vertices[worst];
    notes.push_back(
        {.code = NoteCode::component_unreached, .amount = area, .count = count, .layer = -1, .x = at.x, .y = at.y});
}

} // namespace filum::baselines::kipping2022
