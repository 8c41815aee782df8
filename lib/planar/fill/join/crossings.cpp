#include "fill/join/crossings.hpp"

#include <algorithm>
#include <cmath>

namespace filum::fill::join {

namespace {

using geom::Vec2;

// A point of a curve, or a crossing that becomes one.
struct Knot {
    Vec2 at;
    double width;
};

std::size_t segments_of(const toolpath::Curve& c) { return c.points.size() - (c.closed || c.points.empty() ? 0 : 1); }

struct OnCurve {
    std::size_t curve, segment;
};

OnCurve place_of(const std::vector<toolpath::Curve>& curves, std::size_t segment) {
    std::size_t c = 0;
    for (; segment >= segments_of(curves[c]); ++c) segment -= segments_of(curves[c]);
    return {c, segment};
}

// Where segment i of a crosses segment j of b, in whole micrometres.
Knot crossing(const toolpath::Curve& a, std::size_t i, const toolpath::Curve& b, std::size_t j) {
    const std::size_t i2 = (i + 1) % a.points.size(), j2 = (j + 1) % b.points.size();
    const Vec2 p = a.points[i], u = a.points[i2] - p, q = b.points[j], v = b.points[j2] - q;
    const double t = std::clamp(cross(q - p, v) / cross(u, v), 0.0, 1.0);
    const Vec2 at = p + t * u;
    return {toolpath::on_grid(at), std::min(std::lerp(a.width[i], a.width[i2], t), std::max(b.width[j], b.width[j2]))};
}

void append(const Knot& knot, toolpath::Curve& to) {
    if (to.points.empty() || to.points.back() != knot.at) to.add(knot.at, knot.width);
}

// Appends points `first` to `last` of a closed curve. Indices wrap around; first > last goes backwards.
void append(const toolpath::Curve& from, std::size_t first, std::size_t last, toolpath::Curve& to) {
    const std::size_t n = from.points.size(), count = first <= last ? last - first : first - last;
    for (std::size_t k = 0; k <= count; ++k) {
        const std::size_t i = (first <= last ? first + k : first - k) % n;
        append({from.points[i], from.width[i]}, to);
    }
}

// The curve a up to its segment i, then along points `first` to `last` of b, and on from point `next` of a. It passes x
// before and after b.
toolpath::Curve by_way_of(const toolpath::Curve& a, std::size_t i, const Knot& x, const toolpath::Curve& b,
                          std::size_t first, std::size_t last, std::size_t next) {
    toolpath::Curve out{true, {}, {}};
    append(a, 0, i, out);
    append(x, out);
    append(b, first, last, out);
    append(x, out);
    if (next < a.points.size()) append(a, next, a.points.size() - 1, out);
    while (out.points.size() > 3 && out.points.back() == out.points.front()) out.drop_last();
    return out;
}

} // namespace

void note_crossings(const std::vector<toolpath::Curve>& curves, double cell, Notes& notes) {
    const auto pairs = crossing_pairs(curves, cell);
    if (pairs.empty()) return;
    const OnCurve first = place_of(curves, pairs[0].first);
    const geom::Vec2 at = curves[first.curve].points[first.segment];
    const auto n = static_cast<double>(pairs.size());
    notes.push_back({NoteCode::curve_crosses_itself, n, pairs.size(), -1, at.x, at.y});
}

std::size_t uncross(std::vector<toolpath::Curve>& curves, double cell, Notes& notes) {
    auto pairs = crossing_pairs(curves, cell);
    for (std::size_t left = 4 * pairs.size(); left > 0 && !pairs.empty(); --left) {
        const OnCurve a = place_of(curves, pairs[0].first), b = place_of(curves, pairs[0].second);
        toolpath::Curve& one = curves[a.curve];
        const toolpath::Curve& two = curves[b.curve];
        const std::size_t i = a.segment, j = b.segment;
        const Knot x = crossing(one, i, two, j);
        if (a.curve == b.curve) { // reverse the stretch between the two passes
            one = by_way_of(one, i, x, one, j, i + 1, j + 1);
        } else {
            one = by_way_of(one, i, x, two, j + 1, j + two.points.size(), i + 1);
            curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(b.curve));
        }
        pairs = crossing_pairs(curves, cell);
    }
    if (!pairs.empty()) note_crossings(curves, cell, notes);
    return pairs.size();
}

void lay_on_grid(std::vector<toolpath::Curve>& curves, double cell, Notes& notes) {
    for (toolpath::Curve& c : curves) toolpath::put_on_grid(c);
    if (toolpath::part_crossings(curves, cell).empty()) return;
    const bool rings = std::all_of(curves.begin(), curves.end(), [](const toolpath::Curve& c) {
        return c.closed && c.width.size() == c.points.size();
    });
    if (rings)
        uncross(curves, cell, notes);
    else
        note_crossings(curves, cell, notes);
}

} // namespace filum::fill::join
