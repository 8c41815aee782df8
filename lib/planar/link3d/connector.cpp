#include "link3d/connector.hpp"

#include "geom/segment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace filum::link3d {

namespace {

using toolpath::Role;
using toolpath::Span;

constexpr double kNeck = 0.4;       // share of the flow where a connector is to break off
constexpr double kNeckLength = 2;   // bead widths
constexpr double kDetourMargin = 2; // bead widths between the part and the way around
constexpr double kUncarried = 0.1;  // share of a carried connector that may hang free
constexpr double kClearance = 0.05; // mm between the head and the part

// Inserts a point into the path, `at` mm from its beginning, measured in XY.
void insert_point(std::vector<Vec3>& way, double at) {
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        const double l = geom::distance(way[i].xy(), way[i + 1].xy());
        if (at < l) {
            const double t = at / l;
            if (at > 0)
                way.insert(way.begin() + static_cast<std::ptrdiff_t>(i + 1),
                           {way[i].x + t * (way[i + 1].x - way[i].x), way[i].y + t * (way[i + 1].y - way[i].y),
                            way[i].z + t * (way[i + 1].z - way[i].z)});
            return;
        }
        at -= l;
    }
}

double length_xy(std::span<const Vec3> way) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) sum += geom::distance(way[i].xy(), way[i + 1].xy());
    return sum;
}

// The widths of a connector that is thin at both ends. Adds points to the path where the width changes.
std::vector<double> necks(std::vector<Vec3>& way, double width) {
    const double all = length_xy(way), neck = std::min(kNeckLength * width, all / 4), change = neck / 4;
    for (const double at : {neck, neck + change, all - neck - change, all - neck}) insert_point(way, at);
    std::vector<double> out;
    double s = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
        if (i > 0) s += geom::distance(way[i - 1].xy(), way[i].xy());
        const double in = std::min(s, all - s);
        out.push_back(width * (kNeck + (1 - kNeck) * std::clamp((in - neck) / change, 0.0, 1.0)));
    }
    return out;
}

// Length of the connector that hangs in the air, mm: there is no bed below it, and no connector one layer lower.
double uncarried(const State& state, std::span<const Vec3> way) {
    const auto& r = state.region();
    double free = 0;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        const double l = geom::distance(way[i].xy(), way[i + 1].xy()), z = way[i].z;
        if (l == 0 || z < 1.5 * r.paths.height) continue;
        const int pieces = static_cast<int>(std::ceil(l / r.width));
        for (int k = 0; k < pieces; ++k) {
            const Vec2 p = geom::lerp(way[i].xy(), way[i + 1].xy(), (k + 0.5) / pieces);
            const bool carried = std::any_of(state.strands.begin(), state.strands.end(), [&](const auto& s) {
                const double down = z - s.first.z;
                return down > 0.5 * r.paths.height && down < 1.5 * r.paths.height &&
                       geom::point_segment_distance(s.first.xy(), s.second.xy(), p) < r.width;
            });
            if (!carried) free += l / pieces;
        }
    }
    return free;
}

// The bounds of the part: of everything printed and of all regions known.
Box2 all_bounds(const State& state) {
    Box2 box = state.printed.bounds();
    for (const auto& w : state.window)
        if (!w.index.empty()) {
            box.add(w.index.bounds().lo);
            box.add(w.index.bounds().hi);
        }
    return box;
}

// Whether the straight way a -> b at one height meets no region of its layer that is still to be printed. The front
// region counts only if `front`.
bool misses_others(const State& state, Vec3 a, Vec3 b, bool front) {
    const double near = state.region().paths.height / 2;
    return std::all_of(state.window.begin() + (front ? 0 : 1), state.window.end(), [&](const WaitingRegion& w) {
        return std::abs(w.paths.z - a.z) > near || is_free(w.index, a.xy(), b.xy(), kMargin, 0, 0);
    });
}

// Whether the straight way a -> b stays clear of the regions still to be printed below it. Its bead must not lie over
// them, and the head must not meet the bead while it prints them.
bool misses_later(const State& state, Vec3 a, Vec3 b) {
    const auto& head = state.options.head;
    const double high = std::max(a.z, b.z), near = state.region().paths.height / 2;
    return std::ranges::all_of(state.window, [&](const WaitingRegion& w) {
        const double up = high - w.paths.z;
        if (up <= near) return true;
        if (!head.none && up > head.gantry_height) return false;
        double margin = state.region().width;
        if (!head.none)
            margin += up > head.cone_height ? std::hypot(head.carriage_x, head.carriage_y) / 2 : head.cone_radius(up);
        return is_free(w.index, a.xy(), b.xy(), margin, 0, 0);
    });
}

// Whether the straight way a -> b at one height crosses nothing of its own region and comes near nothing else that is
// as high.
bool leads_out(const State& state, Vec3 a, Vec3 b, const SegmentIndex& own, bool leaves) {
    const auto& r = state.region();
    return is_free(own, a.xy(), b.xy(), kMargin, kEnds, 0) &&
           !state.printed.blocks(a, b, a.z - r.paths.height / 2, kDetourMargin * r.width, leaves);
}

