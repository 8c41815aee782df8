#include "surfpath/rows/loops.hpp"

#include "geom/point_grid.hpp"
#include "surface/curve/ease.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/lanes/spiral.hpp"
#include "surfpath/rows/double_spirals.hpp"
#include "surfpath/rows/exchange.hpp"
#include "surfpath/rows/splice.hpp"
#include "surfpath/rows/winding.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace filum::surfpath::rows {

namespace {

// A ladder on which closed lines can be connected to a spiral, with gentle links if there is room. It covers fewer
// lanes if no place leads across all lines.
lanes::Ladder spiral_over(const lanes::Lanes& lanes, const LoopOptions& o) {
    lanes::Ladder out = lanes::spiral_ladder(lanes, 0, rules::shift_length(o.gentle, o.spacing));
    if (out.lanes() < lanes.size() && o.radius < o.gentle)
        out = lanes::spiral_ladder(lanes, 0, rules::shift_length(o.radius, o.spacing));
    return out;
}

// Per row whether it belongs to a chain of closed rows that becomes a spiral. A spiral costs at most one cut. As part
// of a neighbouring line each ring costs a join, at most as much as a pair of crossing shifts. So long chains become
// spirals, and also chains that are all of their component, which cost no cut. If joins may be tight, the latter
// become spirals only if one ladder leads across all of their rings.
std::vector<char> wound(const Surface& s, const Rows& found, std::span<const std::size_t> chain, const LoopOptions& o) {
    std::map<std::uint32_t, std::vector<std::size_t>> in_component;
    const auto component = [&](std::size_t i) { return s.component[found.rows[i].line.places[0].triangle]; };
    for (std::size_t i = 0; i < chain.size(); ++i) in_component[component(i)].push_back(i);
    std::vector<char> out;
    for (std::size_t i = 0; i < chain.size(); ++i)
        out.push_back(kCrossingWastes * o.spacing * static_cast<double>(chain[i]) > o.cut ? 1 : 0);
    for (const auto& [number, which] : in_component) {
        const auto is_all = [&, all = which.size()](std::size_t i) { return chain[i] == all; };
        if (!std::all_of(which.begin(), which.end(), is_all)) continue;
        bool spiral = true;
        if (o.tight && which.size() > 1) {
            std::vector<Line> lines;
            for (const std::size_t i : which) lines.push_back(found.rows[i].line);
            spiral = spiral_over(lanes::Lanes(s, lines, o.spacing), o).lanes() == lines.size();
        }
        if (spiral)
            for (const std::size_t i : which) out[i] = 1;
    }
    return out;
}

// Sets the levels of closed rows by which wind() recognises chains. Returns the size of each row's chain.
std::vector<std::size_t> level_rows(const Surface& s, Rows& found, double spacing) {
    std::vector<UnclippedLine> rings;
    for (std::size_t i = 0; i < found.rows.size(); ++i)
        rings.push_back({std::move(found.rows[i].line), spacing * static_cast<double>(i)});
    auto out = level_rings(s, rings, spacing);
    for (std::size_t i = 0; i < rings.size(); ++i) {
        found.rows[i].line = std::move(rings[i].line);
        found.rows[i].level = rings[i].level;
    }
    return out;
}

// The rows as points, to measure how much of a line overlaps them.
class RowPoints {
  public:
    RowPoints(const Rows& rows, double spacing) : spacing_(spacing) {
        for (const Row& row : rows.rows)
            for (const Place& p : surface::curve::resampled(row.line, rules::kGrain * spacing).places)
                points_.push_back(p.point);
        grid_ = geom::PointGrid<Vec3>(points_, spacing / 2);
    }

    // Length of the line that would overlap rows, mm.
    [[nodiscard]] double on_rows(const Line& line) const {
        double out = 0;
        for (const Place& p : surface::curve::resampled(line, 2 * rules::kGrain * spacing_).places) {
            bool near = false;
            grid_.near(p.point, 1,
                       [&](std::uint32_t i) { near = near || distance(points_[i], p.point) < spacing_ / 2; });
            out += near ? 2 * rules::kGrain * spacing_ : 0;
        }
        return out;
    }

