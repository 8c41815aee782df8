#include "fill/rows/maze.hpp"

#include "geom/disjoint_sets.hpp"
#include "geom/segment_grid.hpp"
#include "polygon/clip.hpp"
#include "polygon/segments.hpp"
#include "polygon/stretches.hpp"
#include "polygon/strips.hpp"
#include "toolpath/merge.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace filum::fill::rows {

using geom::Vec2;
using polygon::Loops;
using toolpath::kLeastMove; // mm, thickness of a wall: just enough to separate two areas

namespace {

constexpr double kRowGive = 0.2; // share by which the height of a row may differ
constexpr double kOpen = 2.0;    // bead widths that an opening needs
constexpr double kDoor = 0.95;   // share of kOpen that a door's narrowest place keeps clear

// Where two rows meet.
struct Border {
    std::size_t line;
    double from, to;
    std::uint32_t below, above; // cells
    std::vector<polygon::LevelStretch> walls;
};

// A level edge of one row along a cut.
struct Side {
    double from, to;
    std::uint32_t cell;
};

// Calls f(i, j, from, to) where stretch i of a and stretch j of b, both ascending, lie side by side.
template <class A, class B, class F>
void each_common(const std::vector<A>& a, const std::vector<B>& b, F&& f) {
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size(); a[i].to < b[j].to ? ++i : ++j)
        f(i, j, std::max(a[i].from, b[j].from), std::min(a[i].to, b[j].to));
}

std::vector<polygon::LevelStretch> clipped(const std::vector<polygon::LevelStretch>& a,
                                           const std::vector<polygon::LevelStretch>& b) {
    std::vector<polygon::LevelStretch> out;
    each_common(a, b, [&](std::size_t, std::size_t, double from, double to) {
        if (from < to) out.push_back({from, to});
    });
    return out;
}

class Maze {
  public:
    Maze(const Loops& region, double width, double row)
        : region_(region), width_(width), y_(polygon::strip_bounds(region, row, kRowGive)),
          outline_(polygon::segments(region)), grid_(outline_, 2 * width) {}

    Loops build() {
        if (y_.size() <= 2) return region_;
        find_borders();
        find_walls();
        open_doors();
        return walled();
    }

  private:
    // Cuts the region into rows; borders are where a row's upper side meets the lower side of one in the next strip.
    void find_borders() {
        const auto box = polygon::bounds(region_);
        Loops bands;
        for (std::size_t i = 0; i + 1 < y_.size(); ++i) {
            const double lo = y_[i] + kLeastMove / 2, hi = y_[i + 1] - kLeastMove / 2, l = box.lo.x - 1,
                         r = box.hi.x + 1;
            bands.add(std::vector<Vec2>{{l, lo}, {r, lo}, {r, hi}, {l, hi}});
        }
        const Loops rows = polygon::intersect(region_, bands);
        cells_ = rows.size(); // a hole inside a row counts as a cell of its own, without borders
        std::vector<std::vector<Side>> under(y_.size()), over(y_.size());
        for (std::uint32_t c = 0; c < rows.size(); ++c)
            for (std::size_t k = 0; k < rows[c].size(); ++k) {
                const Vec2 a = rows[c][k], b = rows[c][(k + 1) % rows[c].size()];
                if (a.y != b.y) continue;
                const auto line =
                    static_cast<std::size_t>(std::lower_bound(y_.begin(), y_.end(), a.y - kLeastMove) - y_.begin());
                if (line == y_.size() || std::abs(y_[line] - a.y) > kLeastMove) continue;
                (a.y < y_[line] ? under : over)[line].push_back({std::min(a.x, b.x), std::max(a.x, b.x), c});
            }
        for (std::size_t line = 1; line + 1 < y_.size(); ++line) meet(line, under[line], over[line]);
    }

    void meet(std::size_t line, std::vector<Side>& under, std::vector<Side>& over) {
        const auto left = [](const Side& a, const Side& b) { return a.from < b.from; };
        std::sort(under.begin(), under.end(), left);
        std::sort(over.begin(), over.end(), left);
        each_common(under, over, [&](std::size_t i, std::size_t j, double from, double to) {
            if (to - from > kLeastMove) borders_.push_back({line, from, to, under[i].cell, over[j].cell, {}});
        });
    }

