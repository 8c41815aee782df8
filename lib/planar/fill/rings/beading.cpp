#include "fill/rings/beading.hpp"

#include "fill/rings/wall_lanes.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

namespace filum::fill::rings {

namespace {

// Radius of the disc that touches both sides of a corner and leaves a tip of `area` beyond it.
double tip_radius(double slope, double area) {
    const double a = std::asin(slope);
    return std::sqrt(area / std::max(0.0, 1 / std::tan(a) - std::numbers::pi / 2 + a));
}

// Properties of the axis from which profiles are computed.
struct AxisProperties {
    std::vector<std::uint32_t> falling; // nodes by decreasing radius; ties by number
    std::vector<std::uint32_t> up;      // per node: the half-edge to its highest neighbour
    std::vector<char> dead_end;         // per node: all paths down from it end in corners
    std::vector<double> arms;           // per node: mm2 of the walls down from it
};

AxisProperties properties(const WallLanes& walls) {
    const MedialAxis& axis = walls.axis;
    AxisProperties out;
    out.falling.resize(axis.nodes());
    std::iota(out.falling.begin(), out.falling.end(), 0U);
    std::sort(out.falling.begin(), out.falling.end(), [&](std::uint32_t a, std::uint32_t b) {
        return axis.radius[a] != axis.radius[b] ? axis.radius[a] > axis.radius[b] : a < b;
    });
    out.up.assign(axis.nodes(), axis.half_edges());
    for (std::uint32_t h = 0; h < axis.half_edges(); ++h) {
        std::uint32_t& up = out.up[axis.from[h]];
        if (up == axis.half_edges() || axis.radius[axis.to(h)] > axis.radius[axis.to(up)]) up = h;
    }
    out.dead_end.assign(axis.nodes(), 0);
    out.arms.assign(axis.nodes(), 0);
    for (std::size_t k = axis.nodes(); k-- > 0;) {
        const std::uint32_t i = out.falling[k];
        bool lower = false, dead = true;
        std::uint32_t h = out.up[i];
        do {
            const std::uint32_t j = axis.to(h);
            if (axis.radius[j] < axis.radius[i]) {
                lower = true;
                dead = dead && out.dead_end[j];
                const double wide = walls.wall[h / 2] ? axis.radius[i] + axis.radius[j] : 0;
                out.arms[i] += out.arms[j] + wide * geom::distance(axis.node[i], axis.node[j]);
            }
            h = axis.next[h ^ 1];
        } while (h != out.up[i]);
        out.dead_end[i] = axis.radius[i] == 0 || (lower && dead) ? 1 : 0;
    }
    return out;
}

class ProfileBuilder {
  public:
    ProfileBuilder(WallLanes walls, double width, double least_void)
        : walls_(std::move(walls)), axis_properties_(properties(walls_)), least_void_(least_void) {
        out_.width = width;
        out_.profile.resize(walls_.axis.nodes());
    }

    Beading run() {
        for (const std::uint32_t i : axis_properties_.falling) walls_.set[i] ? of_wall(i) : of_corner(i);
        find_ends();
        out_.axis = std::move(walls_.axis);
        out_.wall = std::move(walls_.wall);
        return std::move(out_);
    }

  private:
    [[nodiscard]] const MedialAxis& axis() const { return walls_.axis; }

    void of_wall(std::uint32_t i) {
        Profile& p = out_.profile[i];
        p.lanes = p.top = walls_.lanes[i];
        p.full = std::max(0.0, p.lanes - 1);
        p.inner = (axis().radius[i] - out_.width * p.full) / (p.lanes - p.full);
    }
    // A corner has the profile of the node to which it leads up.
    void of_corner(std::uint32_t i) {
        Profile& p = out_.profile[i];
        p = out_.profile[axis().to(axis_properties_.up[i])];
        const double rest = axis().radius[i] - out_.width * p.full;
        p.lanes = rest <= 0 ? axis().radius[i] / out_.width : p.full + rest / p.inner;
    }

    // Computes `reach` and `last` from the top down, so that no lane that has ended begins again in a tip further
    // down.
    void find_ends() {
        out_.reach.assign(walls_.wall.size(), 0.5);
        out_.tip.assign(walls_.wall.size(), 0);
        for (std::uint32_t e = 0; e < walls_.wall.size(); ++e) {
            const bool rises = axis().radius[axis().from[2 * e]] < axis().radius[axis().to(2 * e)];
            const std::uint32_t low = rises ? axis().from[2 * e] : axis().to(2 * e);
            if (!axis_properties_.dead_end[low]) continue;
            const double radius = tip_radius(axis().slope(2 * e), least_void_);
            if (walls_.wall[e])
                out_.tip[e] = radius;
            else
                out_.reach[e] = std::clamp(radius / std::min(out_.width, out_.profile[low].inner), kLeastLane / 2, 0.5);
        }
        for (const std::uint32_t i : axis_properties_.falling) {
            const std::uint32_t up = axis_properties_.up[i], u = axis().to(up);
            Profile& p = out_.profile[i];
            p.last = p.top - kLeastLane;
            if (!walls_.set[i]) p.last = std::min(p.last, p.lanes - out_.reach[up / 2]);
            // At a neck, or at the start of a thin arm that is large enough, the first lane passes through on both
            // sides.
            const bool arm = !walls_.set[i] && axis_properties_.arms[i] > least_void_;
            if ((!axis_properties_.dead_end[i] || arm) && p.lanes < 1) {
                p.top = p.lanes;
                p.last = 0;
            }
            if (!axis_properties_.dead_end[i] || axis().radius[u] <= axis().radius[i]) continue;
            if (axis().radius[i] < out_.tip[up / 2]) p.last = -1; // no lane
            const double above = out_.profile[u].last;
            if (!walls_.set[i] || above < 0) p.last = std::min(p.last, above);
        }
    }

    WallLanes walls_;
    AxisProperties axis_properties_;
    double least_void_;
    Beading out_;
};

} // namespace

Beading beading(const MedialAxis& axis, double width, double least_void) {
    return ProfileBuilder(wall_lanes(axis, width), width, least_void).run();
}

} // namespace filum::fill::rings
