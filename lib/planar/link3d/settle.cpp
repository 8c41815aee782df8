#include "link3d/settle.hpp"

#include "toolpath/grid.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

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
    Vec2 place;                     // of the last one, on the grid

    // Adds a point; returns whether it begins a column.
    bool add(Vec3& p) {
        const Vec2 there = toolpath::on_grid(p.xy());
        const bool begins = points.empty() || place != there;
        if (begins) begin.push_back(points.size());
        points.push_back(&p);
        place = there;
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
    std::vector<char> join, fresh; // per segment: a join; no segment of the given curves

    // Adds the segment that ends at `column`; points are on the grid.
    void add(Vec2 from, Vec2 to, std::size_t column, bool is_join) {
        if (curves.empty() || first.back() + curves.back().points.size() != column) {
            curves.push_back({false, {from}, {1}});
            first.push_back(column - 1);
        }
        curves.back().points.push_back(to);
        join.push_back(is_join ? 1 : 0);
    }
};

// Recognises the segments of given curves when they come one after the other, in either direction, with others in
// between. It may miss some where these are many, since a search for the place to go on is limited.
class GivenSegments {
  public:
    explicit GivenSegments(std::span<const Curve> curves) {
        for (const Curve& c : curves) {
            const auto first = static_cast<std::uint32_t>(points_.size()),
                       n = static_cast<std::uint32_t>(c.points.size());
            points_.insert(points_.end(), c.points.begin(), c.points.end());
            for (std::uint32_t i = 0; i < n; ++i) {
                const bool ends = i + 1 == n, begins = i == 0;
                beside_[0].push_back(first + (ends ? (c.closed ? 0 : i) : i + 1));
                beside_[1].push_back(first + (begins ? (c.closed ? n - 1 : i) : i - 1));
            }
        }
        left_ = kLaps * points_.size();
    }
    bool hold(Vec2 a, Vec2 b) {
        if (points_.empty() || go_on(at_, a, b)) return !points_.empty();
        for (std::size_t k = 0; k < points_.size() && left_ > 0; ++k, --left_)
            if (go_on(at_ + k < points_.size() ? at_ + k : at_ + k - points_.size(), a, b)) return true;
        return false;
    }

  private:
    static constexpr std::size_t kLaps = 8; // of all points that searches may take

    // Whether the segment from point i in one of both directions is a-b; if so, the next one is expected there.
    bool go_on(std::size_t i, Vec2 a, Vec2 b) {
        if (points_[i] != a) return false;
        for (const auto& beside : beside_)
            if (beside[i] != i && points_[beside[i]] == b) {
                at_ = beside[i];
                return true;
            }
        return false;
    }

    std::vector<Vec2> points_;
    std::array<std::vector<std::uint32_t>, 2> beside_; // per point: the next one and the one before; itself: none
    std::size_t at_ = 0, left_ = 0;
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
    GivenSegments known(r.paths.curves);
    for (Span& s : spans)
        for (std::size_t i = 0; i < s.points.size(); ++i) {
            const Vec2 from = columns.place;
            const bool moves = columns.add(s.points[i]) && i > 0;
            if (!moves || !in_layer(s, i - 1, r.paths.z - toolpath::kLevel * r.paths.height)) continue;
            lines.add(from, columns.place, columns.last(), !toolpath::fills(s.role));
            lines.fresh.push_back(known.hold(from, columns.place) ? 0 : 1);
        }
    const auto given = lines.curves;
    const Vec2 fixed = toolpath::on_grid(columns.points.front()->xy());
    const auto left = toolpath::part_crossings(lines.curves, r.width, fixed, lines.fresh);
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
