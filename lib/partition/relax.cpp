#include "partition/relax.hpp"

#include "base/error.hpp"
#include "partition/merge.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include <Eigen/SparseCholesky>

namespace filum::partition {

namespace {

constexpr int kRounds = 30;
constexpr double kSteps = 2; // mean sides that indicators spread by, at least: less, and borders do not move

using Matrix = Eigen::SparseMatrix<double>;
using Factor = Eigen::SimplicialLDLT<Matrix>;

// Components of the cells, by first cells.
std::vector<std::uint32_t> components(const Cells& cells) {
    std::vector<std::uint32_t> root(cells.area.size());
    for (std::uint32_t v = 0; v < root.size(); ++v) root[v] = v;
    const auto find = [&](std::uint32_t v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    for (const Side& side : cells.sides) {
        const std::uint32_t a = find(side.a), b = find(side.b);
        root[std::max(a, b)] = std::min(a, b);
    }
    for (std::uint32_t v = 0; v < root.size(); ++v) root[v] = find(v);
    return root;
}

// Patches of different components never meet: those with the same rank in theirs spread in one solution.
class Patches {
  public:
    Patches(std::vector<std::uint32_t> patch, const Cells& cells) : component_(components(cells)), patch_(patch) {
        std::map<std::uint32_t, std::uint32_t> count; // of a component
        std::map<std::uint32_t, std::uint32_t> rank;  // of a patch
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
    std::vector<std::map<std::uint32_t, std::uint32_t>> name_; // by rank: of the component's patch of that rank
    std::uint32_t ranks_ = 0;
};

// Diffusion for the time step^2, mm2, by one implicit step; faster across strong directions if there is a pull.
std::unique_ptr<Factor> diffusion(const Cells& cells, const Pull* pull, double step) {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t v = 0; v < cells.area.size(); ++v)
        entries.emplace_back(static_cast<int>(v), static_cast<int>(v), cells.area[v]);
    for (const Side& side : cells.sides) {
        const int a = static_cast<int>(side.a), b = static_cast<int>(side.b);
        const double factor = pull != nullptr ? border_factor(*pull, side) : 1;
        const double w = step * step * side.conductance * factor;
        entries.emplace_back(a, a, w), entries.emplace_back(b, b, w), entries.emplace_back(b, a, -w);
    }
    const auto n = static_cast<int>(cells.area.size());
    Matrix m(n, n);
    m.setFromTriplets(entries.begin(), entries.end());
    auto out = std::make_unique<Factor>(m);
    if (out->info() != Eigen::Success)
        throw Error(Exit::failure, "cannot smooth the borders: the surface's triangles are too uneven; remesh it");
    return out;
}

// Per rank, how much of each cell comes from its patch.
std::vector<Eigen::VectorXd> spread(const Patches& patches, const Cells& cells, const Factor& diffusion) {
    std::vector<Eigen::VectorXd> out(patches.ranks());
    for (std::uint32_t r = 0; r < patches.ranks(); ++r) {
        Eigen::VectorXd from = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(cells.area.size()));
        for (std::size_t v = 0; v < cells.area.size(); ++v)
            if (patches.rank(v) == r) from[static_cast<Eigen::Index>(v)] = cells.area[v];
        out[r] = diffusion.solve(from);
    }
    return out;
}

using Proxies = std::vector<std::map<std::uint32_t, Proxy>>; // by rank and component

Proxies proxies(const Patches& patches, const Cells& cells, const Pull& pull) {
    Proxies out(patches.ranks());
    for (std::size_t v = 0; v < cells.area.size(); ++v) {
        auto& all = out[patches.rank(v)];
        const auto [at, fresh] = all.emplace(patches.component(v), Proxy{});
        at->second = fresh ? proxy(cells, pull, v) : joined(at->second, proxy(cells, pull, v));
    }
    return out;
}

// Moves every cell to where the value is greatest; true if any moved.
template <class Value>
bool settle(Patches& patches, std::size_t cells, const Value& value) {
    bool moved = false;
    for (std::size_t v = 0; v < cells; ++v) {
        std::uint32_t best = patches.rank(v);
        double most = value(v, best);
        for (std::uint32_t r = 0; r < patches.ranks(); ++r) {
            if (r == best || !patches.has(v, r)) continue;
            if (const double x = value(v, r); x > most + 1e-12) most = x, best = r;
        }
        if (best != patches.rank(v)) patches.move(v, best), moved = true;
    }
    return moved;
}

void follow(Patches& patches, const Cells& cells, const Pull& pull, double length, double step) {
    const auto factor = diffusion(cells, &pull, step);
    const double tension = 2 * length / step; // of the implicit step: what it sends across, by length, is step / 2
    for (int round = 0; round < kRounds; ++round) {
        const auto share = spread(patches, cells, *factor);
        const Proxies mean = proxies(patches, cells, pull);
        const bool moved = settle(patches, cells.area.size(), [&](std::size_t v, std::uint32_t r) {
            const auto at = mean[r].find(patches.component(v));
            if (at == mean[r].end()) return -1e300; // vanished
            return tension * share[r][static_cast<Eigen::Index>(v)] - misfit(at->second, cells, pull, v);
        });
        if (!moved) return;
    }
}

} // namespace

Borders relax(std::vector<std::uint32_t> patch, const Cells& cells, const Pull& pull, double length) {
    Borders out;
    out.at.assign(cells.sides.size(), 0);
    Patches patches(std::move(patch), cells);
    if (patches.ranks() > 1) {
        follow(patches, cells, pull, length, std::max(length / 2, kSteps * cells.mean_side));
        const auto share = spread(patches, cells, *diffusion(cells, nullptr, kSteps * cells.mean_side));
        const auto value = [&](std::size_t v, std::uint32_t r) { return share[r][static_cast<Eigen::Index>(v)]; };
        settle(patches, cells.area.size(), value);
        for (std::size_t i = 0; i < cells.sides.size(); ++i) {
            const auto [a, b] = std::pair{cells.sides[i].a, cells.sides[i].b};
            const std::uint32_t p = patches.rank(a), q = patches.rank(b);
            if (p == q) continue;
            const double from = value(a, p) - value(a, q), to = value(b, p) - value(b, q); // >= 0, <= 0
            out.at[i] = from - to > 0 ? from / (from - to) : 0.5;
        }
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
