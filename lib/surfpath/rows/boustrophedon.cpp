#include "surfpath/rows/boustrophedon.hpp"

#include "surface/curve/walk.hpp"
#include "surfpath/plan/improve.hpp"
#include "surfpath/plan/stagger.hpp"
#include "surfpath/rows/loops.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace filum::surfpath::rows {

namespace {

constexpr double kDepthsApart = 0.25; // spacings, of the depths tried: finer shifts less than a bead covers
constexpr double kBreak = 200;        // mm: as bad as a chain that must be led to another

constexpr std::size_t kBeams[] = {500, 3000, 8000}; // states that the search for an order keeps
constexpr std::size_t kMostWork = 300'000;          // states in all: from where on it is left at what it found

using Chain = std::vector<plan::Visit>;

// Chains as they are laid, and those that are left out.
struct Led {
    std::vector<Chain> chains, left;
};

// A path, and what was done for it.
struct Draft {
    plan::Plan plan;
    std::vector<Chain> left; // of the rows, what is left out
    std::size_t turns = 0;
    double costs = 0, transited = 0, wasted = 0; // mm that turns cost; mm of ways; mm2 by joins of strokes

    // As mm of fibre, by `spacing`: what turns are as bad as, and what ways and joins lay twice and leave bare.
    [[nodiscard]] double added(double spacing) const { return costs + transited + wasted / spacing; }
};

class Path {
  public:
    Path(const Surface& s, const Rows& rows, const Turning& o)
        : surface_(s), rows_(rows), transits_(rows), turner_(s, rows, transits_, o), turns_(turner_.turns()), o_(o) {}

    plan::Plan plan() {
        for (const auto& chains : orders()) {
            Draft led = lay(joined(chains));
            const bool ways = led.transited > 0;
            consider(std::move(led));
            // A chain that comes back to where it began may become a detour of another stroke, for less than a way.
            if (const Led apart = ways ? led_but_loops(chains) : Led{}; !apart.chains.empty()) consider(lay(apart));
        }
        plan::Plan& out = best_->plan;
        leave_out_scraps(out);
        out.facts = {{"", "rows", static_cast<double>(rows_.rows.size()), ""},
                     {"", "turns", static_cast<double>(best_->turns), ""},
                     {"", "transits", best_->transited, "mm"}};
        if (rows_.rows.empty()) out.notes.push_back({NoteCode::surface_too_narrow, surface::area(surface_)});
        if (rows_.drops > 0)
            out.notes.push_back({NoteCode::row_too_short, rows_.dropped * o_.spacing, rows_.drops, -1,
                                 rows_.dropped_at.x, rows_.dropped_at.y, rows_.dropped_at.z});
        if (!best_->left.empty()) tell_left_out(best_->left, out.notes);
        if (out.strokes.size() > 1)
            out.notes.push_back(
                {NoteCode::rows_cut, static_cast<double>(out.strokes.size() - 1), out.strokes.size() - 1});
        return std::move(out);
    }

  private:
    // A stroke shorter than two radii, as rows that are left out for that, is not worth a cut.  The longest stays.
    void leave_out_scraps(plan::Plan& out) const {
        std::vector<double> length;
        for (const plan::Stroke& stroke : out.strokes) {
            length.push_back(0);
            for (const plan::Piece& piece : stroke.pieces) length.back() += surface::curve::length(piece.line);
        }
        const auto longest = std::max_element(length.begin(), length.end()) - length.begin();
        std::vector<plan::Stroke> kept;
        double scraps = 0;
        Vec3 at;
        for (std::size_t i = 0; i < length.size(); ++i) {
            if (length[i] >= 2 * o_.least_radius || static_cast<std::ptrdiff_t>(i) == longest) {
                kept.push_back(std::move(out.strokes[i]));
                continue;
            }
            at = out.strokes[i].pieces[0].line[0];
            scraps += length[i];
        }
        const std::size_t count = length.size() - kept.size();
        out.strokes = std::move(kept);
        if (count > 0)
            out.notes.push_back({NoteCode::stroke_not_worth, scraps * o_.spacing, count, -1, at.x, at.y, at.z});
    }

    void tell_left_out(const std::vector<Chain>& left, Notes& notes) const {
        double all = 0;
        for (const Chain& c : left) all += length(c);
        const Vec3 at = rows_.rows[left[0][0].row].line[0];
        notes.push_back({NoteCode::rows_not_worth, all * o_.spacing, left.size(), -1, at.x, at.y, at.z});
    }

