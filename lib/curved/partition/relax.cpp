#include "partition/relax.hpp"

#include "base/error.hpp"
#include "parallel/parallel.hpp"
#include "partition/merge.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include <Eigen/SparseCholesky>

namespace filum::partition {

namespace {

constexpr int kRounds = 40, kStill = 2; // most rounds; rounds with few moving cells after which it ends
constexpr double kFew = 2e-3;           // share of all cells
constexpr double kVanished = -1e300;
constexpr double kSteps = 2; // mean edges over which indicators spread, at least; with less, borders do not move

using DiffusionMatrix = Eigen::SparseMatrix<double>;
using Factor = Eigen::SimplicialLDLT<DiffusionMatrix>;

// Components of the cells, by first cells.
std::vector<std::uint32_t> components(const Cells& cells) {
    std::vector<std::uint32_t> root(cells.area.size());
    for (std::uint32_t v = 0; v < root.size(); ++v) root[v] = v;
    const auto find = [&](std::uint32_t v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    for (const CellBorder& side : cells.sides) {
        const std::uint32_t a = find(side.a), b = find(side.b);
        root[std::max(a, b)] = std::min(a, b);
    }
    for (std::uint32_t v = 0; v < root.size(); ++v) root[v] = find(v);
    return root;
}

// Patches of different components never meet, so patches with the same rank within their components share one linear
// system.
class RankedPatches {
  public:
    RankedPatches(std::vector<std::uint32_t> patch, const Cells& cells) : component_(components(cells)), patch_(patch) {
        std::map<std::uint32_t, std::uint32_t> count; // per component
        std::map<std::uint32_t, std::uint32_t> rank;  // per patch
        for (std::uint32_t v = 0; v < patch_.size(); ++v)
            if (rank.emplace(patch_[v], 0).second) {
                rank[patch_[v]] = count[component_[v]]++;
                first_.push_back(v);
            }
        for (const auto& [c, n] : count) ranks_ = std::max(ranks_, n);
        for (auto& p : patch) p = rank[p];
        rank_ = std::move(patch);
        name_.assign(ranks_, {});
        for (const std::uint32_t v : first_) name_[rank_[v]][component_[v]] = patch_[v];
    }
    [[nodiscard]] std::uint32_t ranks() const { return ranks_; }
    [[nodiscard]] std::uint32_t rank(std::size_t cell) const { return rank_[cell]; }
    [[nodiscard]] std::uint32_t component(std::size_t cell) const { return component_[cell]; }
    [[nodiscard]] bool has(std::size_t cell, std::uint32_t rank) const {
        return name_[rank].contains(component_[cell]);
    }
    void move(std::size_t cell, std::uint32_t rank) { rank_[cell] = rank; }
    [[nodiscard]] std::vector<std::uint32_t> take() {
        for (std::size_t v = 0; v < patch_.size(); ++v) patch_[v] = name_[rank_[v]].at(component_[v]);
        return std::move(patch_);
    }

  private:
    std::vector<std::uint32_t> component_, patch_, rank_, first_;
    std::vector<std::map<std::uint32_t, std::uint32_t>> name_; // by rank: the patch of that rank, per component
    std::uint32_t ranks_ = 0;
};

// Diffusion over time step^2, mm2, as one implicit step; faster across strong directions if there is tension.
std::unique_ptr<Factor> diffusion(const Cells& cells, const Pull* pull, double step) {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t v = 0; v < cells.area.size(); ++v)
        entries.emplace_back(static_cast<int>(v), static_cast<int>(v), cells.area[v]);
    for (const CellBorder& side : cells.sides) {
        const int a = static_cast<int>(side.a), b = static_cast<int>(side.b);
        const double factor = pull != nullptr ? border_factor(*pull, side) : 1;
        const double w = step * step * side.conductance * factor;
        entries.emplace_back(a, a, w);
        entries.emplace_back(b, b, w);
        entries.emplace_back(b, a, -w);
    }
    const auto n = static_cast<int>(cells.area.size());
    DiffusionMatrix m(n, n);
    m.setFromTriplets(entries.begin(), entries.end());
    auto out = std::make_unique<Factor>(m);
    if (out->info() != Eigen::Success)
        throw Error(Exit::failure, "cannot smooth the borders: the surface's triangles are too uneven; remesh it");
    return out;
}

// Share of a cell that belongs to its own patch, 0.5 to 1, where a border crosses it; the rest belongs to another
// rank.
struct CellShare {
    double own = 1;
    std::uint32_t other = kNone;
};

using Values = std::vector<Eigen::VectorXd>; // by rank, per cell

// The share of each cell that comes from each patch.
Values spread(const RankedPatches& patches, const std::vector<CellShare>& parts, const Cells& cells,
              const Factor& diffusion, int threads) {
    Values from(patches.ranks(), Eigen::VectorXd::Zero(static_cast<Eigen::Index>(cells.area.size())));
    for (std::size_t v = 0; v < cells.area.size(); ++v) {
        const auto at = static_cast<Eigen::Index>(v);
        from[patches.rank(v)][at] = cells.area[v] * parts[v].own;
        if (parts[v].other != kNone) from[parts[v].other][at] = cells.area[v] * (1 - parts[v].own);
    }
    parallel::for_chunks(from.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) from[r] = diffusion.solve(from[r]).eval();
    });
    return from;
}

using Proxies = std::vector<std::map<std::uint32_t, Proxy>>; // by rank and component

