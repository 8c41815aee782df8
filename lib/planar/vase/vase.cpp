#include "vase/vase.hpp"

#include "base/error.hpp"
#include "infill/infill.hpp"
#include "polygon/clip.hpp"
#include "regions/regions.hpp"

#include <algorithm>
#include <span>

namespace filum::vase {

namespace {

using polygon::kBeadArc;
using polygon::Loops;
using polygon::Region;

// A vase that grows upwards.
struct Vase {
    Loops outline;                   // outline of its highest region so far
    Loops holes;                     // holes of its floor there, as areas
    std::uint32_t layers = 0;        // number of layers so far
    std::vector<std::size_t> over{}; // regions of the next layer that lie over it
};

// The outer outline of a region, without its holes.
Loops outer(const Region& r) {
    Loops out;
    out.add(r.loops[0]);
    return out;
}

// The holes of a region, as areas.
Loops holes(const Region& r) {
    Loops out;
    for (std::size_t l = 1; l < r.loops.size(); ++l) {
        std::vector<geom::Vec2> loop(r.loops[l].begin(), r.loops[l].end());
        std::reverse(loop.begin(), loop.end());
        out.add(loop);
    }
    return out;
}

bool lie_over(const Region& a, const Loops& below, const Loops& above) {
    return meet(a.box, polygon::bounds(below)) && !polygon::intersect(above, below).empty();
}

// The material that is not printed, summed up for one note per kind.
struct UnprintedMaterial {
    Note branch{NoteCode::vase_ends, 0, 0};   // material above a branch
    Note within{NoteCode::vase_within, 0, 0}; // bodies inside an outline