// The shortest path around the part to one of the front region's extreme places, or to an end of an open curve there.
std::optional<std::pair<std::vector<Vec3>, Entry>> way_around(const State& state, double margin) {
    const auto& r = state.region();
    const auto free = [&](Vec3 a, Vec3 b) {
        const bool leaves = a == *state.at;
        return leads_out(state, a, b, leaves ? state.before.lines.back() : r.index, leaves) &&
               misses_others(state, a, b, leaves) && (!leaves || leaves_freely(state, a.xy(), b.xy()));
    };
    const auto clear = [&](std::span<const Vec3> way) {
        if (PrintedBodies::meets_itself(way, r.width, state.options.head)) return false;
        for (std::size_t i = 0; i + 1 < way.size(); ++i)
            if (!misses_strands(state, way[i], way[i + 1]) ||
                state.printed.hits(way[i], way[i + 1], state.options.head) || !misses_later(state, way[i], way[i + 1]))
                return false;
        return true;
    };
    std::optional<std::pair<std::vector<Vec3>, Entry>> best;
    const auto consider = [&](const Entry& entry) {
        auto way = around(state.around, margin, *state.at, at_height(entry.place.point, r.paths.z), free, clear);
        if (way && (!best || length(*way) < length(best->first))) best = {std::move(*way), entry};
    };
    for (const Place& p : r.index.extremes()) {
        const auto& curve = r.paths.curves[p.curve];
        if (curve.closed) {
            consider({p});
            continue;
        }
        const auto n = static_cast<std::uint32_t>(curve.points.size());
        consider({{p.curve, 0, 0, curve.points.front(), 0}});
        consider({{p.curve, n - 2, 1, curve.points.back(), 0}, true});
    }
    return best;
}

} // namespace

std::optional<Entry> go_around(State& state) {
    const auto& r = state.region();
    if (!state.before.printed || state.before.lines.empty()) return std::nullopt;
    if (state.around.empty()) state.around = all_bounds(state);
    const auto& head = state.options.head;
    const double cone = head.cone_radius(head.cone_height), carriage = std::max(head.carriage_x, head.carriage_y) / 2;
    const double beside = state.printed.widest() / 2 + kClearance; // mm between middle lines and the head
    std::optional<std::pair<std::vector<Vec3>, Entry>> best;
    for (const double margin : {kDetourMargin * r.width, cone + beside, carriage + beside})
        if ((best = way_around(state, margin))) break;
    if (!best) return std::nullopt;
    auto& [way, entry] = *best;
    const double free = uncarried(state, way);
    if (state.options.connector_support == ConnectorSupport::carried && free > kUncarried * length_xy(way))
        return std::nullopt;
    ++state.counts.connectors;
    state.counts.connector_length += length_xy(way);
    state.counts.connector_free += free;
    const Vec3 middle = way[way.size() / 2];
    state.front.joins.push_back({false, {way[way.size() - 2].xy(), way.back().xy()}, {r.width}});
    state.printed.connector(way, r.width);
    for (std::size_t i = 0; i + 1 < way.size(); ++i) state.strands.emplace_back(way[i], way[i + 1]);
    state.printed.begin(); // the two ends of a connector are two bodies
    Span out = span(state, Role::connector);
    out.width = necks(way, r.width);
    out.points = std::move(way);
    out.height = {r.paths.height};
    double volume = 0;
    for (std::size_t i = 0; i + 1 < out.points.size(); ++i) volume += toolpath::volume(out, i);
    state.counts.connector_volume += volume;
    state.notes.push_back({NoteCode::connector_to_trim, volume, 1, r.paths.layer, middle.x, middle.y});
    put(state, std::move(out));
    return entry;
}

std::optional<Entry> go_inside(State& state) {
    const auto& r = state.region();
    if (!beside_last(state)) return std::nullopt;
    const auto entry = nearest_entry(r, state.at->xy());
    if (!entry) return std::nullopt;
    const Vec3 a = *state.at, b = at_height(entry->place.point, r.paths.z);
    if (!leaves_freely(state, a.xy(), b.xy()) || !leads_out(state, b, a, r.index, true) ||
        state.printed.hits(a, b, state.options.head) || !misses_others(state, a, b, false) ||
        !misses_strands(state, a, b) || !misses_later(state, a, b))
        return std::nullopt;
    state.strands.emplace_back(a, b);
    state.printed.strand(a, b, r.width);
    ++state.counts.strands;
    state.counts.strand_length += entry->place.distance;
    state.printed.begin();
    jog(state, *entry);
    return entry;
}

bool sees_outside(const State& state, Vec2 p, const SegmentIndex& own) {
    const auto& r = state.region();
    if (state.options.connect == Connect::inside) {
        const auto next = nearest_entry(state.window[1], p);
        return next && is_free(own, p, next->place.point, kMargin, kEnds, 0);
    }
    const Box2 box = all_bounds(state);
    const double m = 2 * r.width;
    const Vec3 a = at_height(p, r.paths.z);
    const std::array<Vec2, 4> ends{
        {{box.lo.x - m, p.y}, {box.hi.x + m, p.y}, {p.x, box.lo.y - m}, {p.x, box.hi.y + m}}};
    return std::any_of(ends.begin(), ends.end(), [&](Vec2 b) {
        return leads_out(state, a, at_height(b, a.z), own, true) && misses_others(state, a, at_height(b, a.z), false);
    });
}

} // namespace filum::link3d
