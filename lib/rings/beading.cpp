#include "rings/beading.hpp"

#include "rings/wall_lanes.hpp"

#include <cmath>
#include <numbers>
#include <numeric>
#include <queue>

namespace filum::rings {

namespace {

// Radius of the disc that touches both sides of a corner and leaves a tip of `area` beyond it.
double tip_radius(double slope, double area) {
    const double a = std::asin(slope);
    return std::sqrt(area / std::max(0.0, 1 / std::tan(a) - std::numbers::pi / 2 + a));
}

// What of the axis the profiles are told by.
struct Relief {
    std::vector<std::uint32_t> falling; // nodes by falling radius; ties by number
    std::vector<std::uint32_t> up;      // per node: the half-edge to its highest neighbour
    std::vector<char> dead_end;         // per node: all ways down from it lead to corners
};

Relief relief(const MedialAxis& axis) {
    Relief out;
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
    for (std::size_t k = axis.nodes(); k-- > 0;) {
        const std::uint32_t i = out.falling[k];
        bool lower = false, dead = true;
        std::uint32_t h = out.up[i];
        do {
            const std::uint32_t j = axis.to(h);
            if (axis.radius[j] < axis.radius[i]) {
                lower = true;
                dead = dead && out.dead_end[j];
            }
            h = axis.next[h ^ 1];
        } while (h != out.up[i]);
        out.dead_end[i] = axis.radius[i] == 0 || (lower && dead) ? 1 : 0;
    }
    return out;
}

class Profiles {
  public:
    Profiles(WallLanes walls, double width, double least_void)
        : walls_(std::move(walls)), relief_(relief(walls_.axis)), least_void_(least_void) {
        out_.width = width;
        out_.profile.resize(walls_.axis.nodes());
    }

    Beading run() {
        for (const std::uint32_t i : relief_.falling) walls_.set[i] ? of_wall(i) : of_corner(i);
        blend();
        for (std::uint32_t i = 0; i < axis().nodes(); ++i) {
            Profile& p = out_.profile[i];
            const double rest = axis().radius[i] - out_.width * p.full;
            if (!walls_.set[i]) p.lanes = rest <= 0 ? axis().radius[i] / out_.width : p.full + rest / p.inner;
            p.top = std::max(p.top, p.lanes);
        }
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
    void of_corner(std::uint32_t i) { out_.profile[i] = out_.profile[axis().to(relief_.up[i])]; }

    struct Visit {
        double along;
        std::uint32_t node, source;
        friend bool operator<(const Visit& a, const Visit& b) {
            return a.along != b.along ? a.along > b.along : a.node > b.node;
        }
    };

    // Where a corner rises out of a wall, the wall's profile goes over into the corner's within a width.  The wall's
    // lanes first grow with the radius up to a full width, or a thin wall's many narrow lanes would go on.
    void blend() {
        const double reach = out_.width;
        std::vector<double> along(axis().nodes(), reach);
        std::vector<std::uint32_t> source(axis().nodes());
        std::priority_queue<Visit> queue;
        const auto go_on = [&](const Visit& v) {
            std::uint32_t h = relief_.up[v.node];
            do {
                const std::uint32_t j = axis().to(h);
                const double far = v.along + axis().length(h);
                if (!walls_.set[j] && axis().radius[j] > axis().radius[v.node] && far < along[j]) {
                    along[j] = far;
                    source[j] = v.source;
                    queue.push({far, j, v.source});
                }
                h = axis().next[h ^ 1];
            } while (h != relief_.up[v.node]);
        };
        for (std::uint32_t i = 0; i < axis().nodes(); ++i)
            if (walls_.set[i]) go_on({0, i, i});
        while (!queue.empty()) {
            const Visit v = queue.top();
            queue.pop();
            if (v.along == along[v.node]) go_on(v);
        }
        for (const std::uint32_t i : relief_.falling) {
            if (along[i] >= reach) continue;
            const Profile& from = out_.profile[source[i]];
            Profile& p = out_.profile[i];
            const double t = along[i] / reach;
            const double grown = (axis().radius[i] - out_.width * from.full) / (from.top - from.full);
            const double inner = std::max(from.inner, std::min(out_.width, grown));
            p.full = std::lerp(from.full, p.full, t);
            p.inner = std::lerp(inner, p.inner, t);
            p.top = std::lerp(from.top, p.top, t);
        }
    }

    // `reach` and `last`: from the top down, so that no lane begins again in a tip below where it has ended.
    void find_ends() {
        out_.reach.assign(walls_.wall.size(), 0.5);
        out_.tip.assign(walls_.wall.size(), 0);
        for (std::uint32_t e = 0; e < walls_.wall.size(); ++e) {
            const bool rises = axis().radius[axis().from[2 * e]] < axis().radius[axis().to(2 * e)];
            const std::uint32_t low = rises ? axis().from[2 * e] : axis().to(2 * e);
            if (!relief_.dead_end[low]) continue;
            const double radius = tip_radius(axis().slope(2 * e), least_void_);
            if (walls_.wall[e])
                out_.tip[e] = radius;
            else
                out_.reach[e] = std::clamp(radius / std::min(out_.width, out_.profile[low].inner), kLeastLane / 2, 0.5);
        }
        for (const std::uint32_t i : relief_.falling) {
            const std::uint32_t up = relief_.up[i], u = axis().to(up);
            Profile& p = out_.profile[i];
            p.last = p.top - kLeastLane;
            if (!walls_.set[i]) p.last = std::min(p.last, p.lanes - out_.reach[up / 2]);
            if (!relief_.dead_end[i] || axis().radius[u] <= axis().radius[i]) continue;
            if (axis().radius[i] < out_.tip[up / 2]) p.last = -1; // no lane
            const double above = out_.profile[u].last;
            if (!walls_.set[i] || above < 0) p.last = std::min(p.last, above);
        }
    }

    WallLanes walls_;
    Relief relief_;
    double least_void_;
    Beading out_;
};

} // namespace

Beading beading(const MedialAxis& axis, double width, double least_void) {
    return Profiles(wall_lanes(axis, width), width, least_void).run();
}

} // namespace filum::rings