    // Keeps it if it has fewer strokes than what is kept, or as many and adds less.
    void consider(Draft draft) {
        const auto rank = [&](const Draft& d) { return std::pair(d.plan.strokes.size(), d.added(o_.spacing)); };
        if (!best_ || rank(draft) < rank(*best_)) best_ = std::move(draft);
    }

    // Makes strokes of chains.
    [[nodiscard]] Draft lay(const Led& led) const {
        const std::vector<Chain>& chains = led.chains;
        Draft out;
        out.left = led.left;
        std::vector<std::vector<LaidTurn>> turns(chains.size());
        for (std::size_t c = 0; c < chains.size(); ++c)
            for (std::size_t i = 1; i < chains[c].size(); ++i) {
                turns[c].push_back(turn(leave(chains[c][i - 1]), entry(chains[c][i]), out.transited));
                out.costs += turns[c].back().cost;
                ++out.turns;
            }
        if (o_.staggered) stagger(chains, turns);
        for (std::size_t c = 0; c < chains.size(); ++c) out.plan.strokes.push_back(stroke(chains[c], turns[c]));
        const auto joined = join_strokes(surface_, out.plan.strokes,
                                         {.spacing = o_.spacing, .radius = o_.least_radius, .tight = o_.tight});
        out.wasted = joined.waste;
        tell_crossed(joined.crossed, o_.spacing, out.plan.notes);
        return out;
    }

    // The chains led into each other, but for those whose ends lie near enough to each other to be closed; none if
    // there are no such.
    [[nodiscard]] Led led_but_loops(const std::vector<Chain>& chains) const {
        const auto at = [&](std::uint32_t e) {
            const auto& places = rows_.rows[e / 2].line.places;
            return (e % 2 == 0 ? places.front() : places.back()).point;
        };
        std::vector<Chain> open, loops;
        for (const Chain& c : chains) {
            const bool near = distance(at(entry(c.front())), at(leave(c.back()))) <= 2 * o_.least_radius;
            (near ? loops : open).push_back(c);
        }
        if (loops.empty()) return {};
        Led out = joined(std::move(open));
        out.chains.insert(out.chains.end(), loops.begin(), loops.end());
        return out;
    }

    // Orders of the rows to choose from.
    [[nodiscard]] std::vector<std::vector<Chain>> orders() const {
        std::vector<plan::Link> links;
        for (const LaidTurn& t : turns_) links.push_back({t.from, t.to, t.cost});
        const auto n = static_cast<std::uint32_t>(rows_.rows.size());
        const auto row = plan::sweep(n, links);
        std::vector<std::uint32_t> number(n);
        for (std::uint32_t i = 0; i < n; ++i) number[row[i]] = i;
        for (plan::Link& l : links) {
            l.from = 2 * number[l.from / 2] + l.from % 2;
            l.to = 2 * number[l.to / 2] + l.to % 2;
            if (l.from > l.to) std::swap(l.from, l.to);
        }
        // Mostly a narrow beam finds a way with good turns only, or one with few others, that exchanges make good.
        const plan::Costs costs{kBreak, o_.least_radius * o_.least_radius / o_.spacing};
        std::vector<std::vector<Chain>> out;
        for (const std::size_t kept : kBeams) {
            const auto found = order(n, links, costs, kept);
            out = {plan::improved(n, links, costs, kTight, found)};
            if (out[0].size() > 1) out.push_back(found); // its chains may be nearer to each other
            if (good(out[0], links) || kept * n > kMostWork) break;
        }
        for (auto& chains : out)
            for (Chain& chain : chains)
                for (plan::Visit& v : chain) v.row = row[v.row];
        return out;
    }

    // Whether all is one chain without tight turns.  `links` are those of the turns.
    [[nodiscard]] bool good(const std::vector<Chain>& chains, std::span<const plan::Link> links) const {
        if (chains.size() != 1) return false;
        const Chain& c = chains[0];
        for (std::size_t i = 1; i < c.size(); ++i) {
            const std::uint32_t out = leave(c[i - 1]), in = entry(c[i]), a = std::min(out, in), b = std::max(out, in);
            for (std::size_t l = 0; l < links.size(); ++l)
                if (links[l].from == a && links[l].to == b && turns_[l].radius > 0 && links[l].cost >= kTight)
                    return false;
        }
        return true;
    }

