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

constexpr double kGridError = 2e-3; // mm: outlines are rounded to .1 um, cut and united
constexpr double kMostTurn = 0.8;   // rad, of a round wall at a corner: an octagon is round, a square is not
constexpr double kSamePlace = 0.1;  // mm: notes on one bore, followed from both sides
constexpr double kLeastArea = 1e-4; // mm2: rounding leaves smaller areas

// A bore on the layer visited last. Tapered and slanted bores change by the same amount from layer to layer.
struct Bore {
    Loops outline;        // counter-clockwise; includes solid that stands in the bore
    Loops air;            // the outline without that solid, on the layer where the bore is a hole
    bool followed = true; // false: solid stood in it on some layer, or its wall was lost
    bool lost = false;    // its wall did not go on as expected
    double growth = 0;    // mm per layer, of the radius of a circle of its area
    geom::Vec2 shift;     // mm per layer, of its middle
};

double radius_of(const Loops& bore) { return std::sqrt(polygon::signed_area(bore) / std::numbers::pi); }

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

// How far two sections of one upright wall may be apart, in mm. The triangles of a round wall differ from layer to
// layer, and so do the corners of its sections. They lie on the wall, so a section is off by at most the height of the
// arc over an edge: for an edge of length l at whose ends the outline turns by s and t, this is at most l / 2 tan((s +
// t) / 4).
double same_wall(const Loops& outline) {
    const Loops bore = polygon::simplify(outline, kGridError); // without the points within straight edges
    double most = 0;
    for (std::size_t k = 0; k < bore.size(); ++k) {
        const auto loop = bore[k];
        const auto edge = [&](std::size_t i) { return loop[(i + 1) % loop.size()] - loop[i % loop.size()]; };
        const auto turn = [&](std::size_t i) { // at the end of edge i
            return std::abs(std::atan2(geom::cross(edge(i), edge(i + 1)), geom::dot(edge(i), edge(i + 1))));
        };
        for (std::size_t i = 0; i < loop.size(); ++i)
            if (const double s = turn(i), t = turn(i + 1); std::max(s, t) <= kMostTurn)
                most = std::max(most, geom::norm(edge(i + 1)) / 2 * std::tan((s + t) / 4));
    }
    return most + kGridError;
}

// The length of the layer's outline that lies within `far` mm of the bore's, in mm. An edge counts if both of its ends
// and its middle lie there.
double common_wall(const Loops& contours, const Loops& bore, double far) {
    const auto walls = polygon::segments(bore);
    const geom::SegmentGrid grid(walls, 1, far);
    const geom::Box2 box = grown(polygon::bounds(bore), far);
    const auto on_wall = [&](geom::Vec2 p) {
        if (!boxes_meet(box, {p, p})) return false;
        bool found = false;
        grid.near(p, p, [&](std::uint32_t i) {
            found = found || geom::point_segment_distance(walls[i].a, walls[i].b, p) <= far;
        });
        return found;
    };
    double out = 0;
    for (const geom::Segment& s : polygon::segments(contours))
        if (on_wall(s.a) && on_wall(s.b) && on_wall(geom::lerp(s.a, s.b, 0.5))) out += geom::distance(s.a, s.b);
    return out;
}

// The length of wall that a slot as wide as a bore shares with it, in mm: the parts within `far` mm of two straight
// walls that touch a circle of the bore's area.
double tangents(const Loops& bore, double far) { return 4 * std::sqrt(2 * radius_of(bore) * far); }

// The loops, grown from the radius `from` by `growth` and shifted.
Loops moved(const Loops& a, geom::Vec2 middle, double from, double growth, geom::Vec2 shift) {
    Loops out = a;
    for (geom::Vec2& p : out.points) p = middle + shift + (1 + growth / from) * (p - middle);
    return out;
}

// The bore where it is on the next layer if it goes on as it came.
Bore continued(const Bore& bore) {
    if (bore.growth == 0 && bore.shift == geom::Vec2{}) return bore;
    Bore out = bore;
    const geom::Vec2 middle = polygon::centroid(bore.outline);
    const double radius = radius_of(bore.outline);
    if (radius + bore.growth <= 0) return bore;
    out.outline = moved(bore.outline, middle, radius, bore.growth, bore.shift);
    out.air = moved(bore.air, middle, radius, bore.growth, bore.shift);
    return out;
}

