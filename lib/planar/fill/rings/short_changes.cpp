#include "fill/rings/short_changes.hpp"

#include "fill/rings/wall_lanes.hpp"

#include <algorithm>

namespace filum::fill::rings {

namespace {

// Connected stretches of walls with at least (sign 1) or at most (sign -1) a number of lanes, level by level.
class ChangeRemover {
  public:
    ChangeRemover(const MedialAxis& axis, const std::vector<char>& wall, std::vector<int>& lanes, double width,
                  int sign)
        : axis_(&axis), wall_(&wall), lanes_(&lanes), width_(width), sign_(sign), seen_(lanes.size(), 0) {}

    void run() {
        std::vector<std::uint32_t> order, here;
        for (std::uint32_t e = 0; e < wall_->size(); ++e)
            if ((*wall_)[e]) order.push_back(e);
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return sign_ * (*lanes_)[a] > sign_ * (*lanes_)[b]; });
        for (std::size_t i = 0; i < order.size() || !here.empty();) {
            const int level = here.empty() ? (*lanes_)[order[i]] : (*lanes_)[here[0]];
            for (; i < order.size() && (*lanes_)[order[i]] == level; ++i) here.push_back(order[i]);
            std::vector<std::uint32_t> lowered; // these continue with the level below
            for (const std::uint32_t first : here)
                if ((*lanes_)[first] == level)
                    for (const std::uint32_t e : short_stretch(first, level)) {
                        (*lanes_)[e] = level - sign_;
                        lowered.push_back(e);
                    }
            here = std::move(lowered);
        }
    }

  private:
    // The stretch that ends with piece `first` if it is to get one lane less (more): it is short, continues there in a
    // wall with fewer (more) lanes, and its lanes would not become too wide or narrow.
    std::vector<std::uint32_t> short_stretch(std::uint32_t first, int level) {
        std::vector<std::uint32_t> out{first};
        double length = 0, thickest = 0, thinnest = axis_->radius[axis_->from[2 * first]];
        bool ends = false;
        seen_[first] = ++round_;
        for (std::size_t k = 0; k < out.size(); ++k) {
            const std::uint32_t e = out[k];
            length += axis_->length(2 * e);
            if (length >= kRamp * width_ || (*lanes_)[e] != level) return {};
            for (const std::uint32_t h : {2 * e, 2 * e + 1}) {
                thickest = std::max(thickest, axis_->radius[axis_->from[h]]);
                thinnest = std::min(thinnest, axis_->radius[axis_->from[h]]);
                for (std::uint32_t g = axis_->next[h ^ 1]; g != h; g = axis_->next[g ^ 1]) {
                    const std::uint32_t other = g / 2;
                    if (!(*wall_)[other] || seen_[other] == round_) continue;
                    if (sign_ * (*lanes_)[other] < sign_ * level) {
                        ends = true;
                        continue;
                    }
                    seen_[other] = round_;
                    out.push_back(other);
                }
            }
            if (!ends) return {}; // it will be found from its end
        }
        const int to = level - sign_;
        const double inmost = (sign_ > 0 ? thickest : thinnest) / width_ - (to - 1); // widths, of the innermost lane
        if (to < 1 || inmost > kWidest || inmost < 1 / kWidest) return {};
        return out;
    }

    const MedialAxis* axis_;
    const std::vector<char>* wall_;
    std::vector<int>* lanes_;
    double width_; // mm
    int sign_;
    std::vector<std::uint32_t> seen_; // per piece: the last search that has met it
    std::uint32_t round_ = 0;
};

} // namespace

std::vector<int> without_short_changes(const MedialAxis& axis, const std::vector<char>& wall, std::vector<int> lanes,
                                       double width) {
    for (const int sign : {1, -1}) ChangeRemover(axis, wall, lanes, width, sign).run();
    return lanes;
}

} // namespace filum::fill::rings
