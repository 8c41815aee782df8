#include "metrics/planar/cover_tiles.hpp"

#include "geom/capsule_tree.hpp"
#include "metrics/planar/strips.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace filum::metrics::planar {

namespace {

using geom::Box2;

constexpr double kManyRows = 200;     // per bead: fewer are swept faster than tiles are made
constexpr double kFewSections = 1024; // of rows with beads: sweeping them takes as long as dividing the tile
constexpr std::size_t kFewRows = 16;  // a tile as high as this is not divided further
// Shares of a tile at which a probe lies, and by which the first tile is too wide. They are odd ones, so that no probe
// and no side lies on a corner of an outline.
constexpr Vec2 kProbe{0.4871, 0.5237};

// Keeps what lies between the left and the right side of a box.
void clip(std::vector<Interval>& row, const Box2& box) {
    for (Interval& i : row) {
        i.lo = std::max(i.lo, box.lo.x);
        i.hi = std::min(i.hi, box.hi.x);
        i.slot = 0;
    }
    std::erase_if(row, [](const Interval& i) { return i.lo >= i.hi; });
}

std::vector<SweptBead> chosen(std::span<const SweptBead> beads, const std::vector<std::uint32_t>& which) {
    std::vector<SweptBead> out;
    out.reserve(which.size());
    for (const std::uint32_t i : which) out.push_back(beads[i]);
    return out;
}

// A share of a layer: all rows from `first` to `last`, and the beads that may meet it.
struct Area {
    Box2 box;
    std::size_t first = 0, last = 0; // rows: those before `last`
};

bool small(const Area& a, std::size_t items) {
    const std::size_t rows = a.last - a.first;
    return rows <= kFewRows || static_cast<double>(rows) * static_cast<double>(items) <= kFewSections;
}

double bottom(const Rows& rows, std::size_t row) { return rows.at(row) - rows.spacing / 2; }

// Half of an area: across its longer side, between rows if it is upright.
Area half_of(const Area& a, const Rows& rows, bool upper) {
    const Vec2 size = a.box.hi - a.box.lo;
    Area out = a;
    if (size.y >= size.x || size.x <= static_cast<double>(kFewRows) * rows.spacing) {
        const std::size_t middle = a.first + (a.last - a.first) / 2;
        (upper ? out.first : out.last) = middle;
        (upper ? out.box.lo : out.box.hi).y = bottom(rows, middle);
    } else {
        (upper ? out.box.lo : out.box.hi).x = a.box.lo.x + size.x * kProbe.x;
    }
    return out;
}

void add_box(const SweptBead& b, Box2& box) {
    box.add({std::min(b.lower.x, b.upper.x) - b.half, b.lo});
    box.add({std::max(b.lower.x, b.upper.x) + b.half, b.hi});
}

// Those of the beads that may meet the box.
std::vector<std::uint32_t> in_box(std::span<const SweptBead> beads, const std::vector<std::uint32_t>& of,
                                  const Box2& box) {
    std::vector<std::uint32_t> out;
    for (const std::uint32_t i : of)
        if (geom::may_meet({beads[i].lower, beads[i].upper, beads[i].half}, box)) out.push_back(i);
    return out;
}

std::vector<std::uint32_t> all_of(std::size_t count) {
    std::vector<std::uint32_t> out(count);
    std::iota(out.begin(), out.end(), 0U);
    return out;
}

struct Tile {
    Area area;
    Vec2 probe;          // a place in the tile,
    bool inside = false; // and whether it is inside the outline
    std::vector<std::uint32_t> beads, edges;
};

class TileCover {
  public:
    TileCover(std::span<const SweptBead> beads, std::span<const OutlineEdge> edges, const Rows& rows)
        : beads_(beads), edges_(edges), rows_(rows) {}