    // Sets walls along the borders, except on long stretches that have no room for a bead beside them.
    void find_walls() {
        std::vector<std::vector<std::vector<polygon::LevelStretch>>> clear;
        for (const double by : {-1.0, -0.5, 0.5, 1.0}) {
            std::vector<double> y = y_;
            for (double& v : y) v += by * width_;
            clear.push_back(polygon::scan(region_, y));
        }
        for (Border& b : borders_) {
            std::vector<polygon::LevelStretch> walls{{b.from, b.to}};
            for (const auto& c : clear) walls = clipped(walls, c[b.line]);
            b.walls = without_gaps(walls, b);
        }
    }

    // Closes openings too narrow for two beads. Then drops walls shorter than a bead, which guide no bead.
    [[nodiscard]] std::vector<polygon::LevelStretch> without_gaps(const std::vector<polygon::LevelStretch>& walls,
                                                                  const Border& b) const {
        std::vector<polygon::LevelStretch> out;
        if (walls.empty()) return out;
        double from = walls.front().from - b.from < kOpen * width_ ? b.from : walls.front().from;
        double to = from;
        for (const polygon::LevelStretch& s : walls) {
            if (s.from - to >= kOpen * width_ && to > from) {
                out.push_back({from, to});
                from = s.from;
            }
            to = s.to;
        }
        if (b.to - to < kOpen * width_) to = b.to;
        out.push_back({from, to});
        std::erase_if(out, [&](const polygon::LevelStretch& s) {
            return s.to - s.from < width_ && s.from > b.from && s.to < b.to;
        });
        return out;
    }

    // Builds a spanning tree of the rows: from open borders first, then from doors, in wide borders before narrow ones.
    void open_doors() {
        geom::DisjointSets rows(cells_);
        for (const Border& b : borders_)
            if (b.walls.size() != 1 || b.walls[0].from > b.from || b.walls[0].to < b.to) rows.unite(b.below, b.above);
        for (const bool narrow : {false, true})
            for (Border& b : borders_) {
                if (rows.root(b.below) == rows.root(b.above) || (b.to - b.from >= kOpen * width_) == narrow) continue;
                rows.unite(b.below, b.above);
                b.walls = door(b);
            }
    }

    // The remaining wall of a closed border once it has a door.
    [[nodiscard]] std::vector<polygon::LevelStretch> door(const Border& b) const {
        const double y = y_[b.line];
        if (const auto x = clear_from(b.from, b.to, y)) return {{*x, b.to}};
        if (const auto x = clear_from(b.to, b.from, y)) return {{b.from, *x}};
        return {};
    }

    // The first place from `end` towards `other` where two beads pass between the wall's tip and the outline.
    [[nodiscard]] std::optional<double> clear_from(double end, double other, double y) const {
        const double way = other > end ? 1 : -1, least = kDoor * kOpen * width_;
        for (double along = least; along <= 2 * kOpen * width_; along += width_ / 8) {
            if (along + width_ > std::abs(other - end)) break;
            const Vec2 tip{end + way * along, y};
            bool free = true;
            grid_.near({tip.x - least, tip.y - least}, {tip.x + least, tip.y + least}, [&](std::uint32_t i) {
                free = free && geom::point_segment_distance(outline_[i].a, outline_[i].b, tip) >= least - 1e-6;
            });
            if (free) return tip.x;
        }
        return std::nullopt;
    }

    [[nodiscard]] Loops walled() const {
        Loops slits;
        for (const Border& b : borders_)
            for (const polygon::LevelStretch& s : b.walls) {
                const double y = y_[b.line], lo = y - kLeastMove / 2, hi = y + kLeastMove / 2;
                // walls extend into the outline, so that no thread of area remains there
                const double l = s.from - (s.from == b.from ? 2 * kLeastMove : 0),
                             r = s.to + (s.to == b.to ? 2 * kLeastMove : 0);
                slits.add(std::vector<Vec2>{{l, lo}, {r, lo}, {r, hi}, {l, hi}});
            }
        return polygon::subtract(region_, slits);
    }

    const Loops& region_;
    double width_;
    std::vector<double> y_;
    std::vector<geom::Segment> outline_;
    geom::SegmentGrid grid_;
    std::size_t cells_ = 0;
    std::vector<Border> borders_;
};

} // namespace

Loops maze(const Loops& region, double bead_width, double row_height) {
    return Maze(region, bead_width, row_height).build();
}

} // namespace filum::fill::rows
