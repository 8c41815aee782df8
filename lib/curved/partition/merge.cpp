#include "partition/merge.hpp"

#include "geom/angle.hpp"

#include <algorithm>
#include <map>
#include <queue>
#include <set>

namespace filum::partition {

namespace {

using geom::kDegree;
constexpr double kBeyond = 0.05; // share of a patch that may exceed a limit
constexpr double kAcross = 3;    // additional weight of a border across full load
constexpr double kEven = 1e-4;   // share of the spread added so that patches grow evenly where there is none

// Two patches that could be merged, as of some age.
struct MergeCandidate {
    double cost = 0; // increase of the spread per mm of border
    std::uint32_t a = 0, b = 0;
    std::uint32_t a_age = 0, b_age = 0;
    bool operator>(const MergeCandidate& o) const {
        if (cost != o.cost) return cost > o.cost;
        return a != o.a ? a > o.a : b > o.b;
    }
};

class Merger {
  public:
    Merger(const Cells& cells, const Pull& pull, const Limits& limits)
        : cells_(cells), pull_(pull), limits_(limits), patch_(cells.area.size()) {
        for (std::uint32_t v = 0; v < patch_.size(); ++v) patch_[v] = {proxy(cells, pull, v), {v}, {}, 0};
        for (const CellBorder& side : cells.sides) {
            const double border = side.border * border_factor(pull, side);
            patch_[side.a].border[side.b] = patch_[side.b].border[side.a] = border;
        }
        left_ = static_cast<std::int64_t>(patch_.size());
    }

    void run() {
        const bool counted = limits_.patches > 0;
        for (std::uint32_t a = 0; a < patch_.size(); ++a) push_all(a, true);
        while (!queue_.empty() && left_ > limits_.patches) {
            const MergeCandidate p = queue_.top();
            queue_.pop();
            if (stale(p) || (!counted && !allowed(p.a, p.b))) continue;
            push_all(unite(p.a, p.b), false);
        }
    }

    // Merges patches below the least area, the smallest first, with the neighbour for which that costs least.
    void absorb_small() {
        std::set<std::pair<double, std::uint32_t>> small;
        const auto enlist = [&](std::uint32_t v) {
            const Patch& p = patch_[v];
            if (!p.cells.empty() && p.proxy.area < limits_.least_area) small.emplace(p.proxy.area, v);
        };
        for (std::uint32_t v = 0; v < patch_.size(); ++v) enlist(v);
        while (!small.empty()) {
            const std::uint32_t v = small.begin()->second;
            small.erase(small.begin());
            std::uint32_t best = kNone;
            for (const auto& [other, border] : patch_[v].border) {
                const Proxy &p = patch_[v].proxy, &q = patch_[other].proxy;
                if (!may_take(q.facing, q.area, p.facing, p.area)) continue;
                if (best == kNone || cost(v, other) < cost(v, best)) best = other;
            }
            if (best == kNone) continue;
            small.erase({patch_[best].proxy.area, best});
            enlist(unite(std::min(v, best), std::max(v, best)));
        }
    }

    [[nodiscard]] std::vector<std::uint32_t> labels() const {
        std::vector<std::uint32_t> out(patch_.size());
        for (const Patch& p : patch_)
            for (const std::uint32_t v : p.cells) out[v] = *std::min_element(p.cells.begin(), p.cells.end());
        return out;
    }

  private:
    struct Patch {
        Proxy proxy;
        std::vector<std::uint32_t> cells;
        std::map<std::uint32_t, double> border; // mm, to neighbours
        std::uint32_t age = 0;                  // incremented by every change
    };

    [[nodiscard]] bool stale(const MergeCandidate& p) const {
        return patch_[p.a].cells.empty() || patch_[p.b].cells.empty() || patch_[p.a].age != p.a_age ||
               patch_[p.b].age != p.b_age;
    }

    [[nodiscard]] double cost(std::uint32_t a, std::uint32_t b) const {
        const Proxy &p = patch_[a].proxy, &q = patch_[b].proxy;
        const double grown = joined(p, q).spread() - p.spread() - q.spread();
        return (grown + kEven * p.area * q.area / (p.area + q.area)) / patch_[a].border.at(b);
    }

    void push_all(std::uint32_t a, bool later_only) {
        for (const auto& [b, border] : patch_[a].border) {
            if (later_only && b < a) continue;
            const std::uint32_t x = std::min(a, b), y = std::max(a, b);
            queue_.push({cost(x, y), x, y, patch_[x].age, patch_[y].age});
        }
    }

    [[nodiscard]] bool allowed(std::uint32_t a, std::uint32_t b) const {
        const Proxy all = joined(patch_[a].proxy, patch_[b].proxy);
        const double angle = limits_.angle_deg * kDegree, bend = limits_.bend_deg * kDegree;
        double turned = 0, bent = 0;
        for (const std::uint32_t from : {a, b})
            for (const std::uint32_t v : patch_[from].cells) {
                if (bend_from(all, cells_.normal[v]) > bend) bent += cells_.area[v];
                if (angle_from(all, cells_.normal[v], pull_.along[v]) > angle)
                    turned += cells_.area[v] * pull_.trust[v];
            }
        return bent <= kBeyond * all.area && turned <= kBeyond * all.weight;
    }

    // Merges the patch with fewer cells into the other, and returns that.
    std::uint32_t unite(std::uint32_t a, std::uint32_t b) {
        if (patch_[a].cells.size() < patch_[b].cells.size()) std::swap(a, b);
        Patch &to = patch_[a], &from = patch_[b];
        to.proxy = joined(to.proxy, from.proxy);
        to.cells.insert(to.cells.end(), from.cells.begin(), from.cells.end());
        to.border.erase(b);
        for (const auto& [other, border] : from.border) {
            if (other == a) continue;
            patch_[other].border.erase(b);
            to.border[other] += border;
            patch_[other].border[a] += border;
        }
        ++to.age;
        --left_;
        from = {};
        return a;
    }

    const Cells& cells_;
    const Pull& pull_;
    const Limits& limits_;
    std::vector<Patch> patch_;
    std::priority_queue<MergeCandidate, std::vector<MergeCandidate>, std::greater<>> queue_;
    std::int64_t left_ = 0;
};

} // namespace

double border_factor(const Pull& pull, const CellBorder& side) {
    const auto cut = [&](std::uint32_t v) {
        const double c = dot(pull.along[v], side.way);
        return pull.trust[v] * c * c;
    };
    return 1 + kAcross * (cut(side.a) + cut(side.b)) / 2;
}

std::vector<std::uint32_t> merge(const Cells& cells, const Pull& pull, const Limits& limits) {
    Merger merger(cells, pull, limits);
    merger.run();
    merger.absorb_small();
    return merger.labels();
}

} // namespace filum::partition
