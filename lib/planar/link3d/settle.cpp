#include "link3d/settle.hpp"

#include "toolpath/grid.hpp"

#include <algorithm>

namespace filum::link3d {

namespace {

using toolpath::Curve;
using toolpath::Role;
using toolpath::Span;

// The points of spans, grouped into columns: consecutive points that round to one place of the grid, as those of a
// lift, move together.
struct Columns {
    std::vector<Vec3*> points;
    std::vector<std::size_t> begin; // of each column

    // Adds a point; returns whether it begins a column.
    bool add(Vec3& p) {
        const bool begins = points.empty() || toolpath::on_grid(points.back()->xy()) != toolpath::on_grid(p.xy());
        if (begins) begin.push_back(points.size());
        points.push_back(&p);
        return begins;
    }
    [[nodiscard]] std::size_t last() const { return begin.size() - 1; }
    void move(std::size_t column, Vec2 to) {
        const std::size_t end = column == last() ? points.size() : begin[column + 1];
        for (std::size_t k = begin[column]; k < end; ++k) *points[k] = {to.x, to.y, points[k]->z};
    }
};

// The segments in the layer, as open curves on the grid; point i of curve c is column first[c] + i.
struct Lines {
    std::vector<Curve> curves;
    std::vector<std::size_t> first;
    std::vector<char> join; // per segment

    // Adds the segment that ends at `column`.
    void add(Vec2 from, Vec2 to, std::size_t column, bool is_join) {
        if (curves.empty() || first.back() + curves.back().points.size() != column) {
            curves.push_back({false, {toolpath::on_grid(from)}, {1}});
            first.push_back(column - 1);
        }
        curves.back().points.push_back(toolpath::on_grid(to));
        join.push_back(is_join ? 1 : 0);
    }
};

// Whether a segment lies in the layer, no lower than `least`: the upper end of a ramp is in the way of joins too.
bool in_layer(const Span& s, std::size_t i, double least) {
    if (!toolpath::extrudes(s.role)) return false;
    return s.role == Role::lift || (s.points[i].z >= least && s.points[i + 1].z >= least);
}

} // namespace

void settle(State& state) {
    auto& spans = state.front.spans;
    const auto& r = state.region();
    Columns columns;
    Lines lines;
    for (Span& s : spans)
        for (std::size_t i = 0; i < s.points.size(); ++i) {
            const bool moves = columns.add(s.points[i]) && i > 0;
            if (moves && in_layer(s, i - 1, r.paths.z - toolpath::kLevel * r.paths.height))
                lines.add(s.points[i - 1].xy(), s.points[i].xy(), columns.last(), !toolpath::fills(s.role));
        }
    const auto given = lines.curves;
    const auto left = toolpath::part_crossings(lines.curves, r.width, toolpath::on_grid(columns.points.front()->xy()));
    for (std::size_t c = 0; c < given.size(); ++c)
        for (std::size_t i = 0; i < given[c].points.size(); ++i)
            if (lines.curves[c].points[i] != given[c].points[i])
                columns.move(lines.first[c] + i, lines.curves[c].points[i]);
    const auto crossed =
        std::count_if(left.begin(), left.end(), [&](auto p) { return lines.join[p.first] || lines.join[p.second]; });
    if (crossed == 0) return;
    const Vec2 at = spans.front().points.back().xy();
    state.notes.push_back({NoteCode::jog_crosses_bead, static_cast<double>(crossed),
                           static_cast<std::uint64_t>(crossed), r.paths.layer, at.x, at.y});
}

} // namespace filum::link3d