    // mm of rows.
    [[nodiscard]] double length(const Chain& chain) const {
        double out = 0;
        for (const auto& v : chain) out += surface::curve::length(rows_.rows[v.row].line);
        return out;
    }

    // Takes out of the order what is not worth the way: where the ways to it and on from it are longer by more than
    // twice its length than the way from before it to behind it.  Ways lie on what is laid, and what is laid twice
    // counts half of what is left bare, as in `choose`.  Most wasteful first.
    void leave_out_detours(std::vector<Turned>& order, const std::vector<Chain>& chains) const {
        const auto end = [&](std::size_t e) {
            return e % 2 == 0 ? entry(chains[e / 2].front()) : leave(chains[e / 2].back());
        };
        const auto in = [](const Turned& t) { return 2 * t.chain + (t.reversed ? 1U : 0U); };
        const auto way = [&](const Turned& a, const Turned& b) { return fibre(end(in(a) ^ 1U), end(in(b))); };
        while (order.size() > 1) {
            double most = 0;
            std::size_t which = order.size();
            for (std::size_t i = 0; i < order.size(); ++i) {
                const bool first = i == 0, last = i + 1 == order.size();
                const double to = first ? 0 : way(order[i - 1], order[i]), on = last ? 0 : way(order[i], order[i + 1]);
                const double past =
                    first || last || std::isinf(to) || std::isinf(on) ? 0 : way(order[i - 1], order[i + 1]);
                const double saved = (std::isinf(to) ? 0 : to) + (std::isinf(on) ? 0 : on) - past;
                if (const double wasted = saved / 2 - length(chains[order[i].chain]); wasted > most) {
                    most = wasted;
                    which = i;
                }
            }
            if (which == order.size()) return;
            order.erase(order.begin() + static_cast<std::ptrdiff_t>(which));
        }
    }

    // The chains led into each other, as far as they hang together.
    [[nodiscard]] Led joined(std::vector<Chain> chains) const {
        const std::size_t n = chains.size();
        const auto end = [&](std::size_t e) {
            return e % 2 == 0 ? entry(chains[e / 2].front()) : leave(chains[e / 2].back());
        };
        std::vector<std::vector<double>> length(2 * n, std::vector<double>(2 * n));
        for (std::size_t e = 0; e < 2 * n; ++e)
            for (std::size_t f = 0; f < 2 * n; ++f)
                if (e / 2 != f / 2) length[e][f] = way_length(end(e), end(f));
        auto turned = tour(length);
        leave_out_detours(turned, chains);
        Led led;
        std::vector<Chain>& out = led.chains;
        std::vector<char> kept(n, 0);
        std::size_t before = 2 * n;
        for (const Turned& t : turned) {
            kept[t.chain] = 1;
            Chain& now = chains[t.chain];
            const std::size_t in = 2 * t.chain + (t.reversed ? 1 : 0);
            if (t.reversed) {
                std::reverse(now.begin(), now.end());
                for (plan::Visit& v : now) v.reversed = !v.reversed;
            }
            if (before < 2 * n && std::isfinite(length[before][in]))
                out.back().insert(out.back().end(), now.begin(), now.end());
            else
                out.push_back(std::move(now));
            before = in ^ 1u;
        }
        for (std::size_t c = 0; c < n; ++c)
            if (kept[c] == 0) led.left.push_back(std::move(chains[c]));
        return led;
    }

    // Of the way that leads from one end to another, mm of fibre; infinite if none does.
    [[nodiscard]] double fibre(std::uint32_t from, std::uint32_t to) const {
        const double l = transits_.length(from, to);
        return l <= o_.along ? l : way_length(from, to) - kBreak;
    }

    // The way along rims and rows, or where there is none, as between spirals, straight across, which crosses what lies
    // there and so counts for more; mm.
    [[nodiscard]] double way_length(std::uint32_t from, std::uint32_t to) const {
        const double l = transits_.length(from, to);
        if (l <= o_.along) return l;
        const Line line = across(from, to);
        const double straight = surface::curve::length(line);
        return line.size() > 1 && straight <= o_.across ? kBreak + straight : std::numeric_limits<double>::infinity();
    }

    // Straight across the surface from one end to another; empty if that does not lead there.
    [[nodiscard]] Line across(std::uint32_t from, std::uint32_t to) const {
        const auto place = [&](std::uint32_t e) {
            const auto& places = rows_.rows[e / 2].line.places;
            return e % 2 == 0 ? places.front() : places.back();
        };
        const Place a = place(from), b = place(to);
        Line out = surface::curve::join(surface_, a, b);
        return out.size() > 2 || a.triangle == b.triangle ? out : Line{};
    }

