#include "surfpath/plan/improve.hpp"

#include "surface/surface.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>

namespace filum::surfpath::plan {

namespace {

using surface::kNone;

constexpr std::size_t kDeepest = 6; // links exchanged at once; one more takes about ten times as long

// Per end of a row its link, kNone if it has none.
using Linked = std::vector<std::uint32_t>;

class LinkSearch {
  public:
    LinkSearch(std::uint32_t rows, std::span<const Link> links, const Costs& costs)
        : rows_(rows), links_(links), costs_(costs), of_(2 * rows) {
        for (std::uint32_t l = 0; l < links.size(); ++l) {
            of_[links[l].from].push_back(l);
            of_[links[l].to].push_back(l);
        }
        for (auto& all : of_)
            std::stable_sort(all.begin(), all.end(), [&](auto a, auto b) { return links[a].cost < links[b].cost; });
    }

    [[nodiscard]] Linked linked(const std::vector<std::vector<Visit>>& chains) const {
        Linked out(2 * rows_, kNone);
        for (const auto& chain : chains)
            for (std::size_t i = 1; i < chain.size(); ++i) {
                const std::uint32_t a = leave(chain[i - 1]), b = entry(chain[i]);
                for (const std::uint32_t l : of_[a])
                    if (other(l, a) == b) out[a] = out[b] = l;
            }
        return out;
    }

    [[nodiscard]] double cost(const Linked& now) const {
        double sum = 0;
        // links across each row on either side, as differences
        std::vector<int> over[2] = {std::vector<int>(rows_, 0), std::vector<int>(rows_, 0)};
        for (std::uint32_t e = 0; e < now.size(); ++e) {
            if (now[e] == kNone) {
                sum += costs_.breaks / 2;
                continue;
            }
            const Link& l = links_[now[e]];
            if (e != l.from) continue;
            sum += l.cost;
            ++over[l.from % 2][l.from / 2];
            --over[l.from % 2][l.to / 2];
        }
        for (const auto& side : over) {
            int across = 0;
            for (const int more : side) sum += (across += more) == 0 ? costs_.gap : 0;
        }
        return sum;
    }

    // exchange() replaces a link by others, join() links an open end. Both return false and leave `now` as it is if
    // the cost does not fall. Each examines at most `most` rows per end.
    bool exchange(Linked& now, std::uint32_t link, std::uint64_t most) {
        Linked trial = now;
        take_out(trial, link);
        const bool from = improve_from(now, trial, links_[link].from, links_[link].cost, most);
        return from || improve_from(now, trial, links_[link].to, links_[link].cost, most);
    }
    bool join(Linked& now, std::uint32_t end, std::uint64_t most) {
        Linked trial = now;
        return improve_from(now, trial, end, costs_.breaks, most);
    }

  private:
    [[nodiscard]] std::uint32_t other(std::uint32_t link, std::uint32_t end) const {
        return links_[link].from == end ? links_[link].to : links_[link].from;
    }
    void take_out(Linked& now, std::uint32_t link) const { now[links_[link].from] = now[links_[link].to] = kNone; }
    void put_in(Linked& now, std::uint32_t link) const { now[links_[link].from] = now[links_[link].to] = link; }

    // Whether the chain from its open end `e` leaves one of its rows by the end `by`.
    [[nodiscard]] bool leaves(const Linked& now, std::uint32_t e, std::uint32_t by) {
        for (std::uint32_t in = e;;) {
            look(1);
            const std::uint32_t out = in ^ 1U;
            if (out == by) return true;
            if (now[out] == kNone) return false;
            in = other(now[out], out);
        }
    }

    // Sets `now` to the best state found from the open end of `trial`; false if none is better than `now`.
    bool improve_from(Linked& now, Linked& trial, std::uint32_t end, double saved, std::uint64_t most) {
        best_ = now;
        const double before = least_ = cost(now) - rules::kRounding;
        left_ = most;
        search(trial, end, saved);
        std::swap(now, best_);
        return least_ < before;
    }

    // Searches from the open end `e`. `saved`: cost of removed links minus cost of added ones.
    void search(Linked& now, std::uint32_t e, double saved) {
        if (left_ == 0) return;
        keep(now);
        if (put_in_.size() == kDeepest) return;
        for (const std::uint32_t l : of_[e]) {
            const double left = saved - links_[l].cost;
            if (left <= 0) return; // links are sorted by cost
            const std::uint32_t u = other(l, e), out = now[u];
            if (u == (e ^ 1U) || std::count(put_in_.begin(), put_in_.end(), out) > 0) continue;
            if (leaves(now, e, u)) continue; // the link would close the chain
            if (out != kNone) take_out(now, out);
            put_in(now, l);
            put_in_.push_back(l);
            if (out == kNone)
                keep(now);
            else
                search(now, other(out, u), left + links_[out].cost);
            put_in_.pop_back();
            take_out(now, l);
            if (out != kNone) put_in(now, out);
        }
    }

    void keep(const Linked& now) {
        look(rows_);
        if (const double c = cost(now); c < least_) {
            least_ = c - rules::kRounding;
            best_ = now;
        }
    }

    void look(std::uint64_t rows) { left_ -= std::min(left_, rows); }

    std::uint32_t rows_;
    std::span<const Link> links_;
    Costs costs_;
    std::vector<std::vector<std::uint32_t>> of_; // per end its links, cheapest first
    Linked best_;
    double least_ = 0;
    std::vector<std::uint32_t> put_in_;
    std::uint64_t left_ = 0; // number of rows that may still be examined
};

} // namespace

std::vector<std::vector<Visit>> improved(std::uint32_t rows, std::span<const Link> links, const Costs& costs,
                                         double dear, std::vector<std::vector<Visit>> given) {
    LinkSearch all(rows, links, costs);
    Linked now = all.linked(given);
    const auto is_dear = [&](std::uint32_t l) { return now[links[l].from] == l && links[l].cost >= dear; };
    const auto is_open = [&](std::uint32_t e) { return given.size() > 1 && now[e] == kNone; };
    std::uint64_t searches = given.size() > 1 ? 2 * given.size() : 0;
    for (std::uint32_t l = 0; l < links.size(); ++l) searches += is_dear(l) ? 2 : 0;
    for (bool again = searches > 0; again;) {
        again = false;
        for (std::uint32_t l = 0; l < links.size(); ++l)
            again = (is_dear(l) && all.exchange(now, l, rules::kMostSteps / searches)) || again;
        for (std::uint32_t e = 0; e < now.size(); ++e)
            again = (is_open(e) && all.join(now, e, rules::kMostSteps / searches)) || again;
    }
    return searches > 0 ? chains(links, now) : std::move(given);
}

} // namespace filum::surfpath::plan
