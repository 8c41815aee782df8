#include "fill/thin_edges.hpp"

#include "rings/beading.hpp"

#include <algorithm>
#include <queue>

namespace filum::fill {

namespace {

constexpr double kFine = 1.0 / 64; // bead widths: what the axis may be off

constexpr double kTipReach = 0.4;  // bead widths: shorter tips are not followed
constexpr double kThinWall = 0.55; // bead widths: walls of a smaller half-thickness are thin; above a half, so that the
                                   // parts where thin and fat walls meet belong to both
constexpr double kFat = 0.95;      // bead widths: from here on a bead follows the outline
constexpr double kHairline = 0.015; // bead widths: tips of a smaller half-thickness have no room for two lanes

// The edges of the medial axis that a thin wall's bead follows: radius below width/2 at one end at least, dead ends
// shortened until what they reach beyond the disc at their foot is worth following.
class ThinAxis {
  public:
    ThinAxis(const polygon::MedialAxis& axis, double width) : axis_(axis), width_(width) {
        const std::size_t n = axis.nodes();
        degree_.assign(n, 0);
        reach_.resize(n);
        at_.resize(n);
        for (std::uint32_t k = 0; k < axis.half_edges() / 2; ++k) {
            if (std::min(axis.radius[axis.from[2 * k]], axis.radius[axis.to(2 * k)]) >= kThinWall * width) continue;
            alive_.push_back(k);
            for (const auto v : {axis.from[2 * k], axis.to(2 * k)}) {
                ++degree_[v];
                at_[v].push_back(k);
            }
        }
        kept_.assign(axis.half_edges() / 2, 0);
        for (const auto k : alive_) kept_[k] = 1;
        for (std::size_t v = 0; v < n; ++v) reach_[v] = axis.radius[v];
        // 1e-9: where the axis was split the radius is off by rounding; what is a hairline all over is kept
        hairline_ = kHairline * width * (1 + 1e-9);
        if (*std::max_element(axis.radius.begin(), axis.radius.end()) <= hairline_) hairline_ = 0;
    }

    // Indices of the edges kept, ascending.
    std::vector<std::uint32_t> edges() {
        prune();
        ease_in();
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
            if (beyond - axis_.radius[u] > kTipReach * width_ && axis_.radius[u] > hairline_) continue;
            kept_[k] = 0;
            --degree_[u];
            --degree_[v];
            reach_[u] = std::max(reach_[u], beyond);
            if (leaf(u)) leaves.emplace(reach_[u], u);
        }
    }
    // From where thin walls end on into the fat part, as long as the wall gets thicker: there half the thickness and
    // half a bead's depth come to the same, and the ring has no notch.
    void ease_in() {
        std::vector<std::vector<std::uint32_t>> rising(axis_.nodes()); // per vertex: edges to thicker places
        for (std::uint32_t k = 0; k < axis_.half_edges() / 2; ++k) {
            const auto a = axis_.from[2 * k], b = axis_.to(2 * k);
            const double low = std::min(axis_.radius[a], axis_.radius[b]),
                         high = std::max(axis_.radius[a], axis_.radius[b]);
            if (low >= kThinWall * width_ && high <= kFat * width_)
                rising[axis_.radius[a] <= axis_.radius[b] ? a : b].push_back(k);
        }
        std::vector<std::uint32_t> pending;
        for (const auto k : alive_)
            if (kept_[k]) {
                pending.push_back(axis_.from[2 * k]);
                pending.push_back(axis_.to(2 * k));
            }
        while (!pending.empty()) {
            const std::uint32_t v = pending.back();
            pending.pop_back();
            for (const auto k : rising[v]) {
                if (kept_[k]) continue;
                kept_[k] = 1;
                pending.push_back(axis_.from[2 * k] == v ? axis_.to(2 * k) : axis_.from[2 * k]);
            }
        }
    }
    // A dead end that does not lie in a fat part.
    [[nodiscard]] bool leaf(std::uint32_t v) const { return degree_[v] == 1 && axis_.radius[v] < kThinWall * width_; }

    const polygon::MedialAxis& axis_;
    double width_;
    double hairline_ = 0; // mm
    std::vector<std::uint32_t> alive_;
    std::vector<int> degree_;
    std::vector<double> reach_; // per vertex: how far its discs and the twigs cut off there reach
    std::vector<std::vector<std::uint32_t>> at_;
    std::vector<char> kept_;
};

} // namespace

polygon::MedialAxis axis_for(const polygon::Loops& area, double width) {
    return polygon::medial_axis(polygon::sites_of(area, kFine * width), kFine * width, rings::kWallSlope);
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

std::vector<std::uint32_t> thin_edges(const polygon::MedialAxis& axis, double width) {
    return ThinAxis(axis, width).edges();
}

} // namespace filum::fill