Proxies proxies(const RankedPatches& patches, const Cells& cells, const Pull& pull) {
    Proxies out(patches.ranks());
    for (std::size_t v = 0; v < cells.area.size(); ++v) {
        auto& all = out[patches.rank(v)];
        const auto [at, fresh] = all.emplace(patches.component(v), Proxy{});
        at->second = fresh ? proxy(cells, pull, v) : joined(at->second, proxy(cells, pull, v));
    }
    return out;
}

// Moves every cell to the patch of the greatest value; returns how many moved.
Eigen::Index settle(RankedPatches& patches, const Values& value) {
    Eigen::Index moved = 0;
    for (Eigen::Index v = 0; v < value[0].size(); ++v) {
        const auto cell = static_cast<std::size_t>(v);
        std::uint32_t best = patches.rank(cell);
        for (std::uint32_t r = 0; r < patches.ranks(); ++r)
            if (patches.has(cell, r) && value[r][v] > value[best][v] + 1e-12) best = r;
        if (best != patches.rank(cell)) {
            patches.move(cell, best);
            ++moved;
        }
    }
    return moved;
}

// Per border of cells of two patches the share of the way from a to b where their values are equal.
std::vector<double> crossings(const RankedPatches& patches, const Cells& cells, const Values& value) {
    std::vector<double> out(cells.sides.size(), 0);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const auto a = static_cast<Eigen::Index>(cells.sides[i].a), b = static_cast<Eigen::Index>(cells.sides[i].b);
        const std::uint32_t p = patches.rank(cells.sides[i].a), q = patches.rank(cells.sides[i].b);
        if (p == q) continue;
        const double from = value[p][a] - value[q][a], to = value[p][b] - value[q][b]; // >= 0, <= 0
        out[i] = from - to > 0 ? from / (from - to) : 0.5;
    }
    return out;
}

// Shares by the crossing nearest to each cell; without them borders would move by whole cells.
std::vector<CellShare> shares(const RankedPatches& patches, const Cells& cells, const std::vector<double>& at) {
    std::vector<CellShare> out(cells.area.size());
    const auto pass = [&](std::uint32_t v, std::uint32_t other, double distance) {
        if (0.5 + distance < out[v].own) out[v] = {0.5 + distance, patches.rank(other)};
    };
    for (std::size_t i = 0; i < at.size(); ++i) {
        const auto [a, b] = std::pair{cells.sides[i].a, cells.sides[i].b};
        if (patches.rank(a) != patches.rank(b)) {
            pass(a, b, at[i]);
            pass(b, a, 1 - at[i]);
        }
    }
    return out;
}

// Subtracts the misfit of the cells to the patches from the values.
void weigh(Values& value, const RankedPatches& patches, const Cells& cells, const Pull& pull, double tension) {
    const Proxies mean = proxies(patches, cells, pull);
    for (std::uint32_t r = 0; r < patches.ranks(); ++r)
        for (std::size_t v = 0; v < cells.area.size(); ++v) {
            double& here = value[r][static_cast<Eigen::Index>(v)];
            const auto at = mean[r].find(patches.component(v));
            here = at == mean[r].end() ? kVanished : tension * here - misfit(at->second, cells, pull, v);
        }
}

std::vector<CellShare> follow(RankedPatches& patches, const Cells& cells, const Pull& pull, double length, double step,
                              int threads) {
    const auto factor = diffusion(cells, &pull, step);
    const double tension = 2 * length / step; // of the implicit step, which moves step / 2 per length of border
    std::vector<CellShare> part(cells.area.size());
    for (int round = 0, still = 0; round < kRounds && still < kStill; ++round) {
        Values value = spread(patches, part, cells, *factor, threads);
        weigh(value, patches, cells, pull, tension);
        const auto moved = settle(patches, value);
        still = static_cast<double>(moved) > kFew * static_cast<double>(cells.area.size()) ? 0 : still + 1;
        part = shares(patches, cells, crossings(patches, cells, value));
    }
    return part;
}

} // namespace

Borders relax(std::vector<std::uint32_t> patch, const Cells& cells, const Pull& pull, double length, int threads) {
    Borders out;
    out.at.assign(cells.sides.size(), 0);
    RankedPatches patches(std::move(patch), cells);
    if (patches.ranks() > 1) {
        const double least = kSteps * cells.mean_side;
        const auto part = follow(patches, cells, pull, length, std::max(length / 2, least), threads);
        const Values value = spread(patches, part, cells, *diffusion(cells, nullptr, least), threads);
        settle(patches, value);
        out.at = crossings(patches, cells, value);
    }
    out.patch = patches.take();
    return out;
}

Borders above(const std::vector<double>& value, double level, const Cells& cells, double length) {
    Eigen::VectorXd from(static_cast<Eigen::Index>(value.size()));
    for (std::size_t v = 0; v < value.size(); ++v) from[static_cast<Eigen::Index>(v)] = cells.area[v] * value[v];
    const Eigen::VectorXd spread = diffusion(cells, nullptr, length)->solve(from);
    const auto over = [&](std::size_t v) { return spread[static_cast<Eigen::Index>(v)] - level; };
    Borders out{std::vector<std::uint32_t>(value.size(), 0), std::vector<double>(cells.sides.size(), 0)};
    for (std::size_t v = 0; v < value.size(); ++v) out.patch[v] = over(v) > 0 ? 1 : 0;
    for (std::size_t i = 0; i < cells.sides.size(); ++i) {
        const double a = over(cells.sides[i].a), b = over(cells.sides[i].b);
        if ((a > 0) != (b > 0)) out.at[i] = a / (a - b);
    }
    return out;
}

} // namespace filum::partition
