#include "skins/skins.hpp"

#include "base/density.hpp"
#include "infill/infill.hpp"
#include "infill/squares.hpp"
#include "parallel/parallel.hpp"
#include "polygon/clip.hpp"
#include "polygon/loop_index.hpp"
#include "skins/alike.hpp"
#include "skins/bridges.hpp"
#include "skins/zones.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>

namespace filum::skins {

namespace {

using polygon::kBeadArc;
using polygon::LoopIndex;
using polygon::Loops;
using polygon::Region;

constexpr double kHairline = 0.1;    // bead widths: narrower skins do not count
constexpr double kReach = 2;         // bead widths: skins extend over sparse areas by at least this,
constexpr double kReachMost = 8;     // and by at most this
constexpr std::size_t kCarrying = 2; // layers whose lines carry a skin: one of each direction
constexpr double kWidthGive = 0.25;  // share of a bead's width by which lines may be wider or narrower
constexpr double kNarrowest = 2;     // bead widths: narrower sparse places become solid

// The layers with as few points as beads need. The cost of all further steps depends on their number.
std::vector<Loops> coarse(std::vector<Loops> layers) {
    parallel::for_chunks(layers.size(), 1, 0,
                         [&](std::size_t i, std::size_t) { layers[i] = polygon::simplify(layers[i], kBeadArc); });
    return layers;
}

std::vector<LoopIndex> indexed(const std::vector<Loops>& layers) {
    std::vector<LoopIndex> out(layers.size());
    parallel::for_chunks(layers.size(), 1, 0, [&](std::size_t i, std::size_t) { out[i] = LoopIndex(layers[i]); });
    return out;
}

Loops common(const Loops& a, const Loops& b) {
    if (a.empty() || b.empty()) return {};
    if (a.points == b.points && a.start == b.start) return a;
    return polygon::intersect(a, b);
}

// The intersection of layers i .. i + n - 1, for every i with that many. The layers are divided into blocks of n. Each
// result combines two intersections: from i to the end of its block, and from the start of the next block to the last
// layer (van Herk 1992). So every layer costs three intersections, for any n.
std::vector<Loops> common_runs(const std::vector<Loops>& layers, std::size_t n) {
    const std::size_t count = layers.size();
    if (n == 0 || count < n) return {};
    std::vector<Loops> ahead(count), behind(count), out(count - n + 1); // to the end of the block, from its start
    parallel::for_chunks(count, n, 0, [&](std::size_t from, std::size_t to) {
        behind[from] = layers[from];
        ahead[to - 1] = layers[to - 1];
        for (std::size_t i = from + 1; i < to; ++i) behind[i] = common(behind[i - 1], layers[i]);
        for (std::size_t i = to - 1; i-- > from;) ahead[i] = common(ahead[i + 1], layers[i]);
    });
    parallel::for_chunks(out.size(), 1, 0, [&](std::size_t i, std::size_t) {
        out[i] = i % n == 0 ? ahead[i] : common(ahead[i], behind[i + n - 1]);
    });
    return out;
}

// How far skins extend over sparse areas, mm: half the line spacing, so that a line lies below every skin.
double reach(const Options& o) {
    return infill_width(o) * (o.infill > 0 ? std::clamp(1 / (2 * o.infill), kReach, kReachMost) : kReachMost);
}

// `sparse` without connected parts smaller than `least` mm2, which become solid.
Loops large(const Loops& sparse, double least) {
    Loops out;
    for (const Loops& part : polygon::split(sparse).part)
        if (polygon::signed_area(part) >= least) out.add(part);
    return out;
}

// The total width of the walls of a region in mm. The outer wall has the same width in all settings, `outer_width`. A
// region with a bead width of its own has that width throughout.
double depth(const Region& r, const Options& o, double outer_width) {
    if (r.width > 0) return static_cast<double>(o.walls) * r.width;
    return outer_width + static_cast<double>(o.walls - 1) * inner_width(o);
}

// The area of a region inside walls of `depth` mm.
Loops within_walls(const Region& r, double depth) {
    return polygon::offset(polygon::simplify(r.loops, kBeadArc), -depth, kBeadArc);
}

// The sparse part of a region, inside walls of `depth` mm: the area far enough from skins. A skin counts if it extends
// beyond the walls by more than a hairline. `covered` is the area of the layer with enough material above and below.
// `zone` restricts an area to the part where these options hold.
template <class Zone>
Loops sparse(const Region& r, const LoopIndex& covered, const Options& o, double depth, const Zone& zone) {
    const Loops inner = covered.near(polygon::bounds(r.loops));
    if (inner.empty()) return {};
    const double w = inner_width(o), hair = kHairline * w / 2, open = kNarrowest * w / 2;
    const Loops within = within_walls(r, depth);
    if (within.empty()) return {};
    const Loops skin = polygon::offset(polygon::subtract(within, inner), -hair, kBeadArc);
    const Loops rest =
        skin.empty() ? within : polygon::subtract(within, polygon::offset(skin, reach(o) + hair, kBeadArc));
    const double least = o.infill > 0 ? o.solid_below : 0; // a hollow part stays hollow
    return large(polygon::opened(zone(rest), open, kBeadArc), least);
}

// The part of `area`, the sparse part of a region, that carries a skin on one of the next layers.
Loops carrying(const Loops& area, const std::vector<LoopIndex>& sparse_of, std::uint32_t layer, const Options& o) {
    const geom::Box2 box = polygon::bounds(area);
    Loops plain = area;
    for (std::size_t up = 1; up <= kCarrying && !plain.empty(); ++up)
        plain = layer + up < sparse_of.size() ? common(plain, sparse_of[layer + up].near(box)) : Loops{};
    const double open = 2 * kNarrowest * inner_width(o) / 2;
    // opened_difference(area, opened(plain, open), open / 2), whose growths of `plain` are one
    Loops core = polygon::offset(area, -open / 2, kBeadArc);
    if (!core.empty() && !plain.empty())
        core =
            polygon::subtract(core, polygon::offset(polygon::offset(plain, -open, kBeadArc), 3 * open / 2, kBeadArc));
    return polygon::offset(core, open / 2, kBeadArc);
}

// The part of the sparse area `all` beside its dense part, without the slivers that rounding leaves where both have the
// same outline. `fill` adds such slivers to the area beside them.
Loops beside(const Loops& all, const Loops& dense, const Options& o) {
    if (dense.empty()) return all;
    Loops out;
    for (const Loops& part : polygon::split(polygon::subtract(all, dense)).part)
        if (!polygon::offset(part, -kHairline * o.bead_width / 2, kBeadArc).empty()) out.add(part);
    return out;
}

// The part of a region that is visible if `other` is the next layer in that direction.
Loops seen(const Loops& outline, const Loops& other, const Options& o) {
    if (other.points == outline.points) return {};
    const double hair = kHairline * o.bead_width / 2;
    return polygon::opened(polygon::subtract(outline, other), hair, kBeadArc);
}

// A note if the bead width or the walls of a modifier have no effect in a region.
Notes ignored(const Region& r, const RegionZones& cut, const Options& o, bool any_sparse) {
    Notes out;
    const double width = o.bead_width, inner = inner_width(o);
    const auto put = [&](const Loops& where, NoteCode code) {
        out.push_back({code, 1, 1, r.layer, where.points[0].x, where.points[0].y});
    };
    const auto other = std::ranges::find_if(
        cut.zones, [&](const auto& zone) { return r.width == 0 && zone.width != width && zone.width != inner; });
    if (other != cut.zones.end())
        put(other->loops, NoteCode::modifier_wall_width);
    else if (!cut.zones.empty() && !cut.mixed && !any_sparse)
        put(cut.zones[0].loops, NoteCode::modifier_walls_idle);
    if (!cut.idle_width.empty()) put(cut.idle_width, NoteCode::modifier_width_idle);
    return out;
}

// The notes of `ignored` for all regions of the part. An empty `any_sparse` means that no region is sparse.
Notes ignored(const std::vector<Region>& regions, const std::vector<RegionZones>& cuts, const Options& o,
              const std::vector<char>& any_sparse) {
    Notes out;
    for (std::size_t i = 0; i < regions.size(); ++i) {
        if (regions[i].is != polygon::RegionClass::part) continue;
        const bool sparse = !any_sparse.empty() && any_sparse[i] != 0;
        std::ranges::move(ignored(regions[i], cuts[i], o, sparse), std::back_inserter(out));
    }
    return out;
}

// Sets walls, zones, top and bottom surfaces and bridges of a region. If nothing is sparse and all bead widths are
// equal, zones have no effect and are left out.
void tell_solid(Region& r, const std::vector<LoopIndex>& layers, const Options& o, RegionZones& cut, bool any_sparse) {
    if (r.is != polygon::RegionClass::part) return;
    const bool zones = any_sparse || cut.mixed;
    r.walls = zones ? cut.walls : static_cast<std::uint32_t>(o.walls);
    if (zones) std::ranges::move(cut.zones, std::back_inserter(r.areas));
    const auto put = [&](polygon::AreaKind kind, Loops loops) {
        if (!loops.empty()) r.areas.push_back({kind, std::move(loops), 0, 0, {}});
    };
    const Loops outline = polygon::simplify(r.loops, kBeadArc);
    const geom::Box2 box = polygon::bounds(outline);
    put(polygon::AreaKind::skin_top,
        seen(outline, r.layer + 1 < layers.size() ? layers[r.layer + 1].near(box) : Loops{}, o));
    Loops free =
        seen(outline, r.rests_on() >= 0 ? layers[static_cast<std::size_t>(r.rests_on())].near(box) : Loops{}, o);
    if (r.rests_on() >= 0 && o.bottom > 0 && !free.empty()) {
        const Loops within = within_walls(r, depth(r, o, o.bead_width));
        const geom::Vec2 bead{o.bead_width, o.bead_width}; // the ends of a bridge lie on beads beside it
        const Loops below = layers[r.layer - 1].near({box.lo - bead, box.hi + bead});
        for (auto& bridge : bridges(within, below, o)) r.areas.push_back(std::move(bridge));
    }
    put(polygon::AreaKind::skin_bottom, std::move(free));
}

double direction_of(std::uint32_t layer) { return (layer % 2 == 0 ? 1 : 3) * std::numbers::pi / 4; }

// The lines of sparse areas.
struct SparseLines {
    double spacing = 0, width = 0; // mm
};

// The lines at which the plain areas get the requested share. Without plain areas they are those of the dense ones; the
// spacing is 0 without any. Concentric lines come and go as a whole, and of few lines one more or less matters. So
// their widths make up for what the nearest spacing lays too little or too much, up to kWidthGive. Names of facts begin
// with `whose`.
SparseLines lines_of(const std::vector<Region>& regions, const std::vector<Loops>& plain,
                     const std::vector<Loops>& dense, const Options& o, double outer_width, const std::string& whose,
                     Facts& facts) {
    const double w = infill_width(o);
    if (o.infill == 0) return {infill::kHollow, w};
    std::vector<Loops> rims(regions.size());
    if (o.pattern == polygon::InfillPattern::concentric)
        parallel::for_chunks(regions.size(), 1, 0, [&](std::size_t i, std::size_t) {
            if (!plain[i].empty() || !dense[i].empty())
                rims[i] = within_walls(regions[i], depth(regions[i], o, outer_width));
        });
    for (const auto* areas : {&plain, &dense}) {
        std::vector<infill::Task> tasks;
        for (std::size_t i = 0; i < regions.size(); ++i)
            if (!(*areas)[i].empty())
                tasks.push_back(
                    {&(*areas)[i], {o.pattern, direction_of(regions[i].own_layer()), 0, w, regions[i].z, 0, &rims[i]}});
        if (tasks.empty()) continue;
        const double spacing = infill::spacing_for(tasks, o.infill, w);
        facts.push_back({"", whose + "infill-spacing", spacing, "mm"});
        if (o.pattern != polygon::InfillPattern::concentric && o.infill >= infill::kFew) return {spacing, w};
        const double share = infill::share_laid(tasks, spacing, w);
        const double wider = share > 0 ? std::clamp(o.infill / share, 1 - kWidthGive, 1 + kWidthGive) : 1;
        facts.push_back({"", whose + "infill-share", 100 * share * wider, "%"});
        return {spacing, wider * w};
    }
    return {0, w};
}

// The sparse areas of one setting, per region.
struct Sparse {
    Options how;
    double outer_width;              // mm, of the outer wall
    std::vector<Loops> plain, dense; // lines at the spacing; more lines, below skins
};

// The part of each layer that has enough material above and below: what it has in common with `bottom` layers below and
// `top` above.
std::vector<Loops> inner_of(const std::vector<Loops>& layers, const Options& o) {
    const auto top = static_cast<std::size_t>(o.top), bottom = static_cast<std::size_t>(o.bottom);
    std::vector<Loops> out(layers.size());
    if (layers.size() <= top || layers.size() - top <= bottom) return out; // also where a sum would be too large
    auto runs = common_runs(layers, bottom + 1 + top);
    std::move(runs.begin(), runs.end(), out.begin() + static_cast<std::ptrdiff_t>(bottom));
    return out;
}

// Moves the parts that carry a skin from `plain` to `dense`.
void part_dense(std::vector<Sparse>& settings, const std::vector<Region>& regions, std::size_t layers) {
    std::vector<Loops> of_layer(layers);
    for (const Sparse& s : settings)
        for (std::size_t i = 0; i < regions.size(); ++i)
            for (std::int64_t k = regions[i].rests_on() + 1; k <= regions[i].layer; ++k)
                of_layer[static_cast<std::size_t>(k)].add(s.plain[i]);
    const auto sparse_of = indexed(of_layer);
    const auto layer = alike(of_layer);
    for (Sparse& s : settings) {
        if (s.how.infill == 0) continue;
        const auto first = alike(
            regions.size(), [&](std::size_t i) -> const Loops& { return s.plain[i]; },
            [&](std::size_t i) {
                std::array<double, kCarrying> above{}; // 0: none
                for (std::size_t up = 1; up <= kCarrying && regions[i].layer + up < layers; ++up)
                    above.at(up - 1) = 1 + static_cast<double>(layer[regions[i].layer + up]);
                return above;
            });
        make_once(first, s.dense, [&](std::size_t i) {
            return s.plain[i].empty() ? Loops{} : carrying(s.plain[i], sparse_of, regions[i].layer, s.how);
        });
        std::vector<Loops> rest(regions.size());
        make_once(first, rest, [&](std::size_t i) { return beside(s.plain[i], s.dense[i], s.how); });
        s.plain = std::move(rest);
    }
}

// Extends dense areas to whole squares, so that rows below skins begin and end on rows of the layer below.
void take_squares(Sparse& s, const std::vector<Region>& regions, double spacing) {
    if (s.how.pattern != polygon::InfillPattern::rows) return;
    parallel::for_chunks(regions.size(), 1, 0, [&](std::size_t i, std::size_t) {
        if (s.dense[i].empty()) return;
        const Loops all = polygon::unite(s.plain[i], s.dense[i]);
        s.dense[i] = infill::whole_squares(
            s.dense[i], all,
            {.direction = direction_of(regions[i].own_layer()), .spacing = spacing, .bead_width = infill_width(s.how)});
        s.plain[i] = beside(all, s.dense[i], s.how);
    });
}

// Adds the sparse areas of one setting to the regions.
void put_sparse(Sparse& s, std::vector<Region>& regions, const std::string& whose, Facts& facts) {
    const SparseLines lines = lines_of(regions, s.plain, s.dense, s.how, s.outer_width, whose, facts);
    if (lines.spacing == 0) return;
    take_squares(s, regions, lines.spacing);
    for (std::size_t i = 0; i < regions.size(); ++i) {
        Region& r = regions[i];
        const auto put = [&](Loops& loops, double gap) {
            if (loops.empty()) return;
            r.areas.push_back({polygon::AreaKind::sparse, std::move(loops), direction_of(r.own_layer()), lines.spacing,
                               s.how.pattern, gap});
            if (r.width == 0 && lines.width != inner_width(s.how)) r.areas.back().width = lines.width;
        };
        put(s.dense[i], s.how.bridge);
        put(s.plain[i], 0);
    }
}

} // namespace

double inner_width(const Options& o) { return o.inner_width > 0 ? o.inner_width : o.bead_width; }
double infill_width(const Options& o) { return o.infill_width > 0 ? o.infill_width : inner_width(o); }
double solid_width(const Options& o) { return o.solid_width > 0 ? o.solid_width : inner_width(o); }

std::uint32_t reach_in_layers(const Options& o) {
    constexpr std::int64_t kMost = 1U << 30U;
    return static_cast<std::uint32_t>(
        std::max({std::min(o.top, kMost), std::min(o.bottom, kMost), static_cast<std::int64_t>(kCarrying)}));
}

Notes skins(std::vector<Region>& regions, const Options& o, std::span<const Modifier> modifiers, Facts& facts) {
    std::vector<Sparse> settings{{o, o.bead_width, {}, {}}};
    for (const Modifier& m : modifiers) settings.push_back({m.how, o.bead_width, {}, {}});
    const auto solid = [](const Sparse& s) { return s.how.infill >= 1; };
    if (regions.empty() || (modifiers.empty() && solid(settings[0]))) return {};
    for (const Region& r : regions)
        check_density(polygon::signed_area(r.loops), o.bead_width, Exit::usage, "--bead-width");
    const auto layers = coarse(polygon::materials(regions, polygon::RegionClass::part));
    const Zones zones(o, modifiers, layers.size());
    std::vector<RegionZones> cuts(regions.size());
    parallel::for_chunks(regions.size(), 1, 0, [&](std::size_t i, std::size_t) { cuts[i] = zones.cut(regions[i]); });
    if (std::ranges::all_of(settings, solid) && !zones.widths_differ()) return ignored(regions, cuts, o, {});
    for (std::size_t k = 0; k < settings.size(); ++k) {
        Sparse& s = settings[k];
        s.plain.resize(regions.size());
        s.dense.resize(regions.size());
        if (solid(s)) continue;
        const auto inner_layers = inner_of(layers, s.how);
        const auto inner = indexed(inner_layers);
        const auto layer = alike(inner_layers);
        // bodies of modifiers differ from layer to layer
        const auto first = alike(
            regions.size(), [&](std::size_t i) -> const Loops& { return regions[i].loops; },
            [&](std::size_t i) {
                return std::array<double, 3>{static_cast<double>(layer[regions[i].layer]), regions[i].width,
                                             modifiers.empty() ? 0 : static_cast<double>(i)};
            });
        make_once(first, s.plain, [&](std::size_t i) {
            const Region& r = regions[i];
            return sparse(r, inner[r.layer], s.how, depth(r, s.how, s.outer_width),
                          [&](const Loops& area) { return zones.of(k, r, cuts[i], area); });
        });
    }
    part_dense(settings, regions, layers.size());
    std::vector<char> any_sparse(regions.size());
    for (std::size_t i = 0; i < regions.size(); ++i)
        any_sparse[i] = static_cast<char>(
            std::ranges::any_of(settings, [&](const Sparse& s) { return !s.plain[i].empty() || !s.dense[i].empty(); }));
    Notes notes = ignored(regions, cuts, o, any_sparse);
    const auto all = indexed(layers);
    parallel::for_chunks(regions.size(), 1, 0, [&](std::size_t i, std::size_t) {
        tell_solid(regions[i], all, o, cuts[i], any_sparse[i] != 0);
    });
    for (std::size_t k = 0; k < settings.size(); ++k)
        put_sparse(settings[k], regions, k == 0 ? "" : "modifier-" + std::to_string(k) + "-", facts);
    return notes;
}

} // namespace filum::skins