// Follows bores from layer to layer in one direction.
class Walk {
  public:
    Walk(std::vector<Loops>& open, Notes& notes) : open_(&open), notes_(&notes) {}

    // Visits the next layer.
    void pass(std::size_t layer, const Loops& contours) {
        if (contours.points == last_.points && contours.start == last_.start) { // as on upright walls
            for (Bore& hole : holes_) stop(hole);
            for (Bore& bore : carried_) {
                stop(bore);
                keep(layer, contours, bore);
            }
            return;
        }
        std::vector<Bore> before = std::move(carried_), holes = holes_of(contours);
        before.insert(before.end(), holes_.begin(), holes_.end());
        carried_.clear();
        for (const Bore& bore : before) {
            const auto closes = [&](const Bore& hole) { return meet_in_area(bore.air, hole.air); };
            if (const auto hole = std::find_if(holes.begin(), holes.end(), closes); hole != holes.end()) {
                hole->growth = radius_of(hole->outline) - radius_of(bore.outline);
                hole->shift = polygon::centroid(hole->outline) - polygon::centroid(bore.outline);
                continue;
            }
            // Upright if it does not go on as it came: a step is where the last two layers differ.
            Bore upright = bore, next = continued(bore);
            stop(upright);
            Bore* const way = goes_on(contours, next) ? &next : goes_on(contours, upright) ? &upright : nullptr;
            if (way == nullptr && !has_wall(contours, bore)) continue;
            carried_.push_back(way != nullptr ? *way : lost(bore));
            keep(layer, contours, carried_.back());
        }
        holes_ = std::move(holes);
        last_ = contours;
    }

  private:
    static void stop(Bore& bore) {
        bore.growth = 0;
        bore.shift = {};
    }

    // True if the layer continues the bore's walls with air between them.
    static bool goes_on(const Loops& contours, Bore& bore) {
        const double far = same_wall(bore.outline);
        if (common_wall(contours, bore.outline, far) <= tangents(bore.outline, far)) return false;
        const double solid = solid_in(contours, bore, far);
        if (solid < 0) return false;
        bore.followed = bore.followed && solid <= kLeastArea;
        return true;
    }

    // mm2 of solid in the bore, farther than `far` from its wall; negative if all of it is solid, as at the bottom of a
    // blind bore.
    static double solid_in(const Loops& contours, const Bore& bore, double far) {
        const Loops core = polygon::offset(bore.air, -far);
        const double solid = polygon::signed_area(polygon::intersect(core, contours));
        return solid > polygon::signed_area(core) - kLeastArea ? -1 : solid;
    }

    void keep(std::size_t layer, const Loops& contours, const Bore& bore) {
        if (bore.followed) {
            Loops& open = (*open_)[layer];
            open = open.empty() ? bore.outline : polygon::unite(open, bore.outline);
            return;
        }
        const double far = bore.lost ? wide(bore) : same_wall(bore.outline);
        const geom::Vec2 at = polygon::centroid(bore.outline);
        notes_->push_back({NoteCode::bore_not_compensated, common_wall(contours, bore.outline, far), 1,
                           static_cast<std::int64_t>(layer), at.x, at.y});
    }

    static Bore lost(Bore bore) {
        stop(bore);
        bore.followed = false;
        bore.lost = true;
        return bore;
    }

    // mm from the bore within which a wall counts as that of a bore that was lost.
    static double wide(const Bore& bore) { return radius_of(bore.outline) / 4; }

    // Whether the layer leaves the bore open and has more wall around it than a slot would have: beyond a step, or
    // where the wall bends.
    static bool has_wall(const Loops& contours, const Bore& bore) {
        const double far = wide(bore);
        return common_wall(contours, bore.outline, far) > tangents(bore.outline, far) &&
               solid_in(contours, bore, far) >= 0;
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
        return a.layer == b.layer && geom::distance(geom::Vec2{a.x, a.y}, geom::Vec2{b.x, b.y}) <= kSamePlace;
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
        return polygon::subtract(
            contours, polygon::subtract(polygon::offset(bores, by), polygon::offset(bores, -same_wall(bores))));
    const Loops rim = polygon::subtract(bores, polygon::offset(bores, by));
    return polygon::unite(contours, polygon::intersect(rim, polygon::offset(contours, -by)));
}

} // namespace filum::slice
