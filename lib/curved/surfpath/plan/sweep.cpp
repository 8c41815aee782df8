#include "surfpath/plan/order.hpp"

#include "surface/surface.hpp"

#include <algorithm>

namespace filum::surfpath::plan {

namespace {

using surface::kNone;

class Sweep {
  public:
    Sweep(std::uint32_t rows, std::span<const Link> links) : next_(rows), missing_(rows), taken_(rows, 0) {
        for (const Link& l : links) {
            next_[l.from / 2].push_back(l.to / 2);
            next_[l.to / 2].push_back(l.from / 2);
        }
        for (std::uint32_t r = 0; r < rows; ++r) {
            std::sort(next_[r].begin(), next_[r].end());
            next_[r].erase(std::unique(next_[r].begin(), next_[r].end()), next_[r].end());
            missing_[r] = next_[r].size();
        }
    }

    std::vector<std::uint32_t> run() {
        std::vector<std::uint32_t> out;
        while (out.size() < next_.size()) {
            std::uint32_t best = kNone;
            long least = 0;
            for (std::uint32_t r = 0; r < next_.size(); ++r) {
                if (taken_[r] != 0 || !linked(r)) continue;
                if (const long g = growth(r); best == kNone || g < least) {
                    best = r;
                    least = g;
                }
            }
            if (best == kNone) best = loosest();
            taken_[best] = 1;
            for (const std::uint32_t n : next_[best]) --missing_[n];
            out.push_back(best);
        }
        return out;
    }

  private:
    [[nodiscard]] bool linked(std::uint32_t r) const { return missing_[r] < next_[r].size(); }

    // By how much the frontier grows if row `r` is taken.
    [[nodiscard]] long growth(std::uint32_t r) const {
        long out = missing_[r] > 0 ? 1 : 0;
        for (const std::uint32_t n : next_[r])
            if (taken_[n] != 0 && missing_[n] == 1) --out;
        return out;
    }

    [[nodiscard]] std::uint32_t loosest() const {
        std::uint32_t best = kNone;
        for (std::uint32_t r = 0; r < next_.size(); ++r)
            if (taken_[r] == 0 && (best == kNone || next_[r].size() < next_[best].size())) best = r;
        return best;
    }

    std::vector<std::vector<std::uint32_t>> next_; // per row the rows that it is linked to
    std::vector<std::size_t> missing_;             // per row: how many of these are not taken
    std::vector<char> taken_;
};

} // namespace

std::vector<std::uint32_t> sweep(std::uint32_t rows, std::span<const Link> links) { return Sweep(rows, links).run(); }

} // namespace filum::surfpath::plan
