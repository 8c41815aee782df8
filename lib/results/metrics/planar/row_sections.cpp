#include "metrics/planar/row_sections.hpp"

#include <algorithm>
#include <cmath>

namespace filum::metrics::planar {

namespace {

SweptBead::Side side(Vec2 from, Vec2 to) {
    return {from.y, to.y, from.x, to.y > from.y ? (to.x - from.x) / (to.y - from.y) : 0};
}

// The distance along x from the middle of an end circle to its edge, on the row `dy` above or below the middle.
double half_chord(double half, double dy) { return std::sqrt(std::max(0.0, half * half - dy * dy)); }

} // namespace

SweptBead swept_bead(const Bead& bead) {
    SweptBead out;
    const bool up = bead.a.y <= bead.b.y;
    out.lower = up ? bead.a : bead.b;
    out.upper = up ? bead.b : bead.a;
    out.half = bead.width / 2;
    out.slot = bead.slot;
    out.lo = out.lower.y - out.half;
    out.hi = out.upper.y + out.half;
    const double length = geom::distance(bead.a, bead.b);
    const Vec2 along = length > 0 ? (1 / length) * (out.upper - out.lower) : Vec2{1, 0};
    const Vec2 across = out.half * geom::left_of(along); // towards small x, because `along` points upwards
    out.left = side(out.lower + across, out.upper + across);
    out.right = side(out.lower - across, out.upper - across);
    return out;
}

bool section(const SweptBead& l, double y, Interval& out) {
    out = {0, 0, l.slot};
    if (y <= l.lo || y >= l.hi) return false;
    const auto edge = [&](const SweptBead::Side& s, double outwards) {
        if (y < s.from) return l.lower.x + outwards * half_chord(l.half, y - l.lower.y);
        if (y > s.to) return l.upper.x + outwards * half_chord(l.half, y - l.upper.y);
        return s.x + s.slope * (y - s.from);
    };
    out.lo = edge(l.left, -1);
    out.hi = edge(l.right, 1);
    return out.lo < out.hi;
}

std::vector<SweptBead> swept_beads(std::span<const Bead> beads) {
    struct Start {
        double lo;
        std::uint32_t bead;
    };
    std::vector<Start> starts; // small, so that they sort fast
    starts.reserve(beads.size());
    for (const Bead& b : beads)
        starts.push_back({std::min(b.a.y, b.b.y) - b.width / 2, static_cast<std::uint32_t>(starts.size())});
    std::sort(starts.begin(), starts.end(),
              [](const Start& p, const Start& q) { return p.lo != q.lo ? p.lo < q.lo : p.bead < q.bead; });
    std::vector<SweptBead> out;
    out.reserve(beads.size());
    for (const Start& s : starts) out.push_back(swept_bead(beads[s.bead]));
    return out;
}

void unite(std::vector<Interval>& v) {
    const auto before = [](const Interval& p, const Interval& q) {
        return p.slot != q.slot ? p.slot < q.slot : p.lo < q.lo;
    };
    if (!std::is_sorted(v.begin(), v.end(), before)) std::sort(v.begin(), v.end(), before);
    std::vector<Interval> out;
    for (const Interval& i : v) add_united(i, out);
    v = std::move(out);
}

double shared_length(const std::vector<Interval>& a, const std::vector<Interval>& b) {
    double sum = 0;
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size(); ++(a[i].hi < b[j].hi ? i : j))
        sum += std::max(0.0, std::min(a[i].hi, b[j].hi) - std::max(a[i].lo, b[j].lo));
    return sum;
}

void RowSweep::move_to(double y, std::vector<Interval>& out) {
    std::erase_if(live_, [&](const LiveBead& l) { return all_[l.bead].hi <= y; });
    for (LiveBead& l : live_) l.meets = section(all_[l.bead], y, l.at);
    for (std::size_t i = 1; i < live_.size(); ++i)
        for (std::size_t k = i; k > 0 && before(live_[k], live_[k - 1]); --k) std::swap(live_[k], live_[k - 1]);
    const auto known = static_cast<std::ptrdiff_t>(live_.size());
    for (; next_ < all_.size() && all_[next_].lo < y; ++next_) {
        if (all_[next_].hi <= y) continue;
        LiveBead l{static_cast<std::uint32_t>(next_), false, {0, 0, all_[next_].slot}};
        l.meets = section(all_[next_], y, l.at);
        live_.push_back(l);
    }
    std::sort(live_.begin() + known, live_.end(), before);
    std::inplace_merge(live_.begin(), live_.begin() + known, live_.end(), before);
    out.clear();
    for (const LiveBead& l : live_)
        if (l.meets) add_united(l.at, out);
}

} // namespace filum::metrics::planar
