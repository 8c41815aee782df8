#include "fill/rows/rectilinear.hpp"

#include "fill/rings/lanes.hpp"
#include "polygon/clip.hpp"
#include "polygon/inset.hpp"
#include "polygon/stretches.hpp"
#include "polygon/strips.hpp"

#include <algorithm>

namespace filum::fill::rows {

using geom::Vec2;
using polygon::Loops;

namespace {

// A line is kept where it lies this many pitches inside the outline. Its ends move back to half a pitch from an upright
// outline, and lines shorter than that inset are dropped. So a line along a flat edge may protrude by a quarter of its
// width; otherwise it would leave a void of up to one width.
constexpr double kInset = 0.25, kTrim = 1 - 2 * kInset;
constexpr double kLineGive = 0.15; // share by which a line's width may differ, to fit between flat edges

struct Line {
    double y, from, to, width;
    bool laid = false;
};

// Appends the lines row by row. Each continues with an overlapping line in the next row.
void lay_lines(std::vector<std::vector<Line>>& rows, std::vector<toolpath::Curve>& out) {
    for (std::size_t first = 0; first < rows.size(); ++first)
        for (auto& start : rows[first]) {
            bool right = true;
            Line* line = start.laid ? nullptr : &start;
            for (std::size_t row = first; line != nullptr; right = !right) {
                line->laid = true;
                Vec2 a{line->from, line->y}, b{line->to, line->y};
                if (!right) std::swap(a, b);
                out.push_back({false, {a, b}, {line->width}});
                if (++row == rows.size()) break;
                const auto next = std::find_if(rows[row].begin(), rows[row].end(), [&](const Line& l) {
                    return !l.laid && l.from < line->to && line->from < l.to;
                });
                line = next == rows[row].end() ? nullptr : &*next;
            }
        }
}

// Appends the lines of one connected part, in the frame where they run along x.
void fill_with_lines(const Loops& part, double bead_width, std::vector<toolpath::Curve>& out) {
    const auto strips = polygon::strip_bounds(part, bead_width, kLineGive);
    std::vector<double> y, pitch;
    for (std::size_t i = 0; i + 1 < strips.size(); ++i) {
        y.push_back((strips[i] + strips[i + 1]) / 2);
        pitch.push_back(strips[i + 1] - strips[i]);
    }
    const auto stretches = polygon::scan(polygon::inset(part, kInset * bead_width), y);
    std::vector<std::vector<Line>> rows(y.size());
    for (std::size_t i = 0; i < y.size(); ++i)
        for (const polygon::LevelStretch s : stretches[i])
            if (s.to - s.from > (kTrim + kInset) * bead_width)
                rows[i].push_back({y[i], s.from + kTrim * bead_width / 2, s.to - kTrim * bead_width / 2, pitch[i]});
    lay_lines(rows, out);
}

} // namespace

std::vector<toolpath::Curve> rectilinear(const Loops& region, const RectilinearOptions& o, Notes& notes) {
    std::vector<toolpath::Curve> out;
    std::vector<Loops> core{region};
    if (o.rings > 0) {
        rings::FirstLanes outer = rings::first_lanes(region, {.width = o.bead_width, .most = o.rings});
        out = rings::curves_of(outer.lanes);
        core = std::move(outer.rest);
    } else {
        polygon::note_unplaced(region, polygon::inset(polygon::inset(region, o.bead_width / 2), -o.bead_width / 2),
                               o.bead_width, notes);
    }
    const std::size_t first = out.size();
    for (const Loops& part : core) fill_with_lines(polygon::rotated(part, -o.angle), o.bead_width, out);
    for (std::size_t i = first; i < out.size(); ++i) polygon::rotate(out[i].points, o.angle);
    return out;
}

} // namespace filum::fill::rows