  private:
    double spacing_;
    std::vector<Vec3> points_;
    geom::PointGrid<Vec3> grid_;
};

// The way along the ring of the inset from a row's end to its begin: of both directions the one that overlaps rows
// less; ties: the shorter one.
Line way_back(const Surface& s, const Row& row, const Inset& inset, const RowPoints& points) {
    const Line& ring = inset.rings[row.end.ring];
    const auto& ways = inset.ways[row.end.ring];
    const double from = row.end.way, to = row.begin.way, all = ways.back();
    Line ahead = surface::curve::part(ring, ways, from, to < from ? to + all : to);
    Line back = surface::curve::part(ring, ways, to, from < to ? from + all : from);
    surface::curve::reverse(back);
    const auto cost = [&](const Line& l) { return std::pair(points.on_rows(l), surface::curve::length(l)); };
    return surface::curve::threaded(s, cost(ahead) <= cost(back) ? ahead : back);
}

Line closed_by(const Surface& s, const Row& row, const Line& way, const Inset& inset, double radius) {
    Line out = row.line;
    surface::curve::append(out, way);
    out.places.pop_back(); // equal to the first one
    out.closed = true;
    return surface::curve::ease(s, out, {.radius = radius, .corridor = inset.half / 2}).line;
}

// Closes rows along the inset. Returns per remaining row its state before if it was closed by a way that mostly
// overlaps rows; otherwise an empty row.
std::vector<Row> close_rows(const Surface& s, Rows& rows, const LoopOptions& o) {
    const RowPoints points(rows, o.spacing);
    std::vector<std::size_t> ends(rows.inset.rings.size(), 0);
    for (const Row& row : rows.rows)
        if (!row.line.closed)
            for (const RingPlace* p : {&row.begin, &row.end})
                if (p->ring != surface::kNone) ++ends[p->ring];
    std::vector<Row> kept, before;
    for (Row& row : rows.rows) {
        Row open;
        const std::uint32_t ring = row.begin.ring;
        const bool comes_back =
            !row.line.closed && ring != surface::kNone && ring == row.end.ring && rows.inset.rings[ring].closed;
        const double l = surface::curve::length(row.line);
        if (comes_back && l >= 2 * o.radius) {
            const Line way = way_back(s, row, rows.inset, points);
            const double twice = points.on_rows(way);
            Line loop = closed_by(s, row, way, rows.inset, o.radius);
            if (twice <= o.cut && (ends[ring] <= 2 || surface::curve::length(loop) - l <= 2 * o.radius)) {
                if (2 * twice > surface::curve::length(way)) open = row;
                row.line = std::move(loop);
                row.begin = row.end = {};
            }
        } else if (comes_back && ends[ring] <= 2) {
            rows.drop(row.line);
            continue;
        }
        kept.push_back(std::move(row));
        before.push_back(std::move(open));
    }
    rows.rows = std::move(kept);
    return before;
}

// If all rows of a component are closed and nested, connects them to a spiral along one ladder: it begins with all of
// the first ring and ends with all of the last. Without such a ladder they stay as they are, with the shorter end
// first, because wind() leaves a wedge of half a lap void where it begins.
void spiral(const Surface& s, Rows& rows, const LoopOptions& o) {
    std::map<std::uint32_t, std::vector<std::size_t>> in_component;
    for (std::size_t i = 0; i < rows.rows.size(); ++i)
        in_component[s.component[rows.rows[i].line.places[0].triangle]].push_back(i);
    for (const auto& [component, which] : in_component) {
        std::vector<Line> lines;
        for (const std::size_t i : which)
            if (rows.rows[i].line.closed) lines.push_back(rows.rows[i].line);
        if (lines.size() < std::max<std::size_t>(2, which.size())) continue;
        if (surface::curve::length(lines.front()) > surface::curve::length(lines.back()))
            for (const std::size_t i : which) rows.rows[i].level *= -1;
        const lanes::Lanes lanes(s, lines, o.spacing);
        lanes::LinkedLanes linked(lanes);
        const lanes::Ladder ladder = spiral_over(lanes, o);
        if (ladder.lanes() < lines.size()) continue;
        lanes::shift(linked, lanes, ladder, 1, o.radius);
        auto curves = linked.curves();
        if (curves.size() != 1 || curves[0].closed) continue;
        rows.rows[which[0]].line = std::move(curves[0].line);
        for (std::size_t i = 1; i < which.size(); ++i) rows.rows[which[i]].line.places.clear();
    }
    std::erase_if(rows.rows, [](const Row& row) { return row.line.size() == 0; });
}

// Joins closed lines to neighbouring lines, without crossings where possible.
LoopJoins join(const Surface& s, std::vector<Line>& lines, const std::vector<char>& keep, double ends,
               const LoopOptions& o) {
    LoopJoins out;
    const auto cross = [&](double radius) {
        const auto more = splice_loops(s, lines, keep, o.spacing, radius);
        out.crossed.insert(out.crossed.end(), more.begin(), more.end());
    };
    const auto exchange = [&](double radius) {
        for (ExchangeResult more{1, 0}; more.count > 0;) { // a line that was in the way may now be one to join
            more = exchange_loops(s, lines, keep, {o.spacing, ends, radius});
            out.exchanged += more.count;
            out.waste += more.waste;
        }
    };
    if (o.tight && o.nearest < 1) exchange(o.radius);
    if (!o.tight || o.nearest < 1) cross(o.radius);
    exchange(0);
    for (const double share : rules::kRadiusShares) cross(share * o.radius);
    out.waste += kCrossingWastes * o.spacing * o.spacing * static_cast<double>(out.crossed.size());
    return out;
}

// Winds chains of closed lines, which levels of rows show, into double spirals. Returns the number of lines taken in.
std::size_t wind_chains(const Surface& s, const Rows& rows, const std::vector<char>& keep, std::vector<Line>& lines,
                        const LoopOptions& o) {
    std::map<double, std::size_t> by_level;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (lines[i].closed && keep[i] == 0) by_level[rows.rows[i].level] = i;
    std::size_t out = 0;
    std::vector<Line*> chain;
    double last = 0;
    for (const auto& [level, i] : by_level) {
        if (!chain.empty() && level - last > 1.5 * o.spacing) out += wind_double(s, std::exchange(chain, {}), o);
        chain.push_back(&lines[i]);
        last = level;
    }
    return out + wind_double(s, std::move(chain), o);
}

} // namespace

