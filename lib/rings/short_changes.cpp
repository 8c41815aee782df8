#include "rings/short_changes.hpp"

#include "geom/disjoint_sets.hpp"
#include "rings/wall_lanes.hpp"

#include <algorithm>
#include <cmath>

namespace filum::rings {

namespace {

// Walls with at least so many lanes (sign 1; with at most so many: -1), level by level, in connected stretches.
class Levels {
  public:
    Levels(const MedialAxis& axis, const std::vector<char>& wall, std::vector<int>& lanes, double width, int sign)
        : axis_(&axis), wall_(&wall), lanes_(&lanes), width_(width), sign_(sign), stretch_(lanes.size()),
          length_(lanes.size()), radius_(lanes.size()), in_(lanes.size(), 0), members_(lanes.size()) {}

    void run() {
        std::vector<std::uint32_t> order;
        for (std::uint32_t e = 0; e < wall_->size(); ++e)
            if ((*wall_)[e]) order.push_back(e);
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return sign_ * (*lanes_)[a] > sign_ * (*lanes_)[b]; });
        std::vector<std::uint32_t> lowered; // the pieces of stretches that have come down to the level below
        for (std::size_t i = 0; i < order.size() || !lowered.empty();) {
            int level = lowered.empty() ? (*lanes_)[order[i]] : (*lanes_)[lowered[0]];
            if (i < order.size() && sign_ * (*lanes_)[order[i]] > sign_ * level) level = (*lanes_)[order[i]];
            std::vector<std::uint32_t> here;
            for (const std::uint32_t e : lowered)
                if ((*lanes_)[e] == level) here.push_back(e);
            for (; i < order.size() && (*lanes_)[order[i]] == level; ++i) {
                here.push_back(order[i]);
                enter(order[i]);
            }
            std::erase_if(lowered, [&](std::uint32_t e) { return (*lanes_)[e] == level; });
            for (const std::uint32_t e : here) join_neighbours(e);
            for (const std::uint32_t e : here) lower(stretch_.root(e), level, lowered);
        }
    }

  private:
    [[nodiscard]] double ramp() const { return kRamp * width_; }
    void enter(std::uint32_t e) {
        in_[e] = 1, length_[e] = axis_->length(2 * e), members_[e] = {e};
        const double a = axis_->radius[axis_->from[2 * e]], b = axis_->radius[axis_->to(2 * e)];
        radius_[e] = sign_ > 0 ? std::max(a, b) : std::min(a, b);
    }
    template <class F>
    void each_neighbour(std::uint32_t e, F&& f) const {
        for (const std::uint32_t h : {2 * e, 2 * e + 1})
            for (std::uint32_t g = axis_->next[h ^ 1]; g != h; g = axis_->next[g ^ 1])
                if ((*wall_)[g / 2]) f(g / 2);
    }
    void join_neighbours(std::uint32_t e) {
        each_neighbour(e, [&](std::uint32_t other) {
            if (!in_[other]) return;
            const std::uint32_t one = stretch_.root(e), two = stretch_.root(other);
            if (!stretch_.unite(one, two)) return;
            const std::uint32_t a = std::min(one, two), b = std::max(one, two); // a stands for both
            length_[a] += length_[b];
            radius_[a] = sign_ > 0 ? std::max(radius_[a], radius_[b]) : std::min(radius_[a], radius_[b]);
            if (members_[a].size() < members_[b].size()) std::swap(members_[a], members_[b]);
            if (length_[a] < ramp()) members_[a].insert(members_[a].end(), members_[b].begin(), members_[b].end());
            members_[b].clear();
        });
    }
    // Takes a lane from (gives one to) a stretch if it is short, goes on in a wall with fewer (more), and may be.
    void lower(std::uint32_t r, int level, std::vector<std::uint32_t>& lowered) {
        const auto& members = members_[r];
        const int to = level - sign_;
        if (length_[r] >= ramp() || to < 1) return;
        if (std::any_of(members.begin(), members.end(), [&](std::uint32_t e) { return (*lanes_)[e] != level; })) return;
        const double share = radius_[r] / width_ - (to - 1); // the inmost lane's
        if (share > kWidest || share < 1 / kWidest) return;
        bool ends = false;
        for (const std::uint32_t e : members)
            each_neighbour(e, [&](std::uint32_t other) { ends = ends || !in_[other]; });
        if (!ends) return;
        for (const std::uint32_t e : members) (*lanes_)[e] = to;
        lowered.insert(lowered.end(), members.begin(), members.end());
    }

    const MedialAxis* axis_;
    const std::vector<char>* wall_;
    std::vector<int>* lanes_;
    double width_; // mm
    int sign_;
    geom::DisjointSets stretch_;
    std::vector<double> length_, radius_; // per root
    std::vector<char> in_;
    std::vector<std::vector<std::uint32_t>> members_; // per root, while it is short
};

} // namespace

std::vector<int> without_short_changes(const MedialAxis& axis, const std::vector<char>& wall, std::vector<int> lanes,
                                       double width) {
    for (const int sign : {1, -1}) Levels(axis, wall, lanes, width, sign).run();
    return lanes;
}

} // namespace filum::rings
