#include "infill/links.hpp"

#include "base/none.hpp"
#include "geom/disjoint_sets.hpp"
#include "geom/segment_grid.hpp"
#include "polygon/clip.hpp"
#include "polygon/segments.hpp"

#include <algorithm>
#include <cmath>

namespace filum::infill {

namespace {

using geom::Segment;
using geom::Vec2;
using polygon::Loops;

constexpr double kFollows = 0.05;  // mm: largest gap that rounding and thinning leave between a cell and its outline,
                                   // and difference of the lengths of links between parallel lines
constexpr double kLinkWide = 0.55; // bead widths to each side: a little more than a bead, so that opening keeps it
constexpr double kLinksApart = 2;  // bead widths from middle to middle: half of each link and a bead between them
constexpr double kShoulder = 1.5;  // bead widths: lines should continue this far to both sides of a link's middle. Its
                                   // own two lines reach half a bead, and need another bead to turn
constexpr double kPlaces = 1;      // bead widths between places tried for a link

// Outlines of cells, then those of the room.
Loops together(const Loops& cells, const Loops& room) {
    Loops out = cells;
    out.add(room);
    return out;
}

struct Link {
    Segment way;
    bool slit = false;        // across a cell
    bool broad = false;       // with shoulders
    bool outline = false;     // ends at an outline of the room
    std::uint32_t to = kNone; // loop
};

// Chooses the best of the links that are about as short as the shortest (within kFollows).
struct Choice {
    std::vector<Link> found;
    double shortest = 1e300;

    void add(const Link& link) {
        shortest = std::min(shortest, geom::distance(link.way.a, link.way.b));
        found.push_back(link);
    }
    [[nodiscard]] Link best() const {
        const Link* out = nullptr;
        const auto higher = [](const Link& l, const Link& than) {
            const Vec2 d = l.way.a - than.way.a;
            const double up = l.slit ? -d.y : d.y;
            return up > 0 || (up == 0 && d.x > 0);
        };
        for (const Link& l : found)
            if (geom::distance(l.way.a, l.way.b) <= shortest + kFollows && (out == nullptr || higher(l, *out)))
                out = &l;
        return *out;
    }
};

class Linker {
  public:
    Linker(const Loops& cells, const Loops& room, double w)
        : cells_(cells), room_(room), all_(together(cells, room)), w_(w), segment_(polygon::segments(all_)),
          grid_(segment_, 4 * w), groups_(all_.size()) {
        for (std::uint32_t l = 0; l < all_.size(); ++l) loop_of_.resize(all_.start[l + 1], l);
        for (std::uint32_t i = 0; i < cells.points.size(); ++i) join_followed(i);
    }

    std::vector<Link> links() {
        std::vector<Link> out;
        for (std::uint32_t l = 1; l < all_.size(); ++l)
            while (groups_.root(l) != groups_.root(0)) {
                const Choice choice = candidates(l, out);
                if (choice.found.empty()) break;
                out.push_back(choice.best());
                groups_.unite(l, out.back().to);
            }
        return out;
    }

  private:
    [[nodiscard]] std::uint32_t group(std::uint32_t segment) { return groups_.root(loop_of_[segment]); }

    // Joins the loop of a point to the outlines of the room that it follows there.
    void join_followed(std::uint32_t point) {
        const Vec2 p = all_.points[point], margin{kFollows, kFollows};
        grid_.near(p - margin, p + margin, [&](std::uint32_t k) {
            if (loop_of_[k] < cells_.size() || group(k) == group(point)) return;
            if (geom::point_segment_distance(segment_[k].a, segment_[k].b, p) < kFollows)
                groups_.unite(loop_of_[point], loop_of_[k]);
        });
    }

    // Links from all lines of the loop's group, within a growing reach. Only links with shoulders, if there are any.
    Choice candidates(std::uint32_t loop, const std::vector<Link>& taken) {
        const std::uint32_t own = groups_.root(loop);
        const auto box = polygon::bounds(room_);
        const double widest = geom::distance(box.lo, box.hi);
        Choice broad, narrow;
        for (double reach = 8 * w_; broad.found.empty() && narrow.found.empty() && reach < 2 * widest; reach *= 2)
            for (std::uint32_t i = 0; i < segment_.size(); ++i) {
                if (group(i) != own) continue;
                const Segment& s = segment_[i];
                const auto places = static_cast<int>(std::ceil(geom::distance(s.a, s.b) / (kPlaces * w_)));
                for (int k = 0; k < places; ++k) {
                    const double most = std::min(reach, broad.shortest + kFollows);
                    Link link = nearest(geom::lerp(s.a, s.b, static_cast<double>(k) / places), own, most);
                    link.outline = i >= cells_.points.size() || link.to >= cells_.size();
                    if (link.to != kNone && is_free(link.way, own, taken)) (link.broad ? broad : narrow).add(link);
                }
            }
        return broad.found.empty() ? narrow : broad;
    }

