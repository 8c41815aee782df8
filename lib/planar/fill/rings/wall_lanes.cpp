#include "fill/rings/wall_lanes.hpp"

#include "fill/rings/beading.hpp"
#include "fill/rings/short_changes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace filum::fill::rings {

namespace {

constexpr double kUnset = -std::numeric_limits<double>::infinity();
constexpr double kApart = 1e-6; // share of a piece: cuts nearer than this are merged

int lanes_at(double radius_in_widths) {
    return std::max(1, static_cast<int>(std::floor(0.5 + std::sqrt(0.25 + radius_in_widths * radius_in_widths))));
}

// Positions at which pieces of the axis are cut, piece by piece.
struct PieceCuts {
    std::vector<double> at;
    std::vector<std::uint32_t> start{0};

    void add(double t) {
        if (t > kApart && t < 1 - kApart) at.push_back(t);
    }
    void close() {
        const auto first = at.begin() + start.back();
        std::sort(first, at.end());
        at.erase(std::unique(first, at.end(), [](double a, double b) { return b - a < kApart; }), at.end());
        start.push_back(static_cast<std::uint32_t>(at.size()));
    }
};

// Repeats the value of each piece for all parts into which it was cut.
template <class T>
std::vector<T> spread(const std::vector<T>& of_piece, const std::vector<std::uint32_t>& start) {
    std::vector<T> out;
    for (std::size_t e = 0; e < of_piece.size(); ++e) out.insert(out.end(), start[e + 1] - start[e] + 1, of_piece[e]);
    return out;
}

std::vector<char> walls(const MedialAxis& axis) {
    std::vector<char> out(axis.half_edges() / 2);
    for (std::uint32_t e = 0; e < out.size(); ++e) out[e] = axis.slope(2 * e) <= kWallSlope * (1 + 1e-9) ? 1 : 0;
    return out;
}

// The positions where walls pass a radius at which the number of lanes changes.
PieceCuts changes(const MedialAxis& axis, const std::vector<char>& wall, double width) {
    PieceCuts out;
    for (std::uint32_t e = 0; e < wall.size(); ++e) {
        const double a = axis.radius[axis.from[2 * e]] / width, b = axis.radius[axis.to(2 * e)] / width;
        if (wall[e])
            for (int n = lanes_at(std::min(a, b)); n < lanes_at(std::max(a, b)); ++n)
                out.add((std::sqrt(n * (n + 1.0)) - a) / (b - a));
        out.close();
    }
    return out;
}

// The axis with nodes where the number of lanes changes. Per piece: whether it belongs to a wall, and its number of
// lanes.
struct LanePieces {
    MedialAxis axis;
    std::vector<char> wall;
    std::vector<int> lanes;
};

LanePieces pieces(const MedialAxis& given, double width) {
    const std::vector<char> wall = walls(given);
    const PieceCuts changing = changes(given, wall, width);
    LanePieces out{refined(given, changing.at, changing.start), spread(wall, changing.start), {}};
    const MedialAxis& axis = out.axis;
    for (std::uint32_t e = 0; e < out.wall.size(); ++e) {
        const double r = (axis.radius[axis.from[2 * e]] + axis.radius[axis.to(2 * e)]) / 2;
        out.lanes.push_back(out.wall[e] ? lanes_at(r / width) : 0);
    }
    out.lanes = without_short_changes(axis, out.wall, std::move(out.lanes), width);
    return out;
}

// Decrease of an envelope along a piece: 1 per half ramp; across corners 1 per half width of radius.
double fall(const MedialAxis& axis, std::uint32_t h, bool wall, double width) {
    const double along = 2 * axis.length(h) / (kRamp * width);
    if (wall) return along;
    return std::max(along, 2 * std::abs(axis.radius[axis.from[h]] - axis.radius[axis.to(h)]) / width);
}

struct Visit {
    double value;
    std::uint32_t node;
    friend bool operator<(const Visit& a, const Visit& b) {
        return a.value != b.value ? a.value < b.value : a.node > b.node;
    }
};

// Raises `value` (kUnset where it is undefined) to the least function above it that decreases no faster than fall().
// Outside of walls it is followed only until it has decreased by 1, as walls of equal thickness do not differ by more.
void raise(const LanePieces& p, double width, const std::vector<std::uint32_t>& half_at, std::vector<double>& value) {
    const MedialAxis& axis = p.axis;
    std::priority_queue<Visit> queue;
    std::vector<double> fallen(value.size(), 0); // decrease since the last wall
    const auto go_on = [&](std::uint32_t i) {
        std::uint32_t h = half_at[i];
        do {
            const bool on_wall = p.wall[h / 2] != 0;
            const double down = fall(axis, h, on_wall, width), beyond = on_wall ? 0 : fallen[i] + down;
            const std::uint32_t j = axis.to(h);
            if (beyond < 1 && value[i] - down > value[j] + 1e-9) {
                value[j] = value[i] - down;
                fallen[j] = beyond;
                queue.push({value[j], j});
            }
            h = axis.next[h ^ 1];
        } while (h != half_at[i]);
    };
    for (std::uint32_t i = 0; i < value.size(); ++i)
        if (value[i] != kUnset) go_on(i);
    while (!queue.empty()) {
        const Visit v = queue.top();
        queue.pop();
        if (v.value == value[v.node]) go_on(v.node);
    }
}

// Per node the least function above the number of lanes, and the greatest below it, that change no faster than ramps;
// kUnset where no wall or top leads to the node.
struct Envelopes {
    std::vector<double> upper, lower; // `lower` is negative
    std::vector<char> set;            // per node: it belongs to a wall, or is a top
};

Envelopes envelopes(const LanePieces& p, double width) {
    const MedialAxis& axis = p.axis;
    std::vector<std::uint32_t> half_at(axis.nodes());
    std::vector<char> top(axis.nodes(), 1);
    Envelopes out;
    for (auto* v : {&out.upper, &out.lower}) v->assign(axis.nodes(), kUnset);
    const auto limit = [&](std::uint32_t i, double lanes) {
        out.upper[i] = std::max(out.upper[i], lanes);
        out.lower[i] = std::max(out.lower[i], -lanes);
    };
    for (std::uint32_t h = 0; h < axis.half_edges(); ++h) {
        const std::uint32_t i = axis.from[h];
        half_at[i] = h;
        if (axis.radius[axis.to(h)] > axis.radius[i]) top[i] = 0;
        if (p.wall[h / 2]) limit(i, p.lanes[h / 2]);
    }
    for (std::uint32_t i = 0; i < axis.nodes(); ++i) {
        if (top[i] && out.upper[i] == kUnset) limit(i, lanes_at(axis.radius[i] / width));
        out.set.push_back(out.upper[i] != kUnset ? 1 : 0);
    }
    raise(p, width, half_at, out.upper);
    raise(p, width, half_at, out.lower);
    return out;
}

// The two envelopes on a wall piece with n lanes, as functions of the parameter t along it.
struct Ramp {
    double n, rise;            // rise: change of an envelope along the piece
    double upper[2], lower[2]; // at its ends