    Cover run() {
        std::vector<Tile> open{whole()};
        while (!open.empty()) {
            const Tile tile = std::move(open.back());
            open.pop_back();
            if (passed(tile)) continue;
            if (small(tile.area, tile.beads.size() + tile.edges.size()))
                sweep(tile);
            else
                for (const bool upper : {false, true}) open.push_back(half(tile, upper));
        }
        return sum_;
    }

  private:
    [[nodiscard]] Tile whole() const {
        Box2 box;
        for (const SweptBead& b : beads_) add_box(b, box);
        for (const OutlineEdge& e : edges_) {
            box.add(e.lo);
            box.add(e.hi);
        }
        const double wider = kProbe.x * rows_.spacing;
        box.lo = {box.lo.x - wider, bottom(rows_, 0)};
        box.hi = {box.hi.x + wider, bottom(rows_, rows_.count)};
        return {{box, 0, rows_.count}, box.lo, false, all_of(beads_.size()), all_of(edges_.size())};
    }

    [[nodiscard]] Tile half(const Tile& tile, bool upper) const {
        Tile out{half_of(tile.area, rows_, upper), {}, false, {}, {}};
        const Box2& box = out.area.box;
        out.beads = in_box(beads_, tile.beads, box);
        for (const std::uint32_t i : tile.edges)
            if (geom::may_meet({edges_[i].lo, edges_[i].hi, 0}, box)) out.edges.push_back(i);
        const Vec2 size = box.hi - box.lo;
        out.probe = box.lo + Vec2{kProbe.x * size.x, kProbe.y * size.y};
        out.inside = inside(tile, out.probe);
        return out;
    }

    // Whether a place in the tile is inside the outline: the way there from the probe crosses edges of the tile only.
    [[nodiscard]] bool inside(const Tile& tile, Vec2 p) const {
        bool out = tile.inside;
        for (const std::uint32_t i : tile.edges) {
            const Vec2 a = edges_[i].lo, b = edges_[i].hi;
            const bool between = (geom::orient(tile.probe, p, a) > 0) != (geom::orient(tile.probe, p, b) > 0);
            if (between && (geom::orient(a, b, tile.probe) > 0) != (geom::orient(a, b, p) > 0)) out = !out;
        }
        return out;
    }

    // Adds a tile that no outline crosses and that beads only pass. Returns whether it is one.
    bool passed(const Tile& tile) {
        if (!tile.edges.empty()) return false;
        const Box2& box = tile.area.box;
        double united = 0;
        if (!tile.beads.empty()) {
            const auto all = strips(beads_, tile.beads, box);
            if (!all || !side_by_side(all->strip)) return false;
            each_part(*all, box, [&](const Convex& part, int sign) { united += sign * part.area(); });
        }
        const Vec2 size = box.hi - box.lo;
        sum_.united += united;
        if (tile.inside) {
            sum_.area += size.x * size.y;
            sum_.covered += united;
        }
        return true;
    }

    // The stretches of the row at y in the tile that are inside the outline.
    void part_row(const Tile& tile, double y, std::vector<Interval>& out) {
        crossing_.clear();
        const double left = tile.area.box.lo.x, right = tile.area.box.hi.x;
        for (const std::uint32_t i : tile.edges) {
            const OutlineEdge& e = edges_[i];
            if (e.lo.y >= y || e.hi.y < y) continue;
            const double x = e.lo.x + (e.hi.x - e.lo.x) * ((y - e.lo.y) / (e.hi.y - e.lo.y));
            if (x > left && x < right) crossing_.push_back(x);
        }
        std::sort(crossing_.begin(), crossing_.end());
        out.clear();
        bool in = inside(tile, {left, y});
        double from = left;
        for (const double x : crossing_) {
            if (in) out.push_back({from, x, 0});
            from = x;
            in = !in;
        }
        if (in) out.push_back({from, right, 0});
    }