    // The shortest way from p to a line of another group that is nearer than `most`; `to` is kNone if there is none.
    Link nearest(Vec2 p, std::uint32_t own, double most) {
        Link out;
        const Vec2 margin{most, most};
        grid_.near(p - margin, p + margin, [&](std::uint32_t k) {
            if (group(k) == own) return;
            const Vec2 q = geom::nearest_point(segment_[k].a, segment_[k].b, p);
            const double d = geom::distance(p, q);
            if (d >= most) return;
            most = d;
            out.way = {p, q};
            out.to = loop_of_[k];
        });
        if (out.to == kNone) return out;
        out.slit = polygon::contains(cells_, geom::lerp(out.way.a, out.way.b, 0.5));
        const Vec2 aside = (kShoulder * w_ / std::max(most, polygon::kBeadArc)) * geom::left_of(out.way.b - out.way.a);
        out.broad = true;
        for (const Vec2 shift : {aside, -1.0 * aside})
            out.broad = out.broad && lies_at(out.way.a + shift, own, true) && lies_at(out.way.b + shift, own, false);
        return out;
    }

    // True if a line within half a bead of p is in the group `own` or, without `of_own`, in another group.
    bool lies_at(Vec2 p, std::uint32_t own, bool of_own) {
        const Vec2 margin{w_ / 2, w_ / 2};
        bool found = false;
        grid_.near(p - margin, p + margin, [&](std::uint32_t k) {
            found = found || ((group(k) == own) == of_own &&
                              geom::point_segment_distance(segment_[k].a, segment_[k].b, p) < w_ / 2);
        });
        return found;
    }

    // True if the way lies within the room, crosses only one cell or gap, and is far enough from other links.
    bool is_free(const Segment& way, std::uint32_t own, const std::vector<Link>& taken) {
        const auto near = [&](const Link& l) {
            return geom::segment_distance(l.way.a, l.way.b, way.a, way.b) < kLinksApart * w_;
        };
        return std::none_of(taken.begin(), taken.end(), near) &&
               polygon::contains(room_, geom::lerp(way.a, way.b, 0.5)) &&
               !grid_.crosses(way.a, way.b, segment_, [&](std::uint32_t k) { return group(k) == own; });
    }

    const Loops &cells_, &room_;
    Loops all_;
    double w_;
    std::vector<Segment> segment_;
    geom::SegmentGrid grid_;
    geom::DisjointSets groups_;
    std::vector<std::uint32_t> loop_of_; // per segment
};

// The area that a link adds or removes: as wide as a bead between cells. At an outline of the room a strip is as wide
// as its shoulders, which leaves room for an exchange with the beads there.
Loops covered_by(const Link& l, double w) {
    const Vec2 line[] = {l.way.a, l.way.b};
    if (l.slit || !l.outline || !l.broad)
        return polygon::around(line, (l.slit ? 0.5 : kLinkWide) * w, polygon::kBeadArc);
    const Vec2 along = (1 / geom::distance(l.way.a, l.way.b)) * (l.way.b - l.way.a);
    const Vec2 beyond = kLinkWide * w * along, aside = kShoulder * w * geom::left_of(along);
    const Vec2 corners[] = {l.way.a - beyond - aside, l.way.b + beyond - aside, l.way.b + beyond + aside,
                            l.way.a - beyond + aside};
    Loops out;
    out.add(corners);
    return out;
}

} // namespace

Loops with_links(const Loops& cells, const Loops& room, double w) {
    Loops strips, slits;
    for (const Loops& part : polygon::split(room).part)
        for (const Link& l : Linker(polygon::intersect(cells, part), part, w).links())
            (l.slit ? slits : strips).add(covered_by(l, w));
    Loops out = cells;
    if (!strips.empty()) out = polygon::intersect(polygon::unite(out, strips), room);
    if (!slits.empty()) out = polygon::subtract(out, slits);
    return out;
}

} // namespace filum::infill
