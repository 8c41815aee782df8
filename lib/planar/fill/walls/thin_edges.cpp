#include "fill/walls/thin_edges.hpp"

#include "fill/join/attempt.hpp"
#include "fill/rings/wall_lanes.hpp"

#include <algorithm>
#include <queue>

namespace filum::fill::walls {

namespace {

// The edges of the medial axis that the bead of a thin wall follows: those with a radius below `most` at one end at
// least. Dead ends are removed if they reach at most half a bead, its round end, beyond the disc at their foot.
class ThinAxis {
  public:
    ThinAxis(const polygon::MedialAxis& axis, double width, double most)
        : axis_(axis), width_(width), most_(most * (1 - 1e-9)) { // 1e-9: rounding, where the axis was split
        const std::size_t n = axis.nodes();
        degree_.assign(n, 0);
        kept_.assign(axis.half_edges() / 2, 0);
        reach_.resize(n);
        at_.resize(n);
        for (std::uint32_t k = 0; k < axis.half_edges() / 2; ++k) {
            if (std::min(axis.radius[axis.from[2 * k]], axis.radius[axis.to(2 * k)]) >= most_) continue;
            kept_[k] = 1;
            for (const auto v : {axis.from[2 * k], axis.to(2 * k)}) {
                ++degree_[v];
                at_[v].push_back(k);
            }
        }
        for (std::size_t v = 0; v < n; ++v) reach_[v] = axis.radius[v];
    }

    // Indices of the edges kept, ascending.
    std::vector<std::uint32_t> edges() {
        prune();
        std::vector<std::uint32_t> out;
        for (std::uint32_t k = 0; k < kept_.size(); ++k)
            if (kept_[k]) out.push_back(k);
        return out;
    }

  private:
    void prune() {
        // leaves with the least reach first, so that the longer of two twigs survives; ties by vertex
        using Entry = std::pair<double, std::uint32_t>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> leaves;
        for (std::uint32_t v = 0; v < degree_.size(); ++v)
            if (leaf(v)) leaves.emplace(reach_[v], v);
        while (!leaves.empty()) {
            const std::uint32_t v = leaves.top().second;
            leaves.pop();
            if (!leaf(v)) continue;
            const std::uint32_t k = *std::find_if(at_[v].begin(), at_[v].end(), [&](auto e) { return kept_[e] != 0; });
            const std::uint32_t u = axis_.from[2 * k] == v ? axis_.to(2 * k) : axis_.from[2 * k];
            const double beyond = reach_[v] + geom::distance(axis_.node[u], axis_.node[v]);
            if (beyond - axis_.radius[u] > width_ / 2) continue;
            kept_[k] = 0;
            --degree_[u];
            --degree_[v];
            reach_[u] = std::max(reach_[u], beyond);
            if (leaf(u)) leaves.emplace(reach_[u], u);
        }
    }
    // True for a dead end that lies outside thick parts.
    [[nodiscard]] bool leaf(std::uint32_t v) const { return degree_[v] == 1 && axis_.radius[v] < most_; }

    const polygon::MedialAxis& axis_;
    double width_, most_; // mm
    std::vector<int> degree_;
    std::vector<double> reach_; // per vertex: reach of its disc and of the twigs removed there
    std::vector<std::vector<std::uint32_t>> at_;
    std::vector<char> kept_;
};

} // namespace

polygon::MedialAxis axis_for(const polygon::Loops& area, double width) {
    const double fine = join::tolerance_for(width) / 2;
    return polygon::medial_axis(area, fine, fine, rings::kWallSlope);
}

polygon::MedialAxis split_at(const polygon::MedialAxis& axis, double radius) {
    std::vector<double> cuts;
    std::vector<std::uint32_t> start{0};
    for (std::uint32_t k = 0; k < axis.half_edges() / 2; ++k) {
        const double a = axis.radius[axis.from[2 * k]], b = axis.radius[axis.to(2 * k)];
        if ((a < radius && b > radius) || (a > radius && b < radius)) cuts.push_back((radius - a) / (b - a));
        start.push_back(static_cast<std::uint32_t>(cuts.size()));
    }
    return polygon::refined(axis, cuts, start);
}

std::vector<std::uint32_t> thin_edges(const polygon::MedialAxis& axis, double width, double most) {
    return ThinAxis(axis, width, most).edges();
}

} // namespace filum::fill::walls
