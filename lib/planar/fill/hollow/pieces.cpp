#include "fill/hollow/pieces.hpp"

#include "fill/rings/lanes.hpp"
#include "polygon/clip.hpp"

#include <algorithm>

namespace filum::fill::hollow {

using polygon::AreaKind;
using polygon::kBeadArc;
using polygon::Loops;

namespace {

// Adds the connected parts of `where` as pieces with the walls and widths of `like`. Parts of at most rings::kLeastVoid
// bead widths squared are left open. Without walls, so are parts nowhere as wide as half a bead.
void add_parts(const Loops& where, const RegionPiece& like, std::vector<RegionPiece>& to) {
    const double width = like.width;
    for (Loops& part : polygon::split(where).part) {
        if (polygon::signed_area(part) <= rings::kLeastVoid * width * width) continue;
        if (like.walls > 0 || !polygon::offset(part, -width / 4, kBeadArc).empty())
            to.push_back({std::move(part), like.walls, width, like.solid});
    }
}

// The part of a piece that is narrower than a bead only because `rest` is cut there.
Loops slivers(const Loops& piece, const Loops& rest, double width) {
    const Loops cut =
        polygon::subtract(polygon::opened(rest, width / 2, kBeadArc), polygon::opened(piece, width / 2, kBeadArc));
    return polygon::opened(polygon::intersect(piece, cut), kBeadArc, kBeadArc); // no hairlines
}

} // namespace

std::vector<RegionPiece> pieces(const Loops& rest, const polygon::Region& region, double bead_width) {
    std::vector<RegionPiece> out;
    Loops left = rest;
    for (const polygon::Area& zone : region.areas) {
        if (zone.kind != AreaKind::zone) continue;
        const Loops beside = polygon::subtract(left, zone.loops);
        Loops own = polygon::subtract(left, polygon::subtract(beside, slivers(beside, rest, bead_width)));
        own = polygon::subtract(own, slivers(own, rest, zone.width));
        left = polygon::subtract(left, own);
        add_parts(own, {{}, zone.walls, zone.width, zone.solid > 0 ? zone.solid : zone.width}, out);
    }
    add_parts(left, {{}, 0, bead_width, bead_width}, out);
    return out;
}

Widths widths(const polygon::Region& region, double bead_width) {
    Widths out{bead_width, bead_width};
    for (const polygon::Area& area : region.areas)
        for (const double width : {area.width, area.solid}) {
            if (!(width > 0)) continue;
            out.narrowest = std::min(out.narrowest, width);
            out.widest = std::max(out.widest, width);
        }
    return out;
}

} // namespace filum::fill::hollow
