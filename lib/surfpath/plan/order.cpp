#include "surfpath/plan/order.hpp"

#include "surface/surface.hpp"

#include <algorithm>
#include <bit>
#include <tuple>

namespace filum::surfpath::plan {

namespace {

using surface::kNone;

// An open end of a chain that may still be linked, and the chain's other end; kNone if that may not.
struct Open {
    std::uint32_t end, mate;
};

struct State {
    double cost = 0;
    std::uint32_t parent = kNone;
    std::uint32_t link[2] = {kNone, kNone}; // made with this row's begin and end
};

// The open ends of each of many states, by end, one state's behind the other's.
class OpenEnds {
  public:
    [[nodiscard]] std::span<const Open> of(std::size_t state) const {
        return std::span(all_).subspan(begin_[state], begin_[state + 1] - begin_[state]);
    }
    [[nodiscard]] std::size_t states() const { return begin_.size() - 1; }

    // Adds a state; false, and adds none, if one with the same open ends is there.
    bool add(std::span<const Open> open) {
        if (2 * states() >= table_.size()) grow();
        std::uint32_t& place = table_[find(open)];
        if (place != kNone) return false;
        place = static_cast<std::uint32_t>(states());
        all_.insert(all_.end(), open.begin(), open.end());
        begin_.push_back(all_.size());
        return true;
    }
    void clear() {
        all_.clear();
        begin_.assign(1, 0);
        std::fill(table_.begin(), table_.end(), kNone);
    }

  private:
    // Where the state with these open ends stands in the table, or would.
    [[nodiscard]] std::size_t find(std::span<const Open> open) const {
        std::uint64_t hash = open.size(); // FNV, by words
        for (const Open& o : open) hash = (hash ^ ((std::uint64_t{o.end} << 32) | o.mate)) * 0x100000001b3U;
        const auto same = [](const Open& a, const Open& b) { return a.end == b.end && a.mate == b.mate; };
        std::size_t at = (hash ^ (hash >> 32)) & (table_.size() - 1);
        for (; table_[at] != kNone; at = (at + 1) & (table_.size() - 1)) {
            const auto other = of(table_[at]);
            if (std::equal(open.begin(), open.end(), other.begin(), other.end(), same)) break;
        }
        return at;
    }
    void grow() {
        table_.assign(std::max<std::size_t>(16, 4 * states()), kNone);
        table_.resize(std::bit_ceil(table_.size()), kNone);
        for (std::uint32_t k = 0; k < states(); ++k) table_[find(of(k))] = k;
    }

    std::vector<Open> all_;
    std::vector<std::size_t> begin_{0};
    std::vector<std::uint32_t> table_; // of states, by open addressing; a power of two
};

struct Choice {
    double guess, cost; // of the whole, so far
    std::uint32_t parent, link[2];
};

struct Before { // no function, as it shall be called in place
    bool operator()(const Choice& a, const Choice& b) const {
        if (a.guess != b.guess) return a.guess < b.guess;
        return std::tuple(a.parent, a.link[0], a.link[1]) < std::tuple(b.parent, b.link[0], b.link[1]);
    }
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
        open_.add({});
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
    static const Open* find(std::span<const Open> open, std::uint32_t end) {
        for (const Open& o : open)
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
        choices_.clear();
        const std::size_t count = open_.states();
        for (std::uint32_t p = 0; p < count; ++p) extend(layers_.back()[p], open_.of(p), p, row);
        std::vector<State> next;
        next_.clear();
        // Only the first few are wanted: sorted by and by, as many at a time as are kept.
        for (auto begin = choices_.begin(); begin != choices_.end() && next.size() < kept_;) {
            const auto left = static_cast<std::size_t>(choices_.end() - begin);
            const auto end = begin + static_cast<std::ptrdiff_t>(std::min(kept_, left));
            if (end != choices_.end()) std::nth_element(begin, end, choices_.end(), Before{});
            std::sort(begin, end, Before{});
            for (; begin != end && next.size() < kept_; ++begin) {
                make(open_.of(begin->parent), *begin, row);
                if (next_.add(made_)) next.push_back({begin->cost, begin->parent, {begin->link[0], begin->link[1]}});
            }
        }
        std::swap(open_, next_);
        layers_.push_back(std::move(next));
    }