    static void add(Note& to, const Region& r) {
        if (to.count == 0) {
            to.layer = r.layer;
            to.x = r.loops[0][0].x;
            to.y = r.loops[0][0].y;
        }
        ++to.count;
        to.amount += r.area * r.height;
    }
    void put(Notes& notes) const {
        if (branch.count > 0) notes.push_back(branch);
        if (within.count > 0) notes.push_back(within);
    }
};

// Turns region `of` into the next layer of the vase `grown`.
Region layer_of(const Region& of, Vase& grown, const Options& o) {
    Region out = of;
    out.parent = -1;
    out.areas.clear();
    out.below.clear();
    out.walls = static_cast<std::uint32_t>(o.walls);
    out.loops = outer(of);
    if (grown.layers < static_cast<std::uint64_t>(o.bottom)) {
        const Loops own = holes(of);
        grown.holes = grown.layers == 0 || own.empty() ? own : polygon::intersect(own, grown.holes);
        if (!grown.holes.empty()) {
            const auto parts = polygon::split(polygon::subtract(out.loops, grown.holes)).part;
            const auto largest = std::max_element(parts.begin(), parts.end(), [](const Loops& a, const Loops& b) {
                return polygon::signed_area(a) < polygon::signed_area(b);
            });
            if (largest != parts.end()) out.loops = *largest;
        }
    } else {
        out.areas.push_back({polygon::AreaKind::sparse, out.loops, 0, infill::kHollow});
    }
    out.area = polygon::signed_area(out.loops);
    ++grown.layers;
    return out;
}

// The outlines of a layer that lie in no other one.  Bodies inside an outline are left out.
std::vector<const Region*> outlines(std::span<const Region> layer, UnprintedMaterial& left) {
    std::vector<const Region*> out;
    for (const Region& r : layer)
        if (r.parent < 0)
            out.push_back(&r);
        else
            UnprintedMaterial::add(left.within, r);
    return out;
}

// Grows the vases by one layer, and drops those that end.  Appends the new regions to `to`.
void grow(std::vector<Vase>& vases, std::span<const Region> layer, const Options& o, UnprintedMaterial& left,
          std::vector<Region>& to) {
    const auto tops = outlines(layer, left);
    std::vector<Loops> loops;
    std::vector<std::size_t> below(tops.size(), 0); // per outline: number of vases below
    loops.reserve(tops.size());
    for (const Region* r : tops) loops.push_back(outer(*r));
    for (Vase& v : vases)
        for (std::size_t k = 0; k < tops.size(); ++k)
            if (lie_over(*tops[k], v.outline, loops[k])) {
                v.over.push_back(k);
                ++below[k];
            }
    std::vector<char> used(tops.size(), 0);
    std::vector<Vase> next;
    std::vector<Region> made(tops.size());
    for (Vase& v : vases) {
        if (v.over.size() != 1 || below[v.over[0]] != 1) continue;
        const std::size_t k = v.over[0];
        used[k] = 1;
        v.over.clear();
        made[k] = layer_of(*tops[k], v, o);
        v.outline = std::move(loops[k]);
        next.push_back(std::move(v));
    }
    vases = std::move(next);
    for (std::size_t k = 0; k < tops.size(); ++k)
        if (used[k] != 0)
            to.push_back(std::move(made[k]));
        else
            UnprintedMaterial::add(left.branch, *tops[k]);
}

// Renumbers the regions, and recomputes which of them lie on each other.
void lay_anew(std::vector<Region>& regions, const Options& o) {
    for (std::size_t i = 0; i < regions.size(); ++i) regions[i].id = static_cast<std::uint32_t>(i);
    regions::Air air; // unused: `regions` has already reported overhangs of the part
    std::size_t from = 0, before = 0;
    for (std::size_t i = 0; i <= regions.size(); ++i) {
        if (i < regions.size() && (i == from || regions[i].layer == regions[from].layer)) continue;
        const bool on_bed = from == 0;
        const bool next = !on_bed && regions[before].layer + 1 == regions[from].layer;
        const std::span all(regions);
        regions::lay_on(all.subspan(from, i - from),
                        {on_bed, next ? all.subspan(before, from - before) : all.subspan(0, 0)},
                        {.bead_width = o.bead_width}, air);
        before = from;
        from = i;
    }
}

// The beads of a region above the floor, as an area.
Loops band(const Region& r, const Options& o) {
    Loops plain = polygon::simplify(r.loops, kBeadArc);
    if (r.areas.empty()) return plain;
    return polygon::subtract(plain, polygon::offset(plain, -static_cast<double>(o.walls) * o.bead_width, kBeadArc));
}

// Notes walls with less than half of their width on the layer below.  The amount is the length of bead, mm.
void note_hanging(const std::vector<Region>& regions, const Options& o, Notes& notes) {
    Note out{NoteCode::vase_hangs, 0, 0};
    const double half = o.bead_width / 2;
    for (const Region& r : regions) {
        if (r.areas.empty() || r.below.empty()) continue;
        const Loops below = polygon::offset(band(regions[r.below[0].below], o), half, kBeadArc);
        // strips narrower than a hairline do not count
        const double hair = regions::kHairline * half;
        const Loops free = polygon::opened(polygon::subtract(band(r, o), below), hair, kBeadArc);
        if (free.empty()) continue;
        if (out.count == 0) {
            out.layer = r.layer;
            out.x = free[0][0].x;
            out.y = free[0][0].y;
        }
        ++out.count;
        out.amount += polygon::signed_area(free) / o.bead_width;
    }
    if (out.count > 0) notes.push_back(out);
}

} // namespace

std::vector<Region> vase(const std::vector<Region>& part, const Options& o, Notes& notes, Facts& facts) {
    std::vector<Region> out;
    std::vector<Vase> vases;
    UnprintedMaterial left;
    for (std::size_t i = 0; i < part.size();) {
        std::size_t end = i;
        while (end < part.size() && part[end].layer == part[i].layer) ++end;
        const std::span layer(&part[i], end - i);
        if (i == 0) {
            for (const Region* r : outlines(layer, left)) {
                vases.push_back({outer(*r), {}, 0});
                out.push_back(layer_of(*r, vases.back(), o));
            }
        } else {
            if (part[i - 1].layer + 1 != part[i].layer) vases.clear(); // no vase continues over a missing layer
            grow(vases, layer, o, left, out);
        }
        i = end;
    }
    const auto turns = std::ranges::count_if(out, [](const Region& r) { return !r.areas.empty(); });
    if (turns == 0)
        throw Error(Exit::bad_input,
                    "cannot make a vase of the part: no wall stands on its floor, since it branches or ends within the "
                    "first " +
                        std::to_string(o.bottom) + " layers; choose a smaller --bottom, or leave --vase out");
    lay_anew(out, o);
    left.put(notes);
    note_hanging(out, o, notes);
    facts.push_back({"", "vase-turns", static_cast<double>(turns), ""});
    return out;
}

} // namespace filum::vase
