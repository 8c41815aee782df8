#include "surfpath/lanes/rungs.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surfpath::lanes {

Rung rung(const Lanes& lanes, std::uint32_t lane, double arc, double side, double farthest, std::size_t most) {
    Rung out{{{lane, arc, 0}}, {1}};
    while (out.places.size() < most) {
        const LanePlace from = out.places.back();
        const auto next = lanes.across(from.lane, from.arc, side, farthest);
        if (!next) break;
        if (std::any_of(out.places.begin(), out.places.end(), [&](const auto& p) { return p.lane == next->lane; }))
            break;
        const Place a = lanes.at(from.lane, from.arc), b = lanes.at(next->lane, next->arc);
        const Vec3 t = lanes.tangent(next->lane, next->arc), before = lanes.tangent(from.lane, from.arc);
        if (std::abs(dot(t, before)) < 0.8) break;
        out.sense.push_back(dot(t, before) > 0 ? out.sense.back() : -out.sense.back());
        side = dot(cross(t, surface::normal(lanes.surface(), b.triangle)), b.point - a.point) > 0 ? 1 : -1;
        out.places.push_back(*next);
    }
    return out;
}

bool follows(const Lanes& lanes, const Rung& a, const Rung& b) {
    if (a.places.size() != b.places.size() || a.sense != b.sense) return false;
    for (std::size_t k = 0; k < a.places.size(); ++k) {
        const std::uint32_t lane = a.places[k].lane;
        if (lane != b.places[k].lane) return false;
        const double on = lanes.ahead(lane, a.places[k].arc, b.places[k].arc, a.sense[k]);
        if (!(on > 0) || 2 * on > lanes.length(lane)) return false; // it leads back
    }
    return true;
}

Ladder ladder(const std::vector<Rung>& rungs, double step) {
    Ladder out{{}, rungs[0].sense, {}, step};
    for (const auto& p : rungs[0].places) out.lane.push_back(p.lane);
    for (const auto& r : rungs) {
        out.arcs.emplace_back();
        for (const auto& p : r.places) out.arcs.back().push_back(p.arc);
    }
    return out;
}

double arc_at(const Lanes& lanes, const Ladder& rungs, std::size_t k, double v) {
    const auto i = static_cast<std::size_t>(std::clamp(std::floor(v), 0.0, rungs.last() - 1));
    const double a = rungs.arcs[i][k], f = v - static_cast<double>(i);
    return a + rungs.sense[k] * f * lanes.ahead(rungs.lane[k], a, rungs.arcs[i + 1][k], rungs.sense[k]);
}

Place place_at(const Lanes& lanes, const Ladder& rungs, Vec2 uv) {
    const auto top = static_cast<double>(rungs.lanes() - 1);
    const double u = std::clamp(uv.x, 0.0, top);
    const auto k = static_cast<std::size_t>(std::min(std::floor(u), std::max(0.0, top - 1)));
    const double f = u - static_cast<double>(k);
    const Place a = lanes.at(rungs.lane[k], arc_at(lanes, rungs, k, uv.y));
    if (f < 1e-9) return a;
    const Place b = lanes.at(rungs.lane[k + 1], arc_at(lanes, rungs, k + 1, uv.y));
    if (f > 1 - 1e-9) return b;
    const Line line = surface::curve::join(lanes.surface(), a, b);
    const auto arcs = surface::curve::arc_lengths(line);
    return surface::curve::at(line, arcs, f * arcs.back());
}

Line drawn(const Lanes& lanes, const Ladder& rungs, const std::vector<Vec2>& uv) {
    Line out;
    for (const Vec2 p : uv) out.places.push_back(place_at(lanes, rungs, p));
    return surface::curve::threaded(lanes.surface(), out);
}

double shortest(const Lanes& lanes, const Ladder& rungs) {
    double out = 1e300;
    for (std::size_t k = 0; k < rungs.lanes(); ++k) {
        double sum = 0;
        for (std::size_t i = 0; i + 1 < rungs.arcs.size(); ++i)
            sum += lanes.ahead(rungs.lane[k], rungs.arcs[i][k], rungs.arcs[i + 1][k], rungs.sense[k]);
        out = std::min(out, sum);
    }
    return out;
}

} // namespace filum::surfpath::lanes
