#include "baselines/kipping2022/maximum.hpp"
#include "baselines/kipping2022/path.hpp"
#include "baselines/kipping2022/rings.hpp"
#include "baselines/kipping2022/tree.hpp"

#include <algorithm>

namespace filum::baselines::kipping2022 {

namespace {

using surfpath::plan::Plan;

constexpr double kAtMaximum = 0.1; // d: values this near to the greatest count as the maximum
constexpr double kApart = 0.25;    // d: least distance between points there

// The contours of a component of the tree without those that branch, from one end to the other, starting at the lower
// one.
std::vector<std::uint32_t> chain(const std::vector<Node>& nodes, std::uint32_t from, std::vector<char>& seen) {
    const auto next = [&](std::uint32_t n) {
        for (const std::uint32_t m : nodes[n].neighbours)
            if (nodes[m].neighbours.size() <= 2 && seen[m] == 0) return m;
        return surface::kNone;
    };
    std::vector<std::uint32_t> out, back;
    seen[from] = 1;
    for (std::uint32_t n = from; n != surface::kNone; n = next(n)) {
        seen[n] = 1;
        out.push_back(n);
    }
    for (std::uint32_t n = next(from); n != surface::kNone; n = next(n)) {
        seen[n] = 1;
        back.push_back(n);
    }
    out.insert(out.begin(), back.rbegin(), back.rend());
    return out;
}

// Parts of the chain along which levels only rise or only fall, each directed inwards.
std::vector<std::vector<std::uint32_t>> monotone(const std::vector<Node>& nodes,
                                                 const std::vector<std::uint32_t>& chain) {
    const auto level = [&](std::uint32_t n) { return nodes[n].contour.level; };
    std::vector<std::vector<std::uint32_t>> out;
    for (std::size_t i = 0; i < chain.size();) {
        std::size_t to = i + 1;
        const bool up = to < chain.size() && level(chain[to]) > level(chain[i]);
        while (to < chain.size() && (level(chain[to]) > level(chain[to - 1])) == up) ++to;
        out.emplace_back(chain.begin() + static_cast<std::ptrdiff_t>(i),
                         chain.begin() + static_cast<std::ptrdiff_t>(to));
        if (!up) std::reverse(out.back().begin(), out.back().end());
        i = to;
    }
    return out;
}

class SpiralBuilder {
  public:
    SpiralBuilder(const surface::Sheet& sheet, const std::vector<double>& phi, const Tree& tree, const Options& o)
        : surface_(sheet.surface), phi_(phi), nodes_(tree.nodes), o_(o), seen_(phi.size(), 0) {}

    // The spiral ring by ring inwards, then along the maximum; several lines where it must be cut.
    std::vector<Points> spiral(const std::vector<std::uint32_t>& rings) {
        const Points ridge = ridge_in(rings.back());
        const std::vector<std::uint32_t> starts = begins(rings, ridge);
        std::vector<Points> out(1);
        for (std::size_t i = 0; i < rings.size(); ++i) {
            const Points& ring = nodes_[rings[i]].points();
            const std::size_t n = ring.size();
            const auto gap = std::min(static_cast<std::size_t>(o_.run), n / 2);
            const bool last = i + 1 == rings.size() && ridge.empty();
            if (i > 0) go_on(out, ring[starts[i]], nodes_[rings[i - 1]].points()[starts[i - 1]]);
            for (std::size_t k = 0; k + (last ? 0 : gap) < n; ++k) out.back().push_back(ring[(starts[i] + k) % n]);
        }
        for (std::size_t i = 0; i < ridge.size(); ++i) {
            go_on(out, ridge[i], i > 0 ? ridge[i - 1] : inner_start(rings.back(), starts.back()));
            out.back().push_back(ridge[i]);
        }
        return out;
    }

    std::size_t maxima = 0;

  private:
    // The line through the maximum inside a ring without other rings inside.
    Points ridge_in(std::uint32_t node) {
        const Node& n = nodes_[node];
        for (const std::uint32_t m : n.neighbours)
            if (nodes_[m].contour.level > n.contour.level) return {};
        const double level = (n.contour.level - kAtLevel) * o_.spacing;
        for (const std::uint32_t v : surface_.triangles[n.contour.triangle])
            if (phi_[v] >= level && seen_[v] == 0) {
                Points out = maximum(surface_, phi_, level, v, kAtMaximum * o_.spacing, kApart * o_.spacing, seen_);
                if (!out.empty()) ++maxima;
                return out;
            }
        return {};
    }