LoopJoins join_loops(const Surface& s, Rows& rows, const LoopOptions& o) {
    auto open = close_rows(s, rows, o);
    const auto keep = wound(s, rows, level_rows(s, rows, o.spacing), o);
    std::vector<Line> lines;
    std::vector<double> length;
    for (Row& row : rows.rows) {
        length.push_back(surface::curve::length(row.line));
        lines.push_back(std::move(row.line));
    }
    const std::size_t wound_double = o.tight ? wind_chains(s, rows, keep, lines, o) : 0;
    auto out = join(s, lines, keep, rules::kTurnReach * o.radius, o);
    out.exchanged += wound_double;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        Row& row = rows.rows[i];
        row.line = std::move(lines[i]);
        // A row that is still a closed loop has gained nothing from a way back that overlaps rows, unless it becomes a
        // spiral.
        const bool alone = keep[i] == 0 && row.line.closed && surface::curve::length(row.line) == length[i];
        if (alone && open[i].line.size() > 0) row = std::move(open[i]);
    }
    std::erase_if(rows.rows, [](const Row& row) { return row.line.size() == 0; });
    level_rows(s, rows, o.spacing);
    const auto by_level = [&] {
        std::stable_sort(rows.rows.begin(), rows.rows.end(),
                         [](const Row& a, const Row& b) { return a.level < b.level; });
    };
    by_level();
    spiral(s, rows, o);
    by_level();
    wind(s, rows, o.spacing, false);
    return out;
}

namespace {

// A stroke as one line, closed by a straight line if its ends are at most `reach` mm apart.
Line whole(const Surface& s, const plan::Stroke& stroke, double reach) {
    Line out;
    for (const plan::Section& piece : stroke.sections) {
        if (out.size() == 0)
            out = piece.line;
        else
            surface::curve::append(out, piece.line);
    }
    if (out.size() < 2 || distance(out[0], out.places.back().point) > reach) return out;
    const Line over = surface::curve::join(s, out.places.back(), out.places.front());
    if (!surface::curve::leads(s, over)) return out;
    surface::curve::append(out, over);
    out.places.pop_back(); // equal to the first one
    out.closed = true;
    return out;
}

// Per line whether it is not to be taken in: the longest open line of each component, or the longest loop if none is
// open.
std::vector<char> hosts(const Surface& s, const std::vector<Line>& lines) {
    std::map<std::uint32_t, std::size_t> best;
    const auto rank = [&](std::size_t i) { return std::pair(!lines[i].closed, surface::curve::length(lines[i])); };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].size() == 0) continue;
        const auto [at, first] = best.emplace(s.component[lines[i].places[0].triangle], i);
        if (!first && rank(i) > rank(at->second)) at->second = i;
    }
    std::vector<char> out(lines.size(), 0);
    for (const auto& [component, i] : best) out[i] = 1;
    return out;
}

} // namespace

LoopJoins join_strokes(const Surface& s, std::vector<plan::Stroke>& strokes, const LoopOptions& o) {
    if (strokes.size() < 2) return {};
    std::vector<Line> lines;
    std::vector<double> before;
    for (const plan::Stroke& stroke : strokes) {
        lines.push_back(whole(s, stroke, 2 * o.radius));
        before.push_back(surface::curve::length(lines.back()));
    }
    auto joined = join(s, lines, hosts(s, lines), o.spacing, o);
    std::vector<plan::Stroke> out;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].size() == 0) continue;
        if (surface::curve::length(lines[i]) == before[i]) {
            out.push_back(std::move(strokes[i]));
            continue;
        }
        if (lines[i].closed) lines[i].places.push_back(lines[i].places.front());
        lines[i].closed = false;
        out.push_back({{{std::move(lines[i]), false}}});
    }
    strokes = std::move(out);
    return joined;
}

void report_crossings(const std::vector<Vec3>& crossed, double spacing, Notes& notes) {
    if (!crossed.empty())
        notes.push_back({NoteCode::loop_by_crossing, spacing * spacing * static_cast<double>(crossed.size()),
                         crossed.size(), -1, crossed[0].x, crossed[0].y, crossed[0].z});
}

} // namespace filum::surfpath::rows
