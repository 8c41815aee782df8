#include "slice/bores.hpp"

#include "geom/segment_grid.hpp"
#include "polygon/clip.hpp"
#include "polygon/segments.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::slice {

namespace {

using polygon::Loops;

// mm: the largest distance between sections of one upright wall. The triangles of a round wall differ from layer to
// layer, and STEP files are meshed with this deflection by default.
constexpr double kSameWall = 0.02;
constexpr double kLeastArea = 1e-4; // mm2: rounding leaves smaller areas

struct Bore {
    Loops outline;        // counter-clockwise; includes solid that stands in the bore
    Loops air;            // the outline without that solid, on the layer where the bore is a hole
    bool followed = true; // false: solid stood in it on some layer
};

geom::Box2 grown(geom::Box2 box, double by) { return {{box.lo.x - by, box.lo.y - by}, {box.hi.x + by, box.hi.y + by}}; }

bool boxes_meet(const geom::Box2& a, const geom::Box2& b) {
    return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y;
}

bool meet_in_area(const Loops& a, const Loops& b) {
    return boxes_meet(polygon::bounds(a), polygon::bounds(b)) &&
           polygon::signed_area(polygon::intersect(a, b)) > kLeastArea;
}

std::vector<Bore> holes_of(const Loops& contours) {
    std::vector<Bore> out;
    for (const Loops& part : polygon::split(contours).part)
        for (std::size_t i = 1; i < part.size(); ++i) {
            Bore bore;
            bore.outline.points.assign(part[i].rbegin(), part[i].rend());
            bore.outline.close();
            bore.air = polygon::subtract(bore.outline, contours);
            out.push_back(std::move(bore));
        }
    return out;
}

// The length of the layer's outline that lies on the bore's, in mm. An edge counts if both of its ends and its middle
// lie there.
double common_wall(const Loops& contours, const Loops& bore) {
    const auto walls = polygon::segments(bore);
    const geom::SegmentGrid grid(walls, 1, kSameWall);
    const geom::Box2 box = grown(polygon::bounds(bore), kSameWall);
    const auto on_wall = [&](geom::Vec2 p) {
        if (!boxes_meet(box, {p, p})) return false;
        bool found = false;
        grid.near(p, p, [&](std::uint32_t i) {
            found = found || geom::point_segment_distance(walls[i].a, walls[i].b, p) <= kSameWall;
        });
        return found;
    };
    double out = 0;
    for (const geom::Segment& s : polygon::segments(contours))
        if (on_wall(s.a) && on_wall(s.b) && on_wall(geom::lerp(s.a, s.b, 0.5))) out += geom::distance(s.a, s.b);
    return out;
}

// The length of wall that a slot as wide as a bore shares with it, in mm: two straight walls that touch a circle of the
// bore's area.
double tangents(const Loops& bore) {
    const double radius = std::sqrt(polygon::signed_area(bore) / std::numbers::pi);
    return 4 * std::sqrt(2 * radius * kSameWall);
}

// Follows bores from layer to layer in one direction.
class Walk {
  public:
    Walk(std::vector<Loops>& open, Notes& notes) : open_(&open), notes_(&notes) {}

    // Visits the next layer.
    void pass(std::size_t layer, const Loops& contours) {
        if (contours.points == last_.points && contours.start == last_.start) { // as on upright walls
            for (const Bore& bore : carried_) keep(layer, contours, bore);
            return;
        }
        std::vector<Bore> before = std::move(carried_), holes = holes_of(contours);
        before.insert(before.end(), holes_.begin(), holes_.end());
        carried_.clear();
        for (Bore& bore : before) {
            const bool closed = std::any_of(holes.begin(), holes.end(),
                                            [&](const Bore& hole) { return meet_in_area(bore.air, hole.air); });
            if (closed || !goes_on(contours, bore)) continue;
            keep(layer, contours, bore);
            carried_.push_back(std::move(bore));
        }
        holes_ = std::move(holes);
        last_ = contours;
    }

  private:
    // True if the layer continues the bore's walls with air between them.
    static bool goes_on(const Loops& contours, Bore& bore) {
        if (common_wall(contours, bore.outline) <= tangents(bore.outline)) return false;
        const Loops core = polygon::offset(bore.air, -kSameWall);
        const double solid = polygon::signed_area(polygon::intersect(core, contours));
        if (solid > polygon::signed_area(core) - kLeastArea) return false; // this is the bottom of a blind bore
        bore.followed = bore.followed && solid <= kLeastArea;
        return true;
    }

    void keep(std::size_t layer, const Loops& contours, const Bore& bore) {
        if (bore.followed) {
            Loops& open = (*open_)[layer];
            open = open.empty() ? bore.outline : polygon::unite(open, bore.outline);
            return;
        }
        const geom::Vec2 at = polygon::centroid(bore.outline);
        notes_->push_back({NoteCode::bore_not_compensated, common_wall(contours, bore.outline), 1,
                           static_cast<std::int64_t>(layer), at.x, at.y});
    }

    std::vector<Loops>* open_; // per layer: its open bores
    Notes* notes_;
    Loops last_;
    std::vector<Bore> holes_;   // holes of the last layer
    std::vector<Bore> carried_; // bores that the last layer left open
};

} // namespace

std::vector<Loops> open_bores(std::span<const Loops> contours, Notes& notes) {
    std::vector<Loops> open(contours.size());
    Notes up, down;
    Walk upwards(open, up);
    for (std::size_t i = 0; i < contours.size(); ++i) upwards.pass(i, contours[i]);
    Walk downwards(open, down);
    for (std::size_t i = contours.size(); i-- > 0;) downwards.pass(i, contours[i]);
    const auto same = [](const Note& a, const Note& b) {
        return a.layer == b.layer && geom::distance(geom::Vec2{a.x, a.y}, geom::Vec2{b.x, b.y}) <= kSameWall;
    };
    for (const Note& n : up) // keep it unless the way down has a note on the same wall
        if (std::none_of(down.begin(), down.end(), [&](const Note& other) { return same(n, other); }))
            notes.push_back(n);
    notes.insert(notes.end(), down.begin(), down.end());
    std::erase_if(notes, [&](const Note& n) { // the bore was followed from the other side
        return n.layer >= 0 && polygon::contains(open[static_cast<std::size_t>(n.layer)], {n.x, n.y});
    });
    return open;
}

Loops with_wider_bores(const Loops& contours, const Loops& bores, double by) {
    if (bores.empty() || by == 0) return contours;
    if (by > 0)
        return polygon::subtract(contours,
                                 polygon::subtract(polygon::offset(bores, by), polygon::offset(bores, -kSameWall)));
    const Loops rim = polygon::subtract(bores, polygon::offset(bores, by));
    return polygon::unite(contours, polygon::intersect(rim, polygon::offset(contours, -by)));
}

} // namespace filum::slice