    void extend(const State& s, std::span<const Open> open, std::uint32_t parent, std::uint32_t row) {
        double expired = 0, later = 0;     // cost of ends that were not linked in time, and of those that still wait
        std::uint32_t waiting[2] = {0, 0}; // on either side
        for (const Open& o : open)
            if (waits(o.end, row)) {
                ++waiting[o.end % 2];
                later += ahead_[o.end];
            } else
                expired += break_;
        find_options(open, 2 * row, row, of_begin_);
        find_options(open, 2 * row + 1, row, of_end_);
        for (const Option& a : of_begin_)
            for (const Option& b : of_end_) {
                if (a.link != kNone && b.link != kNone && (a.other == b.other || a.mate == b.other)) continue;
                std::uint32_t over[2] = {waiting[0], waiting[1]};
                if (a.waits) over[a.end % 2] += a.link == kNone ? 1u : ~0u;
                if (b.waits) over[b.end % 2] += b.link == kNone ? 1u : ~0u;
                const double cost = s.cost + expired + gap_ * ((over[0] == 0) + (over[1] == 0)) + a.cost + b.cost;
                choices_.push_back({cost + later + a.later + b.later, cost, parent, {a.link, b.link}});
            }
    }

    [[nodiscard]] bool waits(std::uint32_t end, std::uint32_t row) const { return last_[end] > row; }

    // What may be done with one end of a new row: left open, or linked to an open one.
    struct Option {
        std::uint32_t link, other, end; // the link, what it leads to, the end that is open no more, or newly
        std::uint32_t mate;             // of what it leads to
        bool waits;                     // whether that one counts among those that wait
        double cost, later;
    };
    void find_options(std::span<const Open> open, std::uint32_t end, std::uint32_t row,
                      std::vector<Option>& out) const {
        const bool w = waits(end, row);
        out.assign(1, {kNone, kNone, end, kNone, w, w ? 0 : break_, w ? ahead_[end] : 0});
        for (const std::uint32_t l : back_[end])
            if (const Open* o = find(open, links_[l].from)) {
                const bool waited = waits(o->end, row);
                out.push_back({l, o->end, o->end, o->mate, waited, links_[l].cost - (waited ? 0 : break_),
                               waited ? -ahead_[o->end] : 0});
            }
    }

    // Makes the open ends that a choice leaves.
    void make(std::span<const Open> open, const Choice& c, std::uint32_t row) {
        made_.assign(open.begin(), open.end());
        made_.push_back({2 * row, 2 * row + 1});
        made_.push_back({2 * row + 1, 2 * row});
        const auto set_mate = [&](std::uint32_t end, std::uint32_t mate) {
            for (Open& o : made_)
                if (o.end == end) o.mate = mate;
        };
        for (const std::uint32_t l : c.link) {
            if (l == kNone) continue;
            const std::uint32_t a = links_[l].from, b = links_[l].to, ma = find(made_, a)->mate,
                                mb = find(made_, b)->mate;
            if (ma != kNone) set_mate(ma, mb);
            if (mb != kNone) set_mate(mb, ma);
            std::erase_if(made_, [&](const Open& o) { return o.end == a || o.end == b; });
        }
        for (const Open& o : made_)
            if (!waits(o.end, row) && o.mate != kNone) set_mate(o.mate, kNone);
        std::erase_if(made_, [&](const Open& o) { return !waits(o.end, row); });
    }

    std::uint32_t rows_;
    std::span<const Link> links_;
    double break_, gap_;
    std::size_t kept_;
    std::vector<std::vector<std::uint32_t>> back_, forth_; // per end: links to rows before, to rows behind
    std::vector<double> ahead_;
    std::vector<std::uint32_t> last_; // per end: the last row that it may be linked to
    std::vector<std::vector<State>> layers_;
    OpenEnds open_, next_; // of the last layer's states, and of those that are to come
    std::vector<Choice> choices_;
    std::vector<Option> of_begin_, of_end_;
    std::vector<Open> made_;
};

} // namespace

std::vector<std::vector<Visit>> chains(std::span<const Link> links, std::span<const std::uint32_t> link) {
    std::vector<std::vector<Visit>> out;
    std::vector<char> seen(link.size() / 2, 0);
    for (std::uint32_t e = 0; e < link.size(); ++e) {
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

std::vector<std::vector<Visit>> order(std::uint32_t rows, std::span<const Link> links, const Costs& costs,
                                      std::size_t kept) {
    return chains(links, Beam(rows, links, costs, kept).run());
}

} // namespace filum::surfpath::plan
