#include "baselines/kipping2022/path.hpp"
#include "baselines/kipping2022/rings.hpp"
#include "baselines/kipping2022/tree.hpp"

#include <deque>

namespace filum::baselines::kipping2022 {

namespace {

using surfpath::plan::Plan;

constexpr const char* kNeedsBoundary = "run geodesic --source boundary first";

// The recursion of the paper, with a stack of its own.
class Traversal {
  public:
    Traversal(const Tree& tree, const Options& o) : nodes_(tree.nodes), o_(o), seen_(tree.nodes.size(), 0) {}

    // The path from point `start` of a contour through all contours reached from it. Contours without a place for
    // rerouting are appended to `left`, each after its parent.
    Points run(std::uint32_t root, std::size_t start, std::deque<std::pair<std::uint32_t, std::uint32_t>>& left) {
        Points path;
        seen_[root] = 1;
        std::vector<Visit> stack{visit(root, start, true, nodes_[root].points().size())};
        while (!stack.empty()) {
            Visit& now = stack.back();
            if (now.done == now.count) {
                for (const std::uint32_t child : now.children)
                    if (seen_[child] == 0) left.emplace_back(child, now.node);
                stack.pop_back();
                continue;
            }
            path.push_back(point(now, now.done));
            const std::uint32_t child = reroute(now);
            if (child == surface::kNone) {
                ++now.done;
                continue;
            }
            ++rerouted;
            seen_[child] = 1;
            const std::size_t last = now.done + run_length() - 1;
            Visit next = enter(child, path.back(), point(now, last), !now.forwards);
            now.done = last;
            stack.push_back(std::move(next));
        }
        return path;
    }

    std::size_t rerouted = 0;

  private:
    // A contour during its traversal.
    struct Visit {
        std::uint32_t node;
        std::size_t start, count, done; // points
        bool forwards;
        std::vector<std::uint32_t> children;
        std::vector<std::vector<char>> near; // per child and point of the contour: nearer than t_dist
    };

    [[nodiscard]] std::size_t run_length() const { return std::max<std::size_t>(2, static_cast<std::size_t>(o_.run)); }

    [[nodiscard]] std::size_t index(const Visit& v, std::size_t k) const {
        const std::size_t n = nodes_[v.node].points().size();
        return v.forwards ? (v.start + k) % n : (v.start + n - k % n) % n;
    }
    [[nodiscard]] const Vec3& point(const Visit& v, std::size_t k) const {
        return nodes_[v.node].points()[index(v, k)];
    }

    [[nodiscard]] Visit visit(std::uint32_t node, std::size_t start, bool forwards, std::size_t count) const {
        Visit out{node, start, count, 0, forwards, {}, {}};
        for (const std::uint32_t child : nodes_[node].neighbours) {
            if (seen_[child] != 0) continue;
            out.children.push_back(child);
            out.near.emplace_back();
            for (const Vec3& p : nodes_[node].points())
                out.near.back().push_back(nodes_[child].cloud.nearest(p, o_.reach).index != surface::kNone ? 1 : 0);
        }
        return out;
    }

    // The child that stays near for the next points; kNone if there is none.
    [[nodiscard]] std::uint32_t reroute(const Visit& v) const {
        if (v.done + run_length() > v.count) return surface::kNone;
        for (std::size_t c = 0; c < v.children.size(); ++c) {
            if (seen_[v.children[c]] != 0) continue;
            std::size_t k = 0;
            while (k < run_length() && v.near[c][index(v, v.done + k)] != 0) ++k;
            if (k == run_length()) return v.children[c];
        }
        return surface::kNone;
    }

    // The traversal of the child from the point nearest to `from` to the one nearest to `to`, by the long way.
    [[nodiscard]] Visit enter(std::uint32_t child, const Vec3& from, const Vec3& to, bool forwards) const {
        const std::size_t n = nodes_[child].points().size();
        const std::size_t a = nodes_[child].cloud.nearest(from).index, b = nodes_[child].cloud.nearest(to).index;
        const std::size_t way = forwards ? (b + n - a) % n : (a + n - b) % n;
        return visit(child, a, forwards, 2 * way < n ? n : way + 1);
    }

    const std::vector<Node>& nodes_;
    const Options& o_;
    std::vector<char> seen_;
};

} // namespace

Plan geo_fiso(const surface::Sheet& sheet, const Options& o) {
    const auto& phi = distances(sheet, kNeedsBoundary);
    Plan plan;
    const Tree all = tree(sheet, phi, o, plan.notes);
    note_unreached(sheet.surface, phi, plan.notes);
    const Strokes strokes(sheet.surface, o);
    Traversal traversal(all, o);
    std::size_t lost = 0;
    for (const std::uint32_t root : all.roots) {
        std::deque<std::pair<std::uint32_t, std::uint32_t>> left; // contours and their parents
        strokes.lay(traversal.run(root, 0, left), plan);
        for (; !left.empty(); left.pop_front(), ++lost) {
            const auto [child, parent] = left.front();
            double least = std::numeric_limits<double>::infinity();
            std::size_t start = 0;
            for (std::size_t i = 0; i < all.nodes[child].points().size(); ++i) {
                const auto found = all.nodes[parent].cloud.nearest(all.nodes[child].points()[i], least);
                if (found.distance < least) {
                    least = found.distance;
                    start = i;
                }
            }
            strokes.lay(traversal.run(child, start, left), plan);
        }
    }
    plan.facts = {{"", "contours", static_cast<double>(all.nodes.size()), ""},
                  {"", "reroutings", static_cast<double>(traversal.rerouted), ""},
                  {"", "not-rerouted", static_cast<double>(lost), "contours"},
                  {"", "t-dist", o.reach, "mm"},
                  {"", "n-thresh", static_cast<double>(o.run), "points"}};
    return plan;
}

} // namespace filum::baselines::kipping2022
