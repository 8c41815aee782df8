#include "fill/fill.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "fill/join/crossings.hpp"
#include "fill/rings/lanes.hpp"
#include "fill/rows/rectilinear.hpp"
#include "fill/rows/zigzag.hpp"
#include "fill/scaffold/scaffold.hpp"
#include "fill/spiral.hpp"
#include "fill/walls/single_lane.hpp"
#include "fill/walls/wall_walk.hpp"
#include "geom/angle.hpp"
#include "geom/polyline.hpp"
#include "toolpath/identify.hpp"

#include <algorithm>

namespace filum::fill {

namespace {

double angle(const polygon::Region& r, const Options& o) {
    if (o.angles_deg.empty()) return 0;
    return geom::radians(o.angles_deg[r.own_layer() % o.angles_deg.size()]);
}

double least_width(const Options& o) { return o.min_width > 0 ? o.min_width : o.bead_width / 4; }

int rings(const Options& o, int usual) { return o.rings < 0 ? usual : static_cast<int>(o.rings); }

// One pass along the walls of a region that is thin everywhere; no curves for other regions.
std::vector<toolpath::Curve> single_walls(const polygon::Region& r, double width, Notes& notes) {
    const auto graph = walls::wall_graph(r.loops, width);
    if (!graph) return {};
    walls::WallWalk walk = walls::wall_walk(*graph);
    if (walk.twice > 0) notes.push_back({NoteCode::wall_doubled, walk.twice, 1, -1, walk.at.x, walk.at.y});
    if (walk.curves.size() > 1)
        notes.push_back({NoteCode::wall_unjoined, static_cast<double>(walk.curves.size() - 1), walk.curves.size() - 1,
                         -1, walk.at.x, walk.at.y});
    return std::move(walk.curves);
}

// Opens the curve along the longest thin wall of the region. A note gives the length of the other thin walls.
void pass_one_wall_once(const polygon::Region& r, double width, toolpath::Curve& curve, Notes& notes) {
    const walls::WallGraph thin = walls::thin_walls(r.loops, width);
    const auto once = walls::pass_once(curve, thin, width);
    double twice = 0;
    geom::Vec2 at;
    for (std::size_t k = 0; k < thin.walls.size(); ++k)
        if (k != once) {
            twice += thin.walls[k].length;
            at = thin.walls[k].line.points.front();
        }
    if (twice > 0) notes.push_back({NoteCode::wall_doubled, twice, 1, -1, at.x, at.y});
}

std::vector<toolpath::Curve> by_spiral(const polygon::Region& r, const Options& o, double& unplaced, Notes& notes) {
    const double w = o.bead_width;
    if (o.thin == Thin::single)
        if (auto walls = single_walls(r, w, notes); !walls.empty()) return walls;
    Spiral s = spiral(r.loops, {.bead_width = w, .min_width = least_width(o), .min_radius = o.min_radius}, notes);
    unplaced = s.unplaced;
    if (o.thin == Thin::single && s.curves.size() == 1) pass_one_wall_once(r, w, s.curves[0], notes);
    return std::move(s.curves);
}

// The curves of all patterns except scaffold, which depends on earlier regions.
std::vector<toolpath::Curve> curves_by_pattern(const polygon::Region& r, const Options& o, double& unplaced,
                                               Notes& notes) {
    const double w = o.bead_width;
    const auto rows_within = [&](int outer, bool linked) {
        return rows::zigzag(r.loops, {.bead_width = w, .angle = angle(r, o), .rings = outer, .linked = linked}, notes,
                            &unplaced);
    };
    switch (o.pattern) {
    case Pattern::contour:
        return contour(r.loops, {.bead_width = w, .rings = rings(o, 0)});
    case Pattern::zigzag:
        return rows_within(0, true);
    case Pattern::spiral_zigzag:
        return rows_within(rings(o, 2), true);
    case Pattern::contour_zigzag:
        return rows_within(rings(o, 2), false);
    case Pattern::rectilinear:
        return rows::rectilinear(r.loops, {.bead_width = w, .angle = angle(r, o), .rings = rings(o, 0)}, notes);
    case Pattern::spiral:
    case Pattern::scaffold:
        break;
    }
    return by_spiral(r, o, unplaced, notes);
}

// Prints walls whose lanes would be narrower than the least width in two passes, one on the other.
void stack_thin_walls(const polygon::Region& r, const Options& o, Notes& notes, std::size_t first,
                      toolpath::RegionPaths& out) {
    if (out.curves.size() != 1) return;
    const double w = o.bead_width, least = least_width(o);
    out.stacked = walls::stack_lanes(out.curves[0], walls::thin_walls(r.loops, w), w, least);
    double length = 0;
    for (const auto& line : out.stacked) length += geom::length(line);
    for (std::size_t i = first; i < notes.size(); ++i) // stacked lanes are not narrow any more
        if (notes[i].code == NoteCode::bead_too_thin) notes[i].amount -= std::min(notes[i].amount, 2 * length);
    const auto from = notes.begin() + static_cast<std::ptrdiff_t>(first);
    notes.erase(std::remove_if(from, notes.end(),
                               [&](const Note& n) { return n.code == NoteCode::bead_too_thin && n.amount < w; }),
                notes.end());
}

// Sets the layer of the notes from index `first` on, and adds unreached areas to `unplaced`.
void place(const polygon::Region& r, Notes& notes, std::size_t first, toolpath::RegionPaths& out) {
    for (std::size_t i = first; i < notes.size(); ++i) {
        notes[i].layer = r.layer;
        if (notes[i].code == NoteCode::area_unreached) out.unplaced += notes[i].amount;
    }
}

// The index of the column that r belongs to. Adds a column if r begins one.
std::size_t column_of(const polygon::Region& r, ScaffoldState& before) {
    if (r.join == Join::vertical && !before.columns.empty()) return before.column;
    const auto box = polygon::bounds(r.loops[0]);
    const auto middle = geom::lerp(box.lo, box.hi, 0.5);
    for (std::size_t i = 0; i < before.columns.size(); ++i)
        if (geom::distance(before.columns[i].box, {middle, middle}) == 0) return i;
    before.columns.push_back({box, r.loops});
    return before.columns.size() - 1;
}

// True if the region has an area. Else adds a note: a region of crossing or reversed loops may have none.
bool has_area(const polygon::Region& r, Notes& notes) {
    if (polygon::signed_area(r.loops) > 0) return true;
    const geom::Vec2 at = r.loops.points.empty() ? geom::Vec2{} : r.loops.points.front();
    notes.push_back({NoteCode::region_without_area, 1, 1, -1, at.x, at.y});
    return false;
}

} // namespace

toolpath::RegionPaths fill(const polygon::Region& r, const Options& o, Notes& notes) {
    if (o.pattern == Pattern::scaffold) {
        ScaffoldState before;
        return fill_scaffold(r, o, before, notes);
    }
    toolpath::RegionPaths out;
    toolpath::identify(out, r);
    const std::size_t first = notes.size();
    if (has_area(r, notes)) out.curves = curves_by_pattern(r, o, out.unplaced, notes);
    if (o.thin == Thin::half_height && o.pattern == Pattern::spiral) stack_thin_walls(r, o, notes, first, out);
    if (o.pattern != Pattern::spiral)
        join::lay_on_grid(out.curves, o.bead_width, notes); // spiral curves are made and checked on the grid
    place(r, notes, first, out);
    return out;
}

toolpath::RegionPaths fill_by(const Lay& lay, const polygon::Region& r, Notes& notes) {
    toolpath::RegionPaths out;
    toolpath::identify(out, r);
    const std::size_t first = notes.size();
    if (has_area(r, notes)) out.curves = lay(r, notes);
    place(r, notes, first, out);
    return out;
}

Options with_pores(Options o, const scaffold::Pores& pores, double z) {
    if (!pores.given()) return o;
    const double width = o.bead_width;
    o.by_share = pores.by_share();
    o.spacing = pores.spacing(width, {0, 0, z}, !pores.within_layers());
    if (pores.within_layers())
        o.spacing_at = [&pores, width](const geom::Vec3& p, bool strict) { return pores.spacing(width, p, strict); };
    return o;
}

double strand_spacing(const Options& o) {
    const double spacing = o.spacing > 0 ? o.spacing : 2.5 * o.bead_width;
    if (spacing < o.bead_width)
        throw Error(Exit::usage, "cannot use '" + shortest_text(o.spacing) + "' for --spacing: strands " +
                                     shortest_text(o.bead_width) +
                                     " mm wide would overlap; make it larger than --bead-width");
    return spacing;
}

namespace {

// The options of the scaffold of a region, without the way from and to its neighbours.
scaffold::ScaffoldOptions scaffold_options(const polygon::Region& r, const Options& o,
                                           const ScaffoldState::Column& column) {
    const bool shifted = r.own_layer() / o.angles_deg.size() % 2 != 0;
    scaffold::ScaffoldOptions out{.bead_width = o.bead_width,
                                  .spacing = column.factor * strand_spacing(o),
                                  .angle = angle(r, o),
                                  .shift = shifted ? o.stagger : 0,
                                  .rings = rings(o, 0)};
    if (o.spacing_at)
        out.spacing_at = [at = o.spacing_at, factor = column.factor, z = r.z,
                          origin = geom::lerp(column.box.lo, column.box.hi, 0.5)](geom::Vec2 p) {
            return factor * at({p.x - origin.x, p.y - origin.y, z}, false);
        };
    return out;
}

// The share of endless strands in the area of a region: the mean of width / spacing. Throws Error(usage) if a place in
// the region has no spacing.
double endless_share(const polygon::Region& r, const Options& o, const ScaffoldState::Column& column) {
    if (!o.spacing_at) return o.bead_width / strand_spacing(o);
    constexpr int kSamples = 24; // per side of the box; formulas change little between them
    const geom::Vec2 origin = geom::lerp(column.box.lo, column.box.hi, 0.5), size = r.box.hi - r.box.lo;
    double sum = 0, count = 0;
    for (int i = 0; i < kSamples * kSamples; ++i) {
        const int row = i / kSamples, column_of_row = i % kSamples;
        const geom::Vec2 p =
            r.box.lo + geom::Vec2{size.x * (column_of_row + 0.5) / kSamples, size.y * (row + 0.5) / kSamples};
        if (!polygon::contains(r.loops, p)) continue;
        sum += o.bead_width / o.spacing_at({p.x - origin.x, p.y - origin.y, r.z}, true);
        ++count;
    }
    return count > 0 ? sum / count : o.bead_width / strand_spacing(o);
}

// Finds the factor on the spacings with which the region has the share of material of endless strands. Turns along the
// rim add material, and the number of strands is whole; so a lattice with the spacing of endless strands has too much.
// The mean of all angles counts.
void fit_share(const polygon::Region& r, const Options& o, ScaffoldState::Column& column) {
    constexpr int kHalvings = 12;        // to a thousandth of the factor
    constexpr std::uint32_t kRounds = 4; // of angles; later layers begin where others ended, and repeat other stretches
    const auto round = static_cast<std::uint32_t>(o.angles_deg.size());
    const double wanted = endless_share(r, o, column);
    const auto share = [&](double factor) {
        ScaffoldState::Column tried = column;
        tried.factor = factor;
        double material = 0;
        std::optional<geom::Vec2> from;
        for (std::uint32_t k = 0; k < kRounds * round; ++k) {
            polygon::Region layer = r;
            layer.layer = k;
            layer.skipped = 0;
            scaffold::ScaffoldOptions how = scaffold_options(layer, o, tried);
            how.from = from;
            Notes notes; // those of the region itself count
            const auto curves = scaffold::scaffold(r.loops, column.region, how, notes);
            if (!curves.empty()) from = curves.back().points.back();
            for (const auto& curve : curves)
                if (k >= round)
                    material += rings::laid_area(curve); // the first round does not begin where a layer ended
        }
        return material / static_cast<double>((kRounds - 1) * round) / r.area;
    };
    double dense = 0.5, open = 2; // factors: too much material, too little
    double least = std::abs(share(1) - wanted);
    column.factor = 1;
    for (int i = 0; i < kHalvings; ++i) {
        const double factor = (dense + open) / 2, got = share(factor);
        if (std::abs(got - wanted) < least) {
            least = std::abs(got - wanted);
            column.factor = factor;
        }
        (got > wanted ? dense : open) = factor;
    }
}

} // namespace

toolpath::RegionPaths fill_scaffold(const polygon::Region& region, const Options& options, ScaffoldState& before,
                                    Notes& notes, const polygon::Region* after) {
    Options o = options;
    if (o.angles_deg.empty()) o.angles_deg = {0, 90};
    const auto lay = [&](const polygon::Region& r, Notes& told) {
        before.column = column_of(r, before);
        ScaffoldState::Column& column = before.columns[before.column];
        if (o.spacing_at) endless_share(r, o, column); // refuses places without a spacing
        if (o.by_share && column.fitted != strand_spacing(o)) {
            fit_share(r, o, column);
            column.fitted = strand_spacing(o);
        }
        scaffold::ScaffoldOptions s = scaffold_options(r, o, column);
        if (r.join == Join::vertical) s.from = before.exit;
        if (after != nullptr && after->join == Join::vertical) s.above = &after->loops;
        auto curves = scaffold::scaffold(r.loops, column.region, s, told);
        join::lay_on_grid(curves, o.bead_width, told);
        return curves;
    };
    toolpath::RegionPaths out = fill_by(lay, region, notes);
    before.exit.reset();
    if (!out.curves.empty() && !out.curves.back().closed) before.exit = out.curves.back().points.back();
    return out;
}

} // namespace filum::fill