    [[nodiscard]] double lanes(double t) const {
        const double u = std::max({n, upper[0] - t * rise, upper[1] - (1 - t) * rise});
        const double l = std::min({n, lower[0] + t * rise, lower[1] + (1 - t) * rise});
        return (u + l) / 2;
    }
    [[nodiscard]] bool level() const { return upper[0] == n && upper[1] == n && lower[0] == n && lower[1] == n; }

    // Adds the positions where an envelope bends, where the number of lanes is whole, and where a lane begins.
    void add_cuts(PieceCuts& out) const {
        std::vector<double> bends{0, 1};
        for (const auto& [a, b] : {std::pair{upper[0] - n, upper[1] - n}, std::pair{n - lower[0], n - lower[1]}})
            for (const double t : {a / rise, 1 - b / rise, 0.5 + (a - b) / (2 * rise)})
                if (t > 0 && t < 1) bends.push_back(t);
        std::sort(bends.begin(), bends.end());
        for (std::size_t i = 0; i + 1 < bends.size(); ++i) {
            out.add(bends[i]);
            const double a = lanes(bends[i]), b = lanes(bends[i + 1]), lo = std::min(a, b), hi = std::max(a, b);
            for (double k = std::floor(lo); k < hi; ++k)
                for (const double f : {k, k + kLeastLane})
                    if (f > lo && f < hi) out.add(bends[i] + (f - a) / (b - a) * (bends[i + 1] - bends[i]));
        }
    }
};

// The mean of the envelopes as the number of lanes, with nodes wherever it bends.
WallLanes with_ramps(const LanePieces& p, const Envelopes& between, double width) {
    WallLanes out;
    out.set = between.set;
    for (std::uint32_t i = 0; i < p.axis.nodes(); ++i)
        out.lanes.push_back(out.set[i] ? (between.upper[i] - between.lower[i]) / 2 : 0);
    PieceCuts cuts;
    for (std::uint32_t e = 0; e < p.wall.size(); ++e) {
        const std::uint32_t a = p.axis.from[2 * e], b = p.axis.to(2 * e);
        const Ramp ramp{static_cast<double>(p.lanes[e]),
                        2 * p.axis.length(2 * e) / (kRamp * width),
                        {between.upper[a], between.upper[b]},
                        {-between.lower[a], -between.lower[b]}};
        if (p.wall[e] && !ramp.level()) ramp.add_cuts(cuts);
        cuts.close();
        for (std::size_t k = cuts.start[e]; k < cuts.start[e + 1]; ++k) out.lanes.push_back(ramp.lanes(cuts.at[k]));
    }
    out.set.resize(out.lanes.size(), 1); // only walls are cut
    out.axis = refined(p.axis, cuts.at, cuts.start);
    out.wall = spread(p.wall, cuts.start);
    return out;
}

} // namespace

WallLanes wall_lanes(const MedialAxis& axis, double width) {
    const LanePieces p = pieces(axis, width);
    return with_ramps(p, envelopes(p, width), width);
}

} // namespace filum::fill::rings
