#include "surfpath/order.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <unordered_set>

namespace filum::surfpath {

namespace {

constexpr std::uint32_t kNo = ~std::uint32_t{0};

// An open end of a chain that may still be linked, and the chain's other end; kNo if that may not.
struct Open {
    std::uint32_t end, mate;
};

struct State {
    std::vector<Open> open; // by end
    double cost = 0;
    std::uint32_t parent = kNo;
    std::uint32_t link[2] = {kNo, kNo}; // made with this row's begin and end
};

struct Choice {
    double cost;
    std::uint32_t parent, link[2];
};

class Beam {
  public:
    Beam(std::uint32_t rows, std::span<const Link> links, const Costs& costs, std::size_t kept)
        : rows_(rows), links_(links), break_(costs.breaks / 2), gap_(costs.gap), kept_(kept), back_(2 * rows), last_(2 * rows, 0) {
        for (std::uint32_t i = 0; i < links.size(); ++i) {
            back_[links[i].to].push_back(i);
            last_[links[i].from] = std::max(last_[links[i].from], links[i].to / 2);
        }
        for (std::uint32_t e = 0; e < 2 * rows; ++e) last_[e] = std::max(last_[e], e / 2);
    }

    // Per end the link that it has, kNo if none.
    std::vector<std::uint32_t> run() {
        layers_.assign(1, {State{}});
        for (std::uint32_t row = 0; row < rows_; ++row) advance(row);
        std::vector<std::uint32_t> out(2 * rows_, kNo);
        std::uint32_t at = 0;
        for (std::uint32_t row = rows_; row > 0; --row) {
            const State& s = layers_[row][at];
            for (const std::uint32_t l : s.link)
                if (l != kNo) out[links_[l].from] = out[links_[l].to] = l;
            at = s.parent;
        }
        return out;
    }

  private:
    static const Open* find(const State& s, std::uint32_t end) {
        for (const Open& o : s.open)
            if (o.end == end) return &o;
        return nullptr;
    }

    void advance(std::uint32_t row) {
        std::vector<Choice> choices;
        const auto& from = layers_.back();
        for (std::uint32_t p = 0; p < from.size(); ++p) extend(from[p], p, row, choices);
        std::sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) {
            return std::tuple(a.cost, a.parent, a.link[0], a.link[1]) <
                   std::tuple(b.cost, b.parent, b.link[0], b.link[1]);
        });
        std::vector<State> next;
        std::unordered_set<std::string> seen;
        for (const Choice& c : choices) {
            State s = made(from[c.parent], c, row);
            std::string key(reinterpret_cast<const char*>(s.open.data()), s.open.size() * sizeof(Open));
            if (!seen.insert(std::move(key)).second) continue;
            next.push_back(std::move(s));
            if (next.size() == kept_) break;
        }
        layers_.push_back(std::move(next));
    }

    void extend(const State& s, std::uint32_t parent, std::uint32_t row, std::vector<Choice>& out) const {
        double expired = 0; // cost of those that were not linked in time
        std::uint32_t waiting[2] = {0, 0}; // ends on either side that lead on, of rows before
        for (const Open& o : s.open)
            if (last_[o.end] > row) ++waiting[o.end % 2];
        for (const Open& o : s.open)
            if (last_[o.end] == row) expired += break_;
        const auto try_end = [&](std::uint32_t end, auto&& found) {
            found(kNo, last_[end] == row ? break_ : 0, kNo);
            for (const std::uint32_t l : back_[end])
                if (const Open* o = find(s, links_[l].from)) found(l, links_[l].cost - (last_[o->end] == row ? break_ : 0), o->end);
        };
        try_end(2 * row, [&](std::uint32_t a, double cost_a, std::uint32_t from_a) {
            try_end(2 * row + 1, [&](std::uint32_t b, double cost_b, std::uint32_t from_b) {
                if (a != kNo && b != kNo && (from_a == from_b || find(s, from_a)->mate == from_b)) return;
                // Nothing leads over the gap behind this row.
                std::uint32_t over[2] = {waiting[0], waiting[1]};
                if (a == kNo) over[0] += last_[2 * row] > row;
                else over[from_a % 2] -= last_[from_a] > row;
                if (b == kNo) over[1] += last_[2 * row + 1] > row;
                else over[from_b % 2] -= last_[from_b] > row;
                const double gaps = gap_ * ((over[0] == 0) + (over[1] == 0));
                out.push_back({s.cost + expired + gaps + cost_a + cost_b, parent, {a, b}});
            });
        });
    }

    State made(const State& s, const Choice& c, std::uint32_t row) const {
        State out{s.open, c.cost, c.parent, {c.link[0], c.link[1]}};
        out.open.push_back({2 * row, 2 * row + 1});
        out.open.push_back({2 * row + 1, 2 * row});
        const auto set_mate = [&](std::uint32_t end, std::uint32_t mate) {
            for (Open& o : out.open)
                if (o.end == end) o.mate = mate;
        };
        const auto remove = [&](std::uint32_t end) {
            std::erase_if(out.open, [&](const Open& o) { return o.end == end; });
        };
        for (const std::uint32_t l : c.link) {
            if (l == kNo) continue;
            const std::uint32_t a = links_[l].from, b = links_[l].to, ma = find(out, a)->mate, mb = find(out, b)->mate;
            if (ma != kNo) set_mate(ma, mb);
            if (mb != kNo) set_mate(mb, ma);
            remove(a), remove(b);
        }
        for (std::size_t i = 0; i < out.open.size();) {
            const Open o = out.open[i];
            if (last_[o.end] > row) {
                ++i;
                continue;
            }
            if (o.mate != kNo) set_mate(o.mate, kNo);
            remove(o.end);
        }
        return out;
    }

    std::uint32_t rows_;
    std::span<const Link> links_;
    double break_, gap_;
    std::size_t kept_;
    std::vector<std::vector<std::uint32_t>> back_; // per end: links to rows before
    std::vector<std::uint32_t> last_;              // per end: the last row that it may be linked to
    std::vector<std::vector<State>> layers_;
};

} // namespace

std::vector<std::vector<Visit>> order(std::uint32_t rows, std::span<const Link> links, const Costs& costs,
                                      std::size_t kept) {
    const auto link = Beam(rows, links, costs, kept).run();
    std::vector<std::vector<Visit>> out;
    std::vector<char> seen(rows, 0);
    for (std::uint32_t e = 0; e < 2 * rows; ++e) {
        if (link[e] != kNo || seen[e / 2]) continue;
        auto& chain = out.emplace_back();
        for (std::uint32_t in = e;;) {
            seen[in / 2] = 1;
            chain.push_back({in / 2, in % 2 == 1});
            const std::uint32_t exit = in ^ 1u, l = link[exit];
            if (l == kNo) break;
            in = links[l].from == exit ? links[l].to : links[l].from;
        }
    }
    return out;
}

} // namespace filum::surfpath