    // The start of each ring, nearest to that of the ring inside. For the innermost one starts are tried in the order
    // of their distance from the maximum until all connections are within reach; otherwise the first with the fewest
    // cuts.
    [[nodiscard]] std::vector<std::uint32_t> begins(const std::vector<std::uint32_t>& rings,
                                                    const Points& ridge) const {
        const Points& inner = nodes_[rings.back()].points();
        std::vector<std::pair<double, std::uint32_t>> tries;
        for (std::uint32_t k = 0; k < inner.size(); k += static_cast<std::uint32_t>(std::max<std::int64_t>(1, o_.run)))
            tries.emplace_back(ridge.empty() ? 0 : distance(inner[k], ridge.front()), k);
        std::sort(tries.begin(), tries.end());
        std::vector<std::uint32_t> best;
        std::size_t fewest = rings.size() + 1;
        for (const auto& [away, k] : tries) {
            std::vector<std::uint32_t> starts(rings.size(), k);
            std::size_t cuts = 0;
            for (std::size_t i = rings.size() - 1; i-- > 0;) {
                const auto found = nodes_[rings[i]].cloud.nearest(nodes_[rings[i + 1]].points()[starts[i + 1]]);
                starts[i] = found.index;
                if (found.distance > o_.reach) ++cuts;
            }
            if (!ridge.empty() && away > o_.reach) ++cuts;
            if (cuts < fewest) {
                fewest = cuts;
                best = starts;
            }
            if (cuts == 0) break;
        }
        return best;
    }

    [[nodiscard]] const Vec3& inner_start(std::uint32_t node, std::uint32_t start) const {
        return nodes_[node].points()[start];
    }

    // Starts a new line if the next point is too far from the place where the present one would continue.
    void go_on(std::vector<Points>& lines, const Vec3& next, const Vec3& place) const {
        if (distance(next, place) > o_.reach) lines.emplace_back();
    }

    const Surface& surface_;
    const std::vector<double>& phi_;
    const std::vector<Node>& nodes_;
    const Options& o_;
    std::vector<char> seen_; // vertices at maxima in which a spiral ends
};

} // namespace

Plan geo_contour(const surface::Sheet& sheet, const Options& o) {
    const auto& phi = distances(sheet, "run geodesic --source boundary first");
    Plan plan;
    const Tree all = tree(sheet, phi, o, plan.notes);
    note_unreached(sheet.surface, phi, plan.notes);
    const Strokes strokes(sheet.surface, o);
    SpiralBuilder spirals(sheet, phi, all, o);
    std::vector<char> seen(all.nodes.size(), 0);
    std::size_t count = 0, rerouting = 0;
    const auto branches = [&](std::uint32_t n) { return all.nodes[n].neighbours.size() > 2; };
    for (std::uint32_t n = 0; n < all.nodes.size(); ++n) {
        if (seen[n] != 0 || branches(n)) continue;
        for (const auto& rings : monotone(all.nodes, chain(all.nodes, n, seen))) {
            ++count;
            for (const Points& line : spirals.spiral(rings))
                if (line.size() > 1) strokes.lay(line, plan);
        }
    }
    for (std::uint32_t n = 0; n < all.nodes.size(); ++n) {
        if (!branches(n)) continue;
        ++rerouting;
        Points ring = all.nodes[n].points();
        ring.push_back(ring.front());
        strokes.lay(ring, plan);
    }
    plan.facts = {{"", "contours", static_cast<double>(all.nodes.size()), ""},
                  {"", "spirals", static_cast<double>(count), ""},
                  {"", "maxima", static_cast<double>(spirals.maxima), ""},
                  {"", "rerouting-contours", static_cast<double>(rerouting), ""},
                  {"", "t-dist", o.reach, "mm"},
                  {"", "n-thresh", static_cast<double>(o.run), "points"}};
    return plan;
}

} // namespace filum::baselines::kipping2022
