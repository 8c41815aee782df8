#include "route/around.hpp"

#include "base/none.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

namespace filum::route {

namespace {

constexpr double kPlaces = 3000, kLeast = 0.5; // most places of the grid; mm between two places, at least
enum class Occupancy : std::uint8_t { unknown, free, blocked };

// The search grid: columns from start to goal, rows to the sides.
class Grid {
  public:
    Grid(const Fan& fan, double rise, double most) : fan_(fan), rise_(rise), most_(most), chord_(fan.chord()) {
        const double wide = std::sqrt(most * most - chord_ * chord_), area = std::numbers::pi / 4 * most * wide;
        columns_between_ = std::max(1, static_cast<int>(chord_ / std::max(kLeast, std::sqrt(area / kPlaces))));
        cell_ = chord_ / columns_between_;
        beyond_ = static_cast<int>((most - chord_) / 2 / cell_);
        aside_ = static_cast<int>(wide / 2 / cell_);
        columns_ = columns_between_ + 1 + 2 * beyond_;
        const auto n = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(2 * aside_ + 1);
        state_.assign(n, Occupancy::unknown);
        cost_.assign(n, std::numeric_limits<double>::infinity());
        from_.assign(n, kNone);
        done_.assign(n, false);
    }

    // The knots from start to goal; empty if there is no way.
    Way search() {
        const std::uint32_t start = index(0, 0), goal = index(columns_between_, 0);
        if (!free(start) || !free(goal)) return {};
        cost_[start] = 0;
        open_.push({chord_, start});
        while (!open_.empty()) {
            const std::uint32_t at = open_.top().index;
            open_.pop();
            if (done_[at]) continue;
            done_[at] = true;
            if (at == goal) return trace(goal);
            spread(at);
        }
        return {};
    }

  private:
    struct OpenNode {
        double sum; // mm: length from the start plus the straight distance to the goal
        std::uint32_t index;
        bool operator<(const OpenNode& o) const { return sum != o.sum ? sum > o.sum : index > o.index; }
    };

    [[nodiscard]] std::uint32_t index(int column, int row) const {
        return static_cast<std::uint32_t>((column + beyond_) * (2 * aside_ + 1) + row + aside_);
    }
    [[nodiscard]] int column(std::uint32_t i) const { return static_cast<int>(i) / (2 * aside_ + 1) - beyond_; }
    [[nodiscard]] int row(std::uint32_t i) const { return static_cast<int>(i) % (2 * aside_ + 1) - aside_; }
    [[nodiscard]] Knot knot(std::uint32_t i) const {
        return {static_cast<double>(column(i)) / columns_between_, row(i) * cell_, rise_};
    }

    bool free(std::uint32_t i) {
        if (state_[i] == Occupancy::unknown) state_[i] = fan_.free(knot(i)) ? Occupancy::free : Occupancy::blocked;
        return state_[i] == Occupancy::free;
    }

    void spread(std::uint32_t at) {
        for (int dc = -1; dc <= 1; ++dc)
            for (int dr = -1; dr <= 1; ++dr) {
                const int c = column(at) + dc, r = row(at) + dr;
                if (c < -beyond_ || c >= columns_ - beyond_ || std::abs(r) > aside_) continue;
                const std::uint32_t to = index(c, r);
                const double cost = cost_[at] + cell_ * std::hypot(dc, dr);
                const double sum = cost + cell_ * std::hypot(columns_between_ - c, r);
                if (done_[to] || cost >= cost_[to] || sum > most_ || !free(to)) continue;
                cost_[to] = cost;
                from_[to] = at;
                open_.push({sum, to});
            }
    }

    [[nodiscard]] Way trace(std::uint32_t goal) const {
        Way out;
        for (std::uint32_t i = goal; i != kNone; i = from_[i]) out.push_back(knot(i));
        std::reverse(out.begin(), out.end());
        return out;
    }

    const Fan& fan_;
    double rise_, most_, chord_, cell_ = 0;
    int columns_between_ = 1, columns_ = 1, beyond_ = 0, aside_ = 0;
    std::vector<Occupancy> state_;
    std::vector<double> cost_;
    std::vector<std::uint32_t> from_;
    std::vector<bool> done_;
    std::priority_queue<OpenNode> open_;
};

// Skips knots: goes straight from each knot to one as far on as is visible; empty if not even the next one is.
Way straightened(const Fan& fan, const Way& way) {
    Way out{way.front()};
    for (std::size_t at = 0; at + 1 < way.size();) {
        std::size_t to = way.size() - 1;
        while (fan.blocked(way[at], way[to])) {
            if (to == at + 1) return {};
            to = at + (to - at) / 2;
        }
        out.push_back(way[to]);
        at = to;
    }
    return out;
}

} // namespace

Way around(const Fan& fan, double rise, double most) {
    if (!(fan.chord() > 0) || !(most > fan.chord())) return {};
    const Way way = Grid(fan, rise, most).search();
    return way.empty() ? way : straightened(fan, way);
}

} // namespace filum::route
