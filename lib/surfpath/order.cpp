#include "surfpath/order.hpp"

#include "surface/surface.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <unordered_set>

namespace filum::surfpath {

namespace {

using surface::kNone;

// An open end of a chain that may still be linked, and the chain's other end; kNone if that may not.
struct Open {
    std::uint32_t end, mate;
};

struct State {
    std::vector<Open> open; // by end
    double cost = 0;
    std::uint32_t parent = kNone;
    std::uint32_t link[2] = {kNone, kNone}; // made with this row's begin and end
};

struct Choice {
    double guess, cost; // of the whole, so far
    std::uint32_t parent, link[2];
};

class Beam {
  public:
    Beam(std::uint32_t rows, std::span<const Link> links, const Costs& costs, std::size_t kept)
        : rows_(rows), links_(links), break_(costs.breaks / 2), gap_(costs.gap), kept_(kept), back_(2 * rows),
          forth_(2 * rows), ahead_(2 * rows, 0), last_(2 * rows, 0) {
        for (std::uint32_t i = 0; i < links.size(); ++i) {
            back_[links[i].to].push_back(i);
            forth_[links[i].from].push_back(i);
            last_[links[i].from] = std::max(last_[links[i].from], links[i].to / 2);
        }
        for (std::uint32_t e = 0; e < 2 * rows; ++e) last_[e] = std::max(last_[e], e / 2);
    }

    // Per end the link that it has, kNone if none.
    std::vector<std::uint32_t> run() {
        layers_.assign(1, {State{}});
        for (std::uint32_t row = 0; row < rows_; ++row) advance(row);
        std::vector<std::uint32_t> out(2 * rows_, kNone);
        std::uint32_t at = 0;
        for (std::uint32_t row = rows_; row > 0; --row) {
            const State& s = layers_[row][at];
            for (const std::uint32_t l : s.link)
                if (l != kNone) out[links_[l].from] = out[links_[l].to] = l;
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

    // What an open end behind `row` will cost at least.
    void look_ahead(std::uint32_t row) {
        for (std::uint32_t e = 0; e < 2 * row + 2; ++e) {
            if (last_[e] <= row) continue;
            ahead_[e] = break_;
            for (const std::uint32_t l : forth_[e])
                if (links_[l].to / 2 > row) ahead_[e] = std::min(ahead_[e], links_[l].cost);
        }
    }

    void advance(std::uint32_t row) {
        look_ahead(row);
        std::vector<Choice> choices;
        const auto& from = layers_.back();
        for (std::uint32_t p = 0; p < from.size(); ++p) extend(from[p], p, row, choices);
        // A heap, as only the first few are wanted; which come first does not depend on how it is built.
        const auto behind = [](const Choice& a, const Choice& b) {
            return std::tuple(a.guess, a.parent, a.link[0], a.link[1]) >
                   std::tuple(b.guess, b.parent, b.link[0], b.link[1]);
        };
        std::make_heap(choices.begin(), choices.end(), behind);
        std::vector<State> next;
        std::unordered_set<std::string> seen;
        while (!choices.empty() && next.size() < kept_) {
            std::pop_heap(choices.begin(), choices.end(), behind);
            const Choice c = choices.back();
            choices.pop_back();
            State s = made(from[c.parent], c, row);
            std::string key(reinterpret_cast<const char*>(s.open.data()), s.open.size() * sizeof(Open));
            if (!seen.insert(std::move(key)).second) continue;
            next.push_back(std::move(s));
        }
        for (State& s : layers_.back()) s.open = {};
        layers_.push_back(std::move(next));
    }

    void extend(const State& s, std::uint32_t parent, std::uint32_t row, std::vector<Choice>& out) const {
        double expired = 0, later = 0;     // cost of ends that were not linked in time, and of those that still wait
        std::uint32_t waiting[2] = {0, 0}; // on either side
        for (const Open& o : s.open)
            if (waits(o.end, row)) {
                ++waiting[o.end % 2];
                later += ahead_[o.end];
            } else
                expired += break_;
        const auto first = options(s, 2 * row, row), second = options(s, 2 * row + 1, row);
        for (const Option& a : first)
            for (const Option& b : second) {
                if (a.link != kNone && b.link != kNone && (a.other == b.other || find(s, a.other)->mate == b.other))
                    continue;
                std::uint32_t over[2] = {waiting[0], waiting[1]};
                if (a.waits) over[a.end % 2] += a.link == kNone ? 1u : ~0u;
                if (b.waits) over[b.end % 2] += b.link == kNone ? 1u : ~0u;
                const double cost = s.cost + expired + gap_ * ((over[0] == 0) + (over[1] == 0)) + a.cost + b.cost;
                out.push_back({cost + later + a.later + b.later, cost, parent, {a.link, b.link}});
            }
    }

    [[nodiscard]] bool waits(std::uint32_t end, std::uint32_t row) const { return last_[end] > row; }

    // What may be done with one end of a new row: left open, or linked to an open one.
    struct Option {
        std::uint32_t link, other, end; // the link, what it leads to, the end that is open no more, or newly
        bool waits;                     // whether that one counts among those that wait
        double cost, later;
    };
    [[nodiscard]] std::vector<Option> options(const State& s, std::uint32_t end, std::uint32_t row) const {
        const bool w = waits(end, row);
        std::vector<Option> out{{kNone, kNone, end, w, w ? 0 : break_, w ? ahead_[end] : 0}};
        for (const std::uint32_t l : back_[end])
            if (const Open* o = find(s, links_[l].from)) {
                const bool waited = waits(o->end, row);
                out.push_back(
                    {l, o->end, o->end, waited, links_[l].cost - (waited ? 0 : break_), waited ? -ahead_[o->end] : 0});
            }
        return out;
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
            if (l == kNone) continue;
            const std::uint32_t a = links_[l].from, b = links_[l].to, ma = find(out, a)->mate, mb = find(out, b)->mate;
            if (ma != kNone) set_mate(ma, mb);
            if (mb != kNone) set_mate(mb, ma);
            remove(a);
            remove(b);
        }
        for (std::size_t i = 0; i < out.open.size();) {
            const Open o = out.open[i];
            if (last_[o.end] > row) {
                ++i;
                continue;
            }
            if (o.mate != kNone) set_mate(o.mate, kNone);
            remove(o.end);
        }
        return out;
    }

    std::uint32_t rows_;
    std::span<const Link> links_;
    double break_, gap_;
    std::size_t kept_;
    std::vector<std::vector<std::uint32_t>> back_, forth_; // per end: links to rows before, to rows behind
    std::vector<double> ahead_;
    std::vector<std::uint32_t> last_; // per end: the last row that it may be linked to
    std::vector<std::vector<State>> layers_;
};

} // namespace

std::vector<std::vector<Visit>> order(std::uint32_t rows, std::span<const Link> links, const Costs& costs,
                                      std::size_t kept) {
    const auto link = Beam(rows, links, costs, kept).run();
    std::vector<std::vector<Visit>> out;
    std::vector<char> seen(rows, 0);
    for (std::uint32_t e = 0; e < 2 * rows; ++e) {
        if (link[e] != kNone || seen[e / 2]) continue;
        auto& chain = out.emplace_back();
        for (std::uint32_t in = e;;) {
            seen[in / 2] = 1;
            chain.push_back({in / 2, in % 2 == 1});
            const std::uint32_t exit = in ^ 1u, l = link[exit];
            if (l == kNone) break;
            in = links[l].from == exit ? links[l].to : links[l].from;
        }
    }
    return out;
}

} // namespace filum::surfpath