    // The turn from one end to another, or a way, whose length counts to `transited`.
    [[nodiscard]] LaidTurn turn(std::uint32_t from, std::uint32_t to, double& transited) const {
        const auto [a, b] = std::minmax(from, to);
        const auto it = std::lower_bound(turns_.begin(), turns_.end(), std::pair(a, b),
                                         [](const LaidTurn& t, auto& k) { return std::pair(t.from, t.to) < k; });
        const bool known = it != turns_.end() && it->from == a && it->to == b;
        if (known && it->line.size() > 1) {
            LaidTurn out = *it;
            if (from != a) turn_round(out);
            return out;
        }
        const auto way = transits_.way(from, to);
        const auto stretches = known                            ? std::vector<Line>{transits_.along(from, to)}
                               : way && way->length <= o_.along ? way->stretches
                                                                : std::vector<Line>{across(from, to)};
        for (const Line& l : stretches) transited += surface::curve::length(l);
        LaidTurn out = turner_.eased(from, stretches, to);
        out.eased = true;
        return out;
    }

    // A turn with what a deeper one replaces of its rows.
    [[nodiscard]] plan::Stroke with_rows(const LaidTurn& t, double from_deepest, double to_deepest) const {
        plan::Stroke out;
        if (t.from_trim < from_deepest) out.pieces.push_back({turner_.part(t.from, t.from_trim, from_deepest), false});
        out.pieces.push_back({t.line, false});
        if (t.to_trim < to_deepest) out.pieces.push_back({turner_.part(t.to, t.to_trim, to_deepest), false});
        return out;
    }

    // Puts turns deeper behind the rim where that lays less twice, all of all chains together.
    void stagger(const std::vector<Chain>& chains, std::vector<std::vector<LaidTurn>>& turns) const {
        std::vector<LaidTurn*> which;
        std::vector<std::vector<LaidTurn>> laid;
        std::vector<plan::Depths> depths;
        auto deepest = turns;
        for (std::size_t c = 0; c < turns.size(); ++c)
            for (std::size_t i = 0; i < turns[c].size(); ++i) {
                if (turns[c][i].eased) continue;
                which.push_back(&turns[c][i]);
                laid.push_back(turner_.deeper(turns[c][i], kDepthsApart * o_.spacing));
                LaidTurn& most = deepest[c][i];
                most.line = {};
                for (const LaidTurn& t : laid.back()) {
                    most.from_trim = std::max(most.from_trim, t.from_trim);
                    most.to_trim = std::max(most.to_trim, t.to_trim);
                }
                plan::Depths& now = depths.emplace_back();
                for (const LaidTurn& t : laid.back()) now.push_back(with_rows(t, most.from_trim, most.to_trim));
            }
        plan::Plan fixed;
        for (std::size_t c = 0; c < chains.size(); ++c) fixed.strokes.push_back(stroke(chains[c], deepest[c]));
        const auto chosen = plan::staggered(surface_, fixed, depths, o_.spacing);
        for (std::size_t i = 0; i < which.size(); ++i) *which[i] = std::move(laid[i][chosen[i]]);
    }

    // The rows of a chain with the turns between them, but for those without a line.
    [[nodiscard]] plan::Stroke stroke(const Chain& chain, const std::vector<LaidTurn>& turns) const {
        plan::Stroke out;
        double off = 0;
        for (std::size_t i = 0; i < chain.size(); ++i) {
            const bool last = i + 1 == chain.size();
            const double end = last ? 0 : turns[i].from_trim;
            if (Line row = turner_.stretch(entry(chain[i]), off, end); row.size() > 1)
                out.pieces.push_back({std::move(row), false});
            if (last) break;
            off = turns[i].to_trim;
            if (turns[i].line.size() > 1) out.pieces.push_back({turns[i].line, false});
        }
        return out;
    }

    const Surface& surface_;
    const Rows& rows_;
    Transits transits_;
    Turner turner_;
    std::vector<LaidTurn> turns_;
    Turning o_;
    std::optional<Draft> best_;
};

} // namespace

plan::Plan boustrophedon(const Surface& s, const Rows& rows, const Turning& o) { return Path(s, rows, o).plan(); }

} // namespace filum::surfpath::rows
