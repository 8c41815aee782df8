#include "route/travel.hpp"

#include "kinematics/chain.hpp"
#include "route/around.hpp"

#include <algorithm>
#include <cmath>

namespace filum::route {

namespace {

constexpr double kReserve = 0.2;     // mm above the least free rise, at least
constexpr int kInside = 7;           // test places between two corners
constexpr std::size_t kCorners = 64; // most corners of a way over
constexpr int kLevels = 4;           // heights at which a way around is searched
// mm, and factor of the straight length, above which a way around is searched
constexpr double kWorthLength = 5, kWorthShare = 1.25;

Knot between(const Knot& a, const Knot& b, double t) {
    return {a.share + t * (b.share - a.share), a.aside + t * (b.aside - a.aside), a.rise + t * (b.rise - a.rise)};
}

class TravelSearch {
  public:
    TravelSearch(const Fan& fan, const TravelOptions& options)
        : fan_(fan), o_(options), reserve_(std::max(options.lift, kReserve)) {}

    Travel run() {
        if (o_.under == 0 && fan_.chord() < o_.min_length && !fan_.blocked({0, 0, 0}, {1, 0, 0}))
            return {.stances = {}, .kind = Kind::straight, .length = fan_.chord(), .free = true};
        const Way straight{end(0), end(1)};
        Way best{straight[0]};
        bool free = connect(straight[0], straight[1], best);
        if (free) shorten(best);
        const bool plain = best.size() == 2 && best[0].rise <= o_.lift && best[1].rise <= o_.lift;
        Kind kind = plain ? Kind::straight : Kind::over;
        const double low = fan_.chord() + 2 * o_.lift, over = whole(best);
        if (!plain && (!free || (over > low + kWorthLength && over > low * kWorthShare)))
            if (Way other = past(best, free); !other.empty()) {
                best = std::move(other);
                kind = Kind::around;
                free = true;
            }
        return finish(best, kind, free);
    }

  private:
    // The lowest knot above an end.
    [[nodiscard]] Knot end(double share) const {
        const double rise = fan_.least_rise({share, 0, o_.lift});
        return {share, 0, rise > o_.lift ? rise + reserve_ : rise};
    }

    // Length including the vertical parts at both ends.
    [[nodiscard]] double whole(const Way& way) const { return way.front().rise + length(fan_, way) + way.back().rise; }

    // Appends the way from a, at which `out` ends, to b; returns false if not all of it is free.
    bool connect(const Knot& a, const Knot& b, Way& out) {
        const auto blocked = fan_.blocked(a, b);
        if (!blocked || corners_ >= kCorners) {
            out.push_back(b);
            return !blocked;
        }
        ++corners_;
        const Knot corner = highest(a, b, *blocked);
        const bool first = connect(a, corner, out);
        return connect(corner, b, out) && first;
    }

    // The knot above the place between a and b where the least rise exceeds the line between them most; above the
    // place where the line is blocked if none does.
    [[nodiscard]] Knot highest(const Knot& a, const Knot& b, double blocked) const {
        Knot best = between(a, b, blocked);
        double excess = 0;
        for (int i = 1; i <= kInside; ++i) {
            Knot knot = between(a, b, static_cast<double>(i) / (kInside + 1));
            const double rise = fan_.least_rise(knot);
            if (rise - knot.rise <= excess) continue;
            excess = rise - knot.rise;
            knot.rise = rise;
            best = knot;
        }
        if (excess == 0) best.rise = fan_.least_rise(best);
        best.rise += reserve_;
        return best;
    }

    // Removes corners in order, repeatedly, while the way remains free.
    void shorten(Way& way) const {
        for (std::size_t i = 1; i + 1 < way.size();) {
            if (fan_.blocked(way[i - 1], way[i + 1])) {
                ++i;
                continue;
            }
            way.erase(way.begin() + static_cast<std::ptrdiff_t>(i));
            if (i > 1) --i;
        }
    }

    // The shortest way around that is shorter than `over`, or any if `over` is not free.
    [[nodiscard]] Way past(const Way& over, bool free) const {
        double top = 0;
        for (const Knot& k : over) top = std::max(top, k.rise);
        const double low = std::max(over.front().rise, over.back().rise);
        double most = free ? whole(over) : 4 * (fan_.chord() + top);
        Way best;
        for (int i = 0; i < kLevels; ++i) {
            const double rise = low + (top - low) * i / kLevels;
            Way way = around(fan_, rise, most - 2 * rise);
            if (way.empty() || whole(way) >= most) continue;
            most = whole(way);
            best = std::move(way);
        }
        return best;
    }

    [[nodiscard]] Travel finish(const Way& way, Kind kind, bool free) const {
        const bool ends = fan_.free({0, 0, 0}) && fan_.free({1, 0, 0});
        Travel out{.stances = {}, .kind = kind, .length = whole(way) + 2 * o_.under, .free = free && ends};
        for (std::size_t i = 0; i < way.size(); ++i) {
            const ToolFrame to = fan_.at({way[i].share, way[i].aside, way[i].rise + o_.under});
            const std::size_t parts = i == 0 ? 1 : turns(out.stances.back(), to);
            const collision::Move leg{i == 0 ? to : out.stances.back(), to};
            for (std::size_t k = 1; k < parts; ++k)
                out.stances.push_back(collision::at(leg, static_cast<double>(k) / static_cast<double>(parts)));
            out.stances.push_back(to);
        }
        return out;
    }

    [[nodiscard]] std::size_t turns(const ToolFrame& a, const ToolFrame& b) const {
        return static_cast<std::size_t>(std::max(1.0, std::ceil(geom::angle(a.axis, b.axis) / o_.most_turn)));
    }

    const Fan& fan_;
    const TravelOptions& o_;
    double reserve_; // mm
    std::size_t corners_ = 0;
};

} // namespace

Travel travel(const collision::Room& room, const ToolFrame& from, const ToolFrame& to, std::uint32_t before,
              const TravelOptions& options) {
    const bool same = from.tip == to.tip && geom::angle(from.axis, to.axis) < 1e-6;
    const Fan fan(room, from, to, before);
    Travel out = same ? Travel{.stances = {}, .kind = Kind::straight, .length = 0, .free = true}
                      : TravelSearch(fan, options).run();
    out.stances.insert(out.stances.begin(), from);
    out.stances.push_back(to);
    return out;
}

} // namespace filum::route
