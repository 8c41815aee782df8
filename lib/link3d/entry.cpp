// Where the linker enters a curve.
#include "geom/segment.hpp"
#include "link3d/linker.hpp"

#include <algorithm>

namespace filum::link3d {

namespace {

constexpr double kInside = 0.8; // bead widths: farther from all beads of a region is outside it
constexpr double kFar = 100;    // sizes of a region: from there, what lies farther back is nearer

// A shorter piece before a sharp corner would fold over its neighbours where machine code rounds it.
Place at_corner(Place place, const toolpath::Curve& curve, Vec2 from) {
    const Vec2 a = curve.points[place.segment], b = curve.points[(place.segment + 1) % curve.points.size()];
    const double to_a = geom::distance(place.point, a), to_b = geom::distance(place.point, b);
    if (std::min(to_a, to_b) >= kCorner) return place;
    place.t = to_a <= to_b ? 0 : 1;
    place.point = to_a <= to_b ? a : b;
    place.distance = geom::distance(place.point, from);
    return place;
}

} // namespace

// The nearest place of a closed curve or end of an open one, of those not done.  Tie: closed curves first, then by
// index.
std::optional<Linker::Entry> Linker::nearest_entry(const Waiting& r, Vec2 p, double limit, std::span<const char> done) {
    std::optional<Entry> best;
    if (r.closed) {
        std::vector<char> skip;
        if (r.open || !done.empty()) {
            skip.assign(done.begin(), done.end());
            skip.resize(r.paths.curves.size(), 0);
            if (r.open)
                for (std::size_t c = 0; c < skip.size(); ++c)
                    skip[c] = skip[c] != 0 || !r.paths.curves[c].closed ? 1 : 0;
        }
        if (const auto place = r.index.nearest(p, limit, skip)) {
            best = Entry{at_corner(*place, r.paths.curves[place->curve], p), false};
            limit = place->distance;
        }
    }
    if (!r.open) return best;
    for (std::uint32_t c = 0; c < r.paths.curves.size(); ++c) {
        const auto& curve = r.paths.curves[c];
        if (curve.closed || (!done.empty() && done[c] != 0)) continue;
        for (const bool against : {false, true}) {
            const Vec2 end = against ? curve.points.back() : curve.points.front();
            const double d = geom::distance(end, p);
            if (d > limit || (best && d == limit)) continue;
            const auto segment = against ? static_cast<std::uint32_t>(curve.points.size()) - 2 : 0;
            best = Entry{{c, segment, against ? 1.0 : 0.0, end, d}, against};
            limit = d;
        }
    }
    return best;
}

// How many regions behind the front one climb from it without a break, of those that it looks ahead.
std::size_t Linker::climbing() const {
    std::size_t n = 0;
    while (static_cast<std::int64_t>(n) < options_.look_ahead && n + 1 < window_.size() && goes_on(window_[n + 1]) &&
           !window_[n + 1].paths.curves.empty())
        ++n;
    return n;
}

// The first place of a stroke.
Linker::Entry Linker::start_entry() const {
    const auto& r = window_.front();
    Vec2 p = at_ ? at_->xy() : r.index.bounds().lo;
    const std::size_t n = climbing();
    if (options_.seam == Seam::inside) {
        const Box2 box = window_[n].index.bounds();
        p = geom::lerp(box.lo, box.hi, 0.5);
    } else if (options_.seam == Seam::back) { // the middle of the far side, from so far that all of it is as near
        const Box2 box = window_[n].index.bounds();
        p = {(box.lo.x + box.hi.x) / 2, box.hi.y + kFar * (box.hi.x - box.lo.x + box.hi.y - box.lo.y)};
    } else if (options_.seam == Seam::place) {
        p = options_.seam_at;
    }
    // The stroke is to leave the last region of the column on the side of the next one.
    if (options_.connect == Connect::inside && n + 1 < window_.size() && !window_[n + 1].index.empty()) {
        const Box2 here = window_[n].index.bounds();
        p = window_[n].index.nearest(window_[n + 1].index.nearest(geom::lerp(here.lo, here.hi, 0.5))->point)->point;
    }
    // Back from the last region that is known: so the column can be climbed from there.
    for (std::size_t k = n; k > 0; --k) {
        const auto& above = window_[k];
        if (const auto e = nearest_entry(above, p, std::numeric_limits<double>::infinity(), {});
            e->place.distance > above.width / 2)
            p = e->place.point;
    }
    return *nearest_entry(r, p, std::numeric_limits<double>::infinity(), {});
}

// Another place in reach of the nozzle, nearer to where the column goes, that can be reached without crossing a bead.
// Only as far as it must be to be there in time.
Linker::Entry Linker::drift(const Entry& nearest) {
    const auto& r = window_.front();
    const Vec2 from = at_->xy();
    if (!r.paths.curves[nearest.place.curve].closed || r.paths.curves.size() > 1) return nearest;
    for (std::size_t k = 1, n = climbing(); k <= n; ++k) {
        const auto goal = nearest_entry(window_[k], from, std::numeric_limits<double>::infinity(), {});
        if (goal->place.distance <= options_.reach / 2 * window_[k].width) continue; // with as much to spare
        const Vec2 to = goal->place.point;
        const double step =
            std::min(options_.reach * r.width, std::max(r.width, 1.5 * goal->place.distance / static_cast<double>(k)));
        const Entry entry = step_towards(nearest, to, step);
        if (entry.place.point != nearest.place.point && nearest.place.distance < kOn) pin_ = from;
        return entry;
    }
    return nearest;
}

// The jog a -> b keeps off all beads of the front region's one curve but where it begins and ends, and crosses none but
// the segment that it begins on.  And it stays so near to that curve that it cannot meet a neighbour of the region.
bool Linker::leads_free(Vec2 a, Vec2 b, std::optional<std::uint32_t> on) const {
    const double l = geom::distance(a, b);
    if (l <= kSamePoint) return true;
    const double ends = std::min(1.0, kEnds / l);
    const Vec2 last = geom::lerp(b, a, kSamePoint / l), off = geom::lerp(b, a, ends),
               away = geom::lerp(a, b, std::min(1.0, 2 * kOn / l));
    Box2 box;
    box.add(a);
    box.add(last);
    box.lo = box.lo - Vec2{kMargin, kMargin};
    box.hi = box.hi + Vec2{kMargin, kMargin};
    bool free = true;
    window_.front().index.within(box, [&](std::uint32_t s, Vec2 c, Vec2 d) {
        const bool at_begin = on && geom::point_segment_distance(c, d, a) <= 2 * kOn;
        const bool apart = l <= kEnds || geom::segment_distance(at_begin ? away : a, off, c, d) > kMargin;
        return free = apart && (s == on || !geom::cross_properly(a, last, c, d));
    });
    if (l <= kEnds) return free;
    const auto& r = window_.front();
    for (int k = 0; k < 8 && free; ++k)
        free = r.index.nearest(geom::lerp(a, b, k / 8.0), kInside * r.width).has_value();
    return free;
}

// Among the places in `step` mm of the nozzle the one nearest to `to` that is reached freely; `nearest` if there is
// none.
Linker::Entry Linker::step_towards(const Entry& nearest, Vec2 to, double step) const {
    const auto& r = window_.front();
    const Vec2 from = at_->xy();
    struct Candidate {
        double left; // mm from the goal
        std::uint32_t segment;
        double t;
    };
    std::vector<Candidate> candidates;
    const bool on = nearest.place.distance < kOn;
    const double least = geom::distance(nearest.place.point, to) - 0.1 * r.width;
    r.index.within({from - Vec2{step, step}, from + Vec2{step, step}}, [&](std::uint32_t s, Vec2 a, Vec2 b) {
        // the part of a -> b inside the circle, and its point nearest to the goal
        const double l = geom::distance(a, b), foot = l > 0 ? geom::dot(from - a, b - a) / (l * l) : 0;
        const double off = geom::distance(geom::lerp(a, b, foot), from);
        if (off > step) return true;
        const double half = l > 0 ? std::sqrt(step * step - off * off) / l : 0;
        const double lo = std::max(0.0, foot - half), hi = std::min(1.0, foot + half);
        if (lo > hi) return true;
        const double t = std::clamp(geom::nearest_parameter(a, b, to), lo, hi);
        if (on && geom::point_segment_distance(a, b, from) <= 2 * kOn) return true; // along the bead
        if (const double left = geom::distance(geom::lerp(a, b, t), to); left < least)
            candidates.push_back({left, s, t});
        return true;
    });
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const auto& a, const auto& b) { return a.left < b.left; });
    for (std::size_t i = 0; i < std::min<std::size_t>(candidates.size(), 32); ++i) {
        const Place found = r.index.place(candidates[i].segment, candidates[i].t, from);
        if (!r.paths.curves[found.curve].closed) continue;
        const Place place = at_corner(found, r.paths.curves[found.curve], from);
        if (leads_free(from, place.point, on ? std::optional(nearest.place.segment) : std::nullopt))
            return {place, false};
    }
    return nearest;
}

} // namespace filum::link3d