    void sweep(const Tile& tile) {
        const std::vector<SweptBead> beads = chosen(beads_, tile.beads);
        RowSweep sweep(beads);
        std::vector<Interval> part, laid;
        for (std::size_t row = tile.area.first; row < tile.area.last; ++row) {
            sweep.move_to(rows_.at(row), laid);
            clip(laid, tile.area.box);
            part_row(tile, rows_.at(row), part);
            tally(part, laid, rows_.spacing, {&sum_, 1});
        }
    }

    std::span<const SweptBead> beads_;
    std::span<const OutlineEdge> edges_;
    Rows rows_;
    Cover sum_;
    std::vector<double> crossing_; // of a row
};

// The area under some beads and not under others.
class TilesUncovered {
  public:
    TilesUncovered(std::span<const SweptBead> upper, std::span<const SweptBead> lower, const Rows& rows)
        : upper_(upper), lower_(lower), rows_(rows) {}

    double run() {
        Box2 box;
        for (const SweptBead& b : upper_) add_box(b, box);
        box.lo.y = bottom(rows_, 0);
        box.hi.y = bottom(rows_, rows_.count);
        std::vector<Pair> open{{{box, 0, rows_.count}, all_of(upper_.size()), all_of(lower_.size())}};
        while (!open.empty()) {
            const Pair tile = std::move(open.back());
            open.pop_back();
            if (tile.upper.empty() || passed(tile)) continue;
            if (small(tile.area, tile.upper.size() + tile.lower.size())) {
                sweep(tile);
                continue;
            }
            for (const bool high : {false, true}) {
                const Area half = half_of(tile.area, rows_, high);
                open.push_back({half, in_box(upper_, tile.upper, half.box), in_box(lower_, tile.lower, half.box)});
            }
        }
        return sum_;
    }

  private:
    struct Pair {
        Area area;
        std::vector<std::uint32_t> upper, lower;
    };

    // Adds a tile that beads of both kinds only pass. Returns whether it is one.
    bool passed(const Pair& tile) {
        const Box2& box = tile.area.box;
        const auto above = strips(upper_, tile.upper, box);
        if (!above || !side_by_side(above->strip)) return false;
        std::optional<Strips> below;
        if (!tile.lower.empty()) {
            below = strips(lower_, tile.lower, box);
            if (!below || !merge(below->strip)) return false;
        }
        each_part(*above, box, [&](const Convex& part, int sign) {
            sum_ += sign * part.area();
            if (!below) return;
            for (const Strip& s : below->strip)
                sum_ -= sign * part.left_of(below->point(below->near, s.lo[0]), below->point(below->far, s.lo[1]))
                                   .left_of(below->point(below->far, s.hi[1]), below->point(below->near, s.hi[0]))
                                   .area();
        });
        return true;
    }

    void sweep(const Pair& tile) {
        const auto upper = chosen(upper_, tile.upper), lower = chosen(lower_, tile.lower);
        RowSweep above(upper), below(lower);
        std::vector<Interval> up, low;
        for (std::size_t row = tile.area.first; row < tile.area.last; ++row) {
            above.move_to(rows_.at(row), up);
            below.move_to(rows_.at(row), low);
            clip(up, tile.area.box);
            for (const Interval& i : up) sum_ += (i.hi - i.lo) * rows_.spacing;
            sum_ -= shared_length(up, low) * rows_.spacing;
        }
    }

    std::span<const SweptBead> upper_, lower_;
    Rows rows_;
    double sum_ = 0; // mm2
};

} // namespace

bool tiles_pay(std::span<const SweptBead> beads, const Rows& rows) {
    double met = 0;
    for (const SweptBead& b : beads) met += (b.hi - b.lo) / rows.spacing;
    return met > kManyRows * static_cast<double>(beads.size());
}

double uncovered_by_tiles(std::span<const SweptBead> beads, std::span<const SweptBead> below, const Rows& rows) {
    return TilesUncovered(beads, below, rows).run();
}

Cover cover_by_tiles(std::span<const SweptBead> beads, std::span<const OutlineEdge> edges, const Rows& rows) {
    return TileCover(beads, edges, rows).run();
}

} // namespace filum::metrics::planar
