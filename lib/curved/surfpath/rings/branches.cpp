#include "surfpath/rings/branches.hpp"

#include "surface/surface.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

namespace filum::surfpath::rings {

namespace {

using surface::kNone;

class BranchPlanner {
  public:
    BranchPlanner(std::span<const Isle> isles, const BranchOptions& o)
        : isles_(isles), o_(o), shift_(isles.size(), 0), inner_(isles.size()) {
        for (std::uint32_t i = 0; i < isles.size(); ++i)
            if (isles[i].outer != kNone) inner_[isles[i].outer].push_back(i);
    }

    std::vector<Branch> run(std::vector<std::uint32_t>& of) {
        of.assign(isles_.size(), kNone);
        std::vector<Branch> out;
        for (std::uint32_t i = 0; i < isles_.size(); ++i) { // isles outside of this one are placed already
            if (of[i] != kNone) continue;
            const std::vector<std::uint32_t> chain = up(i);
            for (const std::uint32_t k : chain) of[k] = static_cast<std::uint32_t>(out.size());
            out.push_back(placed(chain));
        }
        return out;
    }

  private:
    [[nodiscard]] double level(std::uint32_t ring) const { return (ring + 0.5) * o_.spacing; }

    [[nodiscard]] std::vector<std::uint32_t> up(std::uint32_t isle) const {
        std::vector<std::uint32_t> out{isle};
        while (!inner_[out.back()].empty()) {
            const auto& in = inner_[out.back()];
            out.push_back(
                *std::max_element(in.begin(), in.end(), [&](auto a, auto b) { return isles_[a].top < isles_[b].top; }));
        }
        return out;
    }

    // mm: the highest level at which a ring is long enough, extrapolating the lengths of the last rings; none if no
    // ring is.
    [[nodiscard]] std::optional<double> long_enough(std::span<const std::uint32_t> chain) const {
        const double least = 2 * std::numbers::pi * o_.radius;
        std::size_t k = chain.size();
        while (k > 0 && isles_[chain[k - 1]].longest < least) --k;
        if (k == 0) return std::nullopt;
        const Isle& last = isles_[chain[k - 1]];
        const Isle* next = k < chain.size() ? &isles_[chain[k]] : k > 1 ? &isles_[chain[k - 2]] : nullptr;
        const double falls = next == nullptr    ? 0
                             : k < chain.size() ? last.longest - next->longest
                                                : next->longest - last.longest; // per spacing
        if (!(falls > 0)) return last.top;
        return std::min(last.top, level(last.ring) + (last.longest - least) / falls * o_.spacing);
    }

    // Changes of spacings that shift a ring by `by` mm.
    struct LevelShift {
        double by = 0, cost = 0;
        std::vector<double> change; // mm: change of the spacing outside of each ring of the chain
    };

    // The cheapest such changes; none if changes of rules::kGive are not enough.
    [[nodiscard]] std::optional<LevelShift> move(std::span<const std::uint32_t> chain, std::size_t ring,
                                                 double by) const {
        struct SpacingChange {
            double around;
            std::size_t ring;
        };
        std::vector<SpacingChange> gaps;
        for (std::size_t k = 1; k <= ring; ++k)
            if (k >= chain.size() || inner_[chain[k - 1]].size() == 1)
                gaps.push_back({isles_[chain[std::min(k, chain.size() - 1)]].around, k});
        std::sort(gaps.begin(), gaps.end(), [](const SpacingChange& a, const SpacingChange& b) {
            return a.around != b.around ? a.around < b.around : a.ring > b.ring;
        });
        LevelShift out{by, 0, std::vector<double>(ring + 1, 0)};
        double left = std::abs(by);
        for (const SpacingChange& g : gaps) {
            const double change = std::min(left, rules::kGive * o_.spacing);
            out.change[g.ring] = by < 0 ? -change : change;
            out.cost += (by < 0 ? rules::kOverlapCosts : 1) * change * g.around;
            left -= change;
        }
        return left > rules::kSamePoint * o_.spacing ? std::nullopt : std::optional(out);
    }

    // The cheapest of the shifts that bring a ring to one of the places.
    [[nodiscard]] std::optional<LevelShift> best(std::span<const std::uint32_t> chain, double shift,
                                                 std::span<const double> places) const {
        std::optional<LevelShift> out;
        const std::uint32_t first = isles_[chain[0]].ring;
        for (const double place : places) {
            const double below = std::floor((place - shift) / o_.spacing - 0.5 + rules::kSamePoint);
            for (const double ring : {below, below + 1}) {
                if (ring < first) continue;
                const double by = place - shift - (ring + 0.5) * o_.spacing;
                const auto found = move(chain, static_cast<std::size_t>(ring) - first,
                                        std::abs(by) < rules::kSamePoint * o_.spacing ? 0 : by);
                if (found && (!out || found->cost < out->cost)) out = found;
            }
        }
        return out;
    }

    Branch placed(std::span<const std::uint32_t> chain) {
        Branch out{chain.front(), chain.back(), {}};
        const Isle &first = isles_[out.first], &last = isles_[out.last];
        const bool begins = first.outer == kNone;
        double shift = begins ? 0 : shift_[first.outer];
        const double d = o_.spacing, top = last.top;
        std::vector<double> places;
        if (const auto highest = long_enough(chain)) {
            places.push_back(std::min(top - d / 2, *highest));
            if (o_.ridge && begins && *highest >= top - d) places.push_back(top - d);
        }
        const auto moved = best(chain, shift, places);
        out.closed = moved.has_value();
        if (!places.empty() && !moved) out.off = std::abs(std::remainder(places[0] - shift - d / 2, d));
        const std::size_t changes = moved ? moved->change.size() : 0;
        for (std::uint32_t k = 0; k < std::max(chain.size(), changes) || level(first.ring + k) + shift < top; ++k) {
            if (k < changes) {
                shift += moved->change[k];
                out.widest = std::max(out.widest, std::abs(moved->change[k]));
            }
            if (k < chain.size()) shift_[chain[k]] = shift;
            if (const double at = level(first.ring + k) + shift; at < top) out.levels.push_back(at);
        }
        return out;
    }

    std::span<const Isle> isles_;
    const BranchOptions& o_;
    std::vector<double> shift_; // mm: shift of each isle's ring
    std::vector<std::vector<std::uint32_t>> inner_;
};

} // namespace

std::vector<Branch> branches(std::span<const Isle> isles, const BranchOptions& options,
                             std::vector<std::uint32_t>& of) {
    return BranchPlanner(isles, options).run(of);
}

} // namespace filum::surfpath::rings
