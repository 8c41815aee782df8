#include "plate/plate.hpp"

#include "geom/hull.hpp"
#include "plate/lattice.hpp"
#include "plate/nest.hpp"

#include <algorithm>
#include <cmath>

namespace filum::plate {

namespace {

constexpr double kGrid = 1e-3;     // mm, step of places
constexpr double kLeast = 2;       // mm; parts closer than a few beads stick together
constexpr double kRounding = 0.01; // mm added to the head's size, as places and the outlines of layers are rounded

double second_highest(std::span<const Thing> things) {
    std::vector<double> height;
    for (const Thing& t : things) height.push_back(t.height);
    std::sort(height.rbegin(), height.rend());
    return height.size() < 2 ? 0 : height[1];
}

// The distance that keeps the head clear of parts up to `height`, mm; none where it spans the machine.
std::optional<Vec2> head_room(const machine::Head& head, double height) {
    if (head.none) return Vec2{0, 0};
    if (height > head.gantry_height) return std::nullopt;
    const double nozzle = head.cone_radius(height);
    if (height <= head.cone_height) return Vec2{nozzle, nozzle};
    return Vec2{std::max(nozzle, head.carriage_x / 2), std::max(nozzle, head.carriage_y / 2)};
}

// The outline grown by half the spacing in x and in y.
Corners grown(const Thing& thing, const Spacing& apart) {
    std::vector<Vec2> all;
    for (const Vec2& p : thing.outline)
        for (const double sx : {-0.5, 0.5})
            for (const double sy : {-0.5, 0.5}) all.push_back(p + Vec2{sx * apart.x, sy * apart.y});
    Corners out;
    for (const Vec2& p : geom::convex_hull(all)) {
        out.x.push_back(p.x);
        out.y.push_back(p.y);
    }
    return out;
}

// True if all things have the same outline, as copies have.
bool alike(std::span<const Thing> things) {
    return std::all_of(things.begin(), things.end(),
                       [&](const Thing& t) { return t.outline == things.front().outline; });
}

std::vector<Vec2> points_of(const Corners& polygon) {
    std::vector<Vec2> out;
    for (std::size_t i = 0; i < polygon.x.size(); ++i) out.push_back({polygon.x[i], polygon.y[i]});
    return out;
}

double area_of(std::span<const Vec2> polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    return twice / 2;
}

// Copies of one outline in rows. Nothing if they do not fit in this way, but may fit by a search.
std::optional<Nesting> in_rows(const Corners& polygon, std::size_t count, Vec2 size, bool turn) {
    const std::vector<Vec2> outline = points_of(polygon);
    std::size_t most = 0; // that fit in rows
    const auto moves = lattice(outline, count, size, most);
    const bool too_many = area_of(outline) * static_cast<double>(count) > size.x * size.y;
    if (!too_many && (!moves || turn)) return std::nullopt;
    Nesting out;
    for (std::size_t k = 0; k < count; ++k) {
        out.x.push_back(moves ? (*moves)[k].x : 0);
        out.y.push_back(moves ? (*moves)[k].y : 0);
        out.quarters.push_back(0);
        out.on_bed.push_back(moves || k < most ? 0 : 1);
    }
    return out;
}

// Places the outlines on a bed of this size: copies of one in rows if they fit so, else by a search.
Nesting placed(const std::vector<Corners>& polygons, bool copies, Vec2 size, bool turn) {
    if (copies)
        if (auto rows = in_rows(polygons.front(), polygons.size(), size, turn)) return std::move(*rows);
    return nest(polygons, size.x, size.y, turn);
}

double rounded(double v) { return std::round(v / kGrid) * kGrid; }

} // namespace

std::vector<Spacing> spacings(std::span<const Thing> things, const machine::Head& head) {
    std::vector<Spacing> out;
    const auto add = [&](Vec2 room, bool clear) {
        out.push_back({std::max(room.x + kRounding, kLeast), std::max(room.y + kRounding, kLeast), clear});
    };
    const auto whole = head_room(head, second_highest(things));
    if (whole) add(*whole, true);
    const double nozzle = head.none ? 0 : head.cone_radius(head.cone_height);
    if (!whole || whole->x > nozzle || whole->y > nozzle) add({nozzle, nozzle}, false);
    return out;
}

Spacing spacing(double apart, std::span<const Thing> things, const machine::Head& head) {
    const auto whole = head_room(head, second_highest(things));
    return {apart, apart, whole && apart >= whole->x && apart >= whole->y};
}

Packing pack(std::span<const Thing> things, const Spacing& apart, Vec2 size, QuarterTurns turn) {
    Spacing keep = apart;
    if (turn == QuarterTurns::each) keep.x = keep.y = std::max(apart.x, apart.y);
    const Place first{{0, 0}, turn == QuarterTurns::all ? 1 : 0};
    std::vector<Corners> polygons;
    for (Thing t : things) {
        for (Vec2& p : t.outline) p = first(p);
        polygons.push_back(grown(t, keep));
    }
    // Grown outlines may reach over the edge of the bed by half the spacing. The bed is reduced by the rounding of
    // places.
    const Vec2 bed{size.x + keep.x - 2 * kGrid, size.y + keep.y - 2 * kGrid};
    const Nesting nested = placed(polygons, things.size() > 1 && alike(things), bed, turn == QuarterTurns::each);
    Packing out;
    geom::Box2 box;
    for (std::size_t i = 0; i < things.size(); ++i) {
        if (nested.on_bed[i] > 0) out.left.push_back(i);
        out.place.push_back({{nested.x[i], nested.y[i]}, (first.quarters + nested.quarters[i]) % 4});
        for (const Vec2& p : things[i].outline) box.add(out.place[i](p));
    }
    const Vec2 middle = 0.5 * (box.lo + box.hi);
    for (Place& p : out.place) p.move = {rounded(p.move.x - middle.x), rounded(p.move.y - middle.y)};
    if (!out.left.empty()) out.place.clear();
    return out;
}

} // namespace filum::plate
