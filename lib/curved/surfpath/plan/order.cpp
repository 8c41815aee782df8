#include "surfpath/plan/order.hpp"

#include "surface/surface.hpp"

#include <algorithm>
#include <bit>
#include <tuple>

namespace filum::surfpath::plan {

namespace {

using surface::kNone;

// An open end of a chain that can still be linked, and the chain's other end (kNone if that cannot be linked).
struct OpenEnd {
    std::uint32_t end, mate;
};

struct BeamState {
    double cost = 0;
    std::uint32_t parent = kNone;
    std::uint32_t link[2] = {kNone, kNone}; // links of this row's begin and end
};

// The open ends of many states, stored consecutively, with a hash table to find equal states.
class OpenEnds {
  public:
    [[nodiscard]] std::span<const OpenEnd> of(std::size_t state) const {
        return std::span(all_).subspan(begin_[state], begin_[state + 1] - begin_[state]);
    }
    [[nodiscard]] std::size_t states() const { return begin_.size() - 1; }

    // Adds a state; returns false and adds nothing if there is one with the same open ends.
    bool add(std::span<const OpenEnd> open) {
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
    // Index in the table of the state with these open ends, or of the free slot for it.
    [[nodiscard]] std::size_t find(std::span<const OpenEnd> open) const {
        std::uint64_t hash = open.size(); // FNV-1a, word by word
        for (const OpenEnd& o : open) hash = (hash ^ ((std::uint64_t{o.end} << 32) | o.mate)) * 0x100000001b3U;
        const auto same = [](const OpenEnd& a, const OpenEnd& b) { return a.end == b.end && a.mate == b.mate; };
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

    std::vector<OpenEnd> all_;
    std::vector<std::size_t> begin_{0};
    std::vector<std::uint32_t> table_; // states by open addressing; its size is a power of two
};

struct Extension {
    double guess, cost; // lower bound of the total cost; cost so far
    std::uint32_t parent, link[2];
};

struct Cheaper { // a functor, so that the comparison is inlined
    bool operator()(const Extension& a, const Extension& b) const {
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

    // Returns per end its link, kNone if it has none.
    std::vector<std::uint32_t> run() {
        layers_.assign(1, {BeamState{}});
        open_.add({});
        for (std::uint32_t row = 0; row < rows_; ++row) advance(row);
        std::vector<std::uint32_t> out(2 * rows_, kNone);
        std::uint32_t at = 0;
        for (std::uint32_t row = rows_; row > 0; --row) {
            const BeamState& s = layers_[row][at];
            for (const std::uint32_t l : s.link)
                if (l != kNone) out[links_[l].from] = out[links_[l].to] = l;
            at = s.parent;
        }
        return out;
    }

  private:
    static const OpenEnd* find(std::span<const OpenEnd> open, std::uint32_t end) {
        for (const OpenEnd& o : open)
            if (o.end == end) return &o;
        return nullptr;
    }

    // Updates the least cost that each open end will still cause after `row`.
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
        std::vector<BeamState> next;
        next_.clear();
        // Only the first few are needed, so they are sorted in portions of `kept_`.
        for (auto begin = choices_.begin(); begin != choices_.end() && next.size() < kept_;) {
            const auto left = static_cast<std::size_t>(choices_.end() - begin);
            const auto end = begin + static_cast<std::ptrdiff_t>(std::min(kept_, left));
            if (end != choices_.end()) std::nth_element(begin, end, choices_.end(), Cheaper{});
            std::sort(begin, end, Cheaper{});
            for (; begin != end && next.size() < kept_; ++begin) {
                make(open_.of(begin->parent), *begin, row);
                if (next_.add(made_)) next.push_back({begin->cost, begin->parent, {begin->link[0], begin->link[1]}});
            }
        }
        std::swap(open_, next_);
        layers_.push_back(std::move(next));
    }

    void extend(const BeamState& s, std::span<const OpenEnd> open, std::uint32_t parent, std::uint32_t row) {
        double expired = 0, later = 0;     // of ends that can no longer be linked, and of those that still can
        std::uint32_t waiting[2] = {0, 0}; // open ends on either side
        for (const OpenEnd& o : open)
            if (waits(o.end, row)) {
                ++waiting[o.end % 2];
                later += ahead_[o.end];
            } else
                expired += break_;
        find_options(open, 2 * row, row, of_begin_);
        find_options(open, 2 * row + 1, row, of_end_);
        for (const EndOption& a : of_begin_)
            for (const EndOption& b : of_end_) {
                if (a.link != kNone && b.link != kNone && (a.other == b.other || a.mate == b.other)) continue;
                std::uint32_t over[2] = {waiting[0], waiting[1]};
                if (a.waits) over[a.end % 2] += a.link == kNone ? 1u : ~0u;
                if (b.waits) over[b.end % 2] += b.link == kNone ? 1u : ~0u;
                const double cost = s.cost + expired + gap_ * ((over[0] == 0) + (over[1] == 0)) + a.cost + b.cost;
                choices_.push_back({cost + later + a.later + b.later, cost, parent, {a.link, b.link}});
            }
    }

    [[nodiscard]] bool waits(std::uint32_t end, std::uint32_t row) const { return last_[end] > row; }

    // A possibility for one end of a new row: stays open, or is linked to an open end.
    struct EndOption {
        std::uint32_t link, other, end; // the link, the end it leads to, and the end whose state changes
        std::uint32_t mate;             // other end of the linked chain
        bool waits;                     // whether that end counts as waiting
        double cost, later;
    };
    void find_options(std::span<const OpenEnd> open, std::uint32_t end, std::uint32_t row,
                      std::vector<EndOption>& out) const {
        const bool w = waits(end, row);
        out.assign(1, {kNone, kNone, end, kNone, w, w ? 0 : break_, w ? ahead_[end] : 0});
        for (const std::uint32_t l : back_[end])
            if (const OpenEnd* o = find(open, links_[l].from)) {
                const bool waited = waits(o->end, row);
                out.push_back({l, o->end, o->end, o->mate, waited, links_[l].cost - (waited ? 0 : break_),
                               waited ? -ahead_[o->end] : 0});
            }
    }

    // Computes the open ends after an extension.
    void make(std::span<const OpenEnd> open, const Extension& c, std::uint32_t row) {
        made_.assign(open.begin(), open.end());
        made_.push_back({2 * row, 2 * row + 1});
        made_.push_back({2 * row + 1, 2 * row});
        const auto set_mate = [&](std::uint32_t end, std::uint32_t mate) {
            for (OpenEnd& o : made_)
                if (o.end == end) o.mate = mate;
        };
        for (const std::uint32_t l : c.link) {
            if (l == kNone) continue;
            const std::uint32_t a = links_[l].from, b = links_[l].to, ma = find(made_, a)->mate,
                                mb = find(made_, b)->mate;
            if (ma != kNone) set_mate(ma, mb);
            if (mb != kNone) set_mate(mb, ma);
            std::erase_if(made_, [&](const OpenEnd& o) { return o.end == a || o.end == b; });
        }
        for (const OpenEnd& o : made_)
            if (!waits(o.end, row) && o.mate != kNone) set_mate(o.mate, kNone);
        std::erase_if(made_, [&](const OpenEnd& o) { return !waits(o.end, row); });
    }

    std::uint32_t rows_;
    std::span<const Link> links_;
    double break_, gap_;
    std::size_t kept_;
    std::vector<std::vector<std::uint32_t>> back_, forth_; // per end: links to earlier rows, links to later rows
    std::vector<double> ahead_;
    std::vector<std::uint32_t> last_; // per end: the last row to which it can be linked
    std::vector<std::vector<BeamState>> layers_;
    OpenEnds open_, next_; // of the states of the last layer, and of the next one
    std::vector<Extension> choices_;
    std::vector<EndOption> of_begin_, of_end_;
    std::vector<OpenEnd> made_;
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
