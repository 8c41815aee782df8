#include "rings/join.hpp"

#include "rings/stack.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace filum::rings {

namespace {

constexpr double kShift = 2.5;  // widths of ring in which a lane moves by two
constexpr double kMargin = 0.5; // widths of ring between windows

class Joiner {
  public:
    Joiner(const Beading& beading, const Rings& rings, double least_void)
        : b_(&beading), rings_(&rings), lengths_(lengths(rings)), ground_(stack_ground(beading, rings, lengths_)),
          least_void_(least_void), up_(rings.size()), used_(rings.size()), groups_(rings.size()) {
        std::iota(up_.begin(), up_.end(), 0U);
    }

    std::vector<BeadLine> run() {
        // inmost rings first: each takes those around it along
        for (std::uint32_t r = count(); r-- > 0;)
            if (used_[r].empty()) join(r, 1);
        for (const double share : {1.0, 0.5, 0.25})
            for (std::uint32_t r = count(); r-- > 0;)
                while (groups_ > 1 && join(r, share)) {}
        return spliced(*rings_, lengths_, splices_);
    }

  private:
    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(rings_->size()); }
    std::uint32_t root(std::uint32_t i) {
        while (up_[i] != i) i = up_[i] = up_[up_[i]];
        return i;
    }
    void unite(std::uint32_t a, std::uint32_t b) {
        a = root(a), b = root(b);
        if (a != b) up_[std::max(a, b)] = std::min(a, b), --groups_;
    }

    // Lanes next to the ring, those that are not joined with each other yet.
    StackAt apart(StackAt all) {
        if (all.lanes.empty()) return all;
        std::vector<std::uint32_t> roots{root(all.lanes[all.own].ring)};
        const auto fresh = [&](std::size_t l) {
            const std::uint32_t r = root(all.lanes[l].ring);
            if (std::find(roots.begin(), roots.end(), r) != roots.end()) return false;
            roots.push_back(r);
            return true;
        };
        std::size_t lo = all.own, hi = all.own + 1;
        while (lo > 0 && fresh(lo - 1)) --lo;
        while (hi < all.lanes.size() && fresh(hi)) ++hi;
        return {{all.lanes.begin() + static_cast<std::ptrdiff_t>(lo), all.lanes.begin() + static_cast<std::ptrdiff_t>(hi)},
                all.own - lo};
    }

    [[nodiscard]] bool free(std::uint32_t ring, double s0, double s1) const {
        const double l = lengths_.length[ring], margin = std::min(kMargin * b_->width, 0.1 * l);
        for (const Window& u : used_[ring])
            for (const double shift : {-l, 0.0, l})
                if (s0 - margin + shift < u.s1 && u.s0 < s1 + margin + shift) return false;
        return true;
    }

    bool join(std::uint32_t r, double share) {
        const double whole = lengths_.length[r], length = share * std::min(kShift * b_->width, whole / 4);
        const int n = static_cast<int>(std::clamp(whole / (0.25 * b_->width), 24.0, 64.0));
        const StackOptions o{share * kShift * b_->width, least_void_,
                             [this](std::uint32_t ring, double s0, double s1) { return free(ring, s0, s1); }};
        std::optional<StackSplice> best;
        for (int k = 0; k < n; ++k) {
            const double s = whole * (k + 0.5) / n;
            const auto ray = ray_at(ground_, r, s);
            if (!ray) return false;
            const StackAt at = apart(lanes_at(ground_, r, *ray));
            if (at.lanes.size() < std::max<std::size_t>(2, best ? best->splice.windows.size() : 0)) continue;
            auto made = stack_splice(ground_, at, *ray_at(ground_, r, s - length / 2), *ray_at(ground_, r, s + length / 2), o);
            if (!made) continue;
            const auto size = [](const StackSplice& x) { return x.splice.windows.size(); };
            if (!best || size(*made) > size(*best) || (size(*made) == size(*best) && made->turning < best->turning))
                best = std::move(made);
        }
        if (!best) return false;
        for (const Window& w : best->splice.windows) unite(r, w.ring), used_[w.ring].push_back(w);
        splices_.push_back(std::move(best->splice));
        return true;
    }

    const Beading* b_;
    const Rings* rings_;
    RingLengths lengths_;
    StackGround ground_;
    double least_void_;
    std::vector<std::uint32_t> up_;
    std::vector<std::vector<Window>> used_; // per ring
    std::size_t groups_;
    std::vector<Splice> splices_;
};

} // namespace

std::vector<BeadLine> joined(const Beading& beading, const Rings& rings, double least_void) {
    return Joiner(beading, rings, least_void).run();
}

} // namespace filum::rings
