#include "surfpath/rows/boustrophedon.hpp"

#include "surface/curve/walk.hpp"
#include "surfpath/plan/improve.hpp"
#include "surfpath/plan/stagger.hpp"
#include "surfpath/rows/loops.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace filum::surfpath::rows {

namespace {

constexpr std::size_t kBeams[] = {500, 3000, 8000}; // widths of the beam search for an order of rows, tried in turn
constexpr std::size_t kMostWork = 300'000;          // states in total after which no wider beam is tried

using RowChain = std::vector<plan::Visit>;

// Chains that become strokes, and chains that are left out.
struct ChainSet {
    std::vector<RowChain> chains, left;
};

// A possible path with its costs.
struct CandidatePath {
    plan::Plan plan;
    std::vector<RowChain> left; // rows that are left out
    std::size_t turns = 0;
    double costs = 0, transited = 0, wasted = 0; // mm that turns cost; mm of transits; mm2 wasted by joins of strokes

    // Additional fibre in mm: the costs of turns, transits, and the voids and overlap of joins.
    [[nodiscard]] double added(double spacing) const { return costs + transited + wasted / spacing; }
};

class RowPathPlanner {
  public:
    RowPathPlanner(const Surface& s, const Rows& rows, const TurnOptions& o)
        : surface_(s), rows_(rows), transits_(rows), turner_(s, rows, transits_, o), turns_(turner_.candidates()),
          o_(o) {
        for (const SurfaceTurn& t : turns_) break_ += t.cost;
    }

    plan::Plan plan() {
        for (const auto& chains : orders()) {
            CandidatePath connected = draft(joined(chains));
            const bool ways = connected.transited > 0;
            consider(std::move(connected));
            // A chain that returns to its start may become a detour of another stroke, which is cheaper than a transit.
            if (const ChainSet apart = ways ? joined_without_loops(chains) : ChainSet{}; !apart.chains.empty())
                consider(draft(apart));
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
        if (!best_->left.empty()) report_left_out(best_->left, out.notes);
        if (out.strokes.size() > 1)
            out.notes.push_back(
                {NoteCode::rows_cut, static_cast<double>(out.strokes.size() - 1), out.strokes.size() - 1});
        return std::move(out);
    }

  private:
    // Leaves out strokes shorter than two radii, which are not worth a cut, except the longest stroke.
    void leave_out_scraps(plan::Plan& out) const {
        std::vector<double> length;
        for (const plan::Stroke& stroke : out.strokes) {
            length.push_back(0);
            for (const plan::Section& piece : stroke.sections) length.back() += surface::curve::length(piece.line);
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
            at = out.strokes[i].sections[0].line[0];
            scraps += length[i];
        }
        const std::size_t count = length.size() - kept.size();
        out.strokes = std::move(kept);
        if (count > 0)
            out.notes.push_back({NoteCode::stroke_not_worth, scraps * o_.spacing, count, -1, at.x, at.y, at.z});
    }

    void report_left_out(const std::vector<RowChain>& left, Notes& notes) const {
        double all = 0;
        for (const RowChain& c : left) all += length(c);
        const Vec3 at = rows_.rows[left[0][0].row].line[0];
        notes.push_back({NoteCode::rows_not_worth, all * o_.spacing, left.size(), -1, at.x, at.y, at.z});
    }

    // Keeps the candidate if it has fewer strokes than the best one, or as many strokes and less additional fibre.
    void consider(CandidatePath draft) {
        const auto rank = [&](const CandidatePath& d) { return std::pair(d.plan.strokes.size(), d.added(o_.spacing)); };
        if (!best_ || rank(draft) < rank(*best_)) best_ = std::move(draft);
    }

    // Makes a stroke of every chain.
    [[nodiscard]] CandidatePath draft(const ChainSet& set) const {
        const std::vector<RowChain>& chains = set.chains;
        CandidatePath out;
        out.left = set.left;
        std::vector<std::vector<SurfaceTurn>> turns(chains.size());
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
        report_crossings(joined.crossed, o_.spacing, out.plan.notes);
        return out;
    }

    // Connects the chains, except those whose ends are near enough to each other to be closed; empty if there are none
    // of these.
    [[nodiscard]] ChainSet joined_without_loops(const std::vector<RowChain>& chains) const {
        const auto at = [&](std::uint32_t e) {
            const auto& places = rows_.rows[e / 2].line.places;
            return (e % 2 == 0 ? places.front() : places.back()).point;
        };
        std::vector<RowChain> open, loops;
        for (const RowChain& c : chains) {
            const bool near = distance(at(entry(c.front())), at(leave(c.back()))) <= 2 * o_.least_radius;
            (near ? loops : open).push_back(c);
        }
        if (loops.empty()) return {};
        ChainSet out = joined(std::move(open));
        out.chains.insert(out.chains.end(), loops.begin(), loops.end());
        return out;
    }

    // The orders of rows from which the best is chosen.
    [[nodiscard]] std::vector<std::vector<RowChain>> orders() const {
        std::vector<plan::Link> links;
        for (const SurfaceTurn& t : turns_) links.push_back({t.from, t.to, t.cost});
        const auto n = static_cast<std::uint32_t>(rows_.rows.size());
        const auto row = plan::sweep(n, links);
        std::vector<std::uint32_t> number(n);
        for (std::uint32_t i = 0; i < n; ++i) number[row[i]] = i;
        for (plan::Link& l : links) {
            l.from = 2 * number[l.from / 2] + l.from % 2;
            l.to = 2 * number[l.to / 2] + l.to % 2;
            if (l.from > l.to) std::swap(l.from, l.to);
        }
        // A narrow beam usually finds an order with good turns only, or with a few bad ones that exchanges remove.
        const plan::Costs costs{break_, o_.least_radius * o_.least_radius / o_.spacing};
        std::vector<std::vector<RowChain>> out;
        for (const std::size_t kept : kBeams) {
            const auto found = order(n, links, costs, kept);
            out = {plan::improved(n, links, costs, kTightCosts, found)};
            if (out[0].size() > 1) out.push_back(found); // its chains may be nearer to each other
            if (good(out[0], links) || kept * n > kMostWork) break;
        }
        for (auto& chains : out)
            for (RowChain& chain : chains)
                for (plan::Visit& v : chain) v.row = row[v.row];
        return out;
    }

    // Whether the order is a single chain without tight turns. `links` are those of turns_.
    [[nodiscard]] bool good(const std::vector<RowChain>& chains, std::span<const plan::Link> links) const {
        if (chains.size() != 1) return false;
        const RowChain& c = chains[0];
        for (std::size_t i = 1; i < c.size(); ++i) {
            const std::uint32_t out = leave(c[i - 1]), in = entry(c[i]), a = std::min(out, in), b = std::max(out, in);
            for (std::size_t l = 0; l < links.size(); ++l)
                if (links[l].from == a && links[l].to == b && turns_[l].radius > 0 && links[l].cost >= kTightCosts)
                    return false;
        }
        return true;
    }

    // Length of the chain's rows, mm.
    [[nodiscard]] double length(const RowChain& chain) const {
        double out = 0;
        for (const auto& v : chain) out += surface::curve::length(rows_.rows[v.row].line);
        return out;
    }

    // Removes chains that are not worth their transits: those for which the transits to it and from it, less the
    // transit that would replace both, exceed twice its length. Transits overlap other lines, and overlap counts half
    // as much as void, as in `choose`. The most wasteful chain is removed first.
    void leave_out_detours(std::vector<OrientedChain>& order, const std::vector<RowChain>& chains) const {
        const auto end = [&](std::size_t e) {
            return e % 2 == 0 ? entry(chains[e / 2].front()) : leave(chains[e / 2].back());
        };
        const auto in = [](const OrientedChain& t) { return 2 * t.chain + (t.reversed ? 1U : 0U); };
        const auto way = [&](const OrientedChain& a, const OrientedChain& b) {
            return fibre(end(in(a) ^ 1U), end(in(b)));
        };
        while (order.size() > 1) {
            double most = 0;
            std::size_t which = order.size();
            for (std::size_t i = 0; i < order.size(); ++i) {
                const bool first = i == 0, last = i + 1 == order.size();
                const double to = first ? 0 : way(order[i - 1], order[i]), on = last ? 0 : way(order[i], order[i + 1]);
                const double past =
                    first || last || std::isinf(to) || std::isinf(on) ? 0 : way(order[i - 1], order[i + 1]);
                const double saved = (std::isinf(to) ? 0 : to) + (std::isinf(on) ? 0 : on) - past;
                if (const double wasted = rules::kOverlapCosts * saved - length(chains[order[i].chain]);
                    wasted > most) {
                    most = wasted;
                    which = i;
                }
            }
            if (which == order.size()) return;
            order.erase(order.begin() + static_cast<std::ptrdiff_t>(which));
        }
    }

    // Connects the chains in the best order, where transits connect them.
    [[nodiscard]] ChainSet joined(std::vector<RowChain> chains) const {
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
        ChainSet result;
        std::vector<RowChain>& out = result.chains;
        std::vector<char> kept(n, 0);
        std::size_t before = 2 * n;
        for (const OrientedChain& t : turned) {
            kept[t.chain] = 1;
            RowChain& now = chains[t.chain];
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
            if (kept[c] == 0) result.left.push_back(std::move(chains[c]));
        return result;
    }

    // Length of the transit from one end to another, mm; infinite if there is none.
    [[nodiscard]] double fibre(std::uint32_t from, std::uint32_t to) const {
        const double l = transits_.length(from, to);
        return l <= o_.along ? l : way_length(from, to) - break_;
    }

    // Cost of the transit from one end to another, mm: the length along rims and rows. Where there is none, as between
    // spirals, a straight line may be possible; it crosses other lines, so it costs break_ more.
    [[nodiscard]] double way_length(std::uint32_t from, std::uint32_t to) const {
        const double l = transits_.length(from, to);
        if (l <= o_.along) return l;
        const Line line = across(from, to);
        const double straight = surface::curve::length(line);
        return line.size() > 1 && straight <= o_.across ? break_ + straight : std::numeric_limits<double>::infinity();
    }

    // The straight line across the surface from one end to another; empty if it does not lead there.
    [[nodiscard]] Line across(std::uint32_t from, std::uint32_t to) const {
        const auto place = [&](std::uint32_t e) {
            const auto& places = rows_.rows[e / 2].line.places;
            return e % 2 == 0 ? places.front() : places.back();
        };
        const Place a = place(from), b = place(to);
        Line out = surface::curve::join(surface_, a, b);
        return out.size() > 2 || a.triangle == b.triangle ? out : Line{};
    }

    // The turn from one end to another, or a transit, whose length is added to `transited`.
    [[nodiscard]] SurfaceTurn turn(std::uint32_t from, std::uint32_t to, double& transited) const {
        const auto [a, b] = std::minmax(from, to);
        const auto it = std::lower_bound(turns_.begin(), turns_.end(), std::pair(a, b),
                                         [](const SurfaceTurn& t, auto& k) { return std::pair(t.from, t.to) < k; });
        const bool known = it != turns_.end() && it->from == a && it->to == b;
        if (known && it->line.size() > 1) {
            SurfaceTurn out = *it;
            if (from != a) reverse(out);
            return out;
        }
        const auto way = transits_.shortest(from, to);
        const auto stretches = known                            ? std::vector<Line>{transits_.along(from, to)}
                               : way && way->length <= o_.along ? way->stretches
                                                                : std::vector<Line>{across(from, to)};
        for (const Line& l : stretches) transited += surface::curve::length(l);
        SurfaceTurn out = turner_.eased(from, stretches, to);
        return out;
    }

    // A turn, extended by the parts of its rows that the deepest variant would replace.
    [[nodiscard]] plan::Stroke with_rows(const SurfaceTurn& t, double from_deepest, double to_deepest) const {
        plan::Stroke out;
        if (t.from_trim < from_deepest)
            out.sections.push_back({turner_.part(t.from, t.from_trim, from_deepest), false});
        out.sections.push_back({t.line, false});
        if (t.to_trim < to_deepest) out.sections.push_back({turner_.part(t.to, t.to_trim, to_deepest), false});
        return out;
    }

    // Chooses the depths of all turns of all chains, so that less overlaps.
    void stagger(const std::vector<RowChain>& chains, std::vector<std::vector<SurfaceTurn>>& turns) const {
        std::vector<SurfaceTurn*> which;
        std::vector<std::vector<SurfaceTurn>> laid;
        std::vector<plan::TurnVariants> depths;
        auto deepest = turns;
        for (std::size_t c = 0; c < turns.size(); ++c)
            for (std::size_t i = 0; i < turns[c].size(); ++i) {
                if (turns[c][i].eased) continue;
                which.push_back(&turns[c][i]);
                laid.push_back(turner_.deeper(turns[c][i], rules::kGrain * o_.spacing));
                SurfaceTurn& most = deepest[c][i];
                most.line = {};
                for (const SurfaceTurn& t : laid.back()) {
                    most.from_trim = std::max(most.from_trim, t.from_trim);
                    most.to_trim = std::max(most.to_trim, t.to_trim);
                }
                plan::TurnVariants& now = depths.emplace_back();
                for (const SurfaceTurn& t : laid.back()) now.push_back(with_rows(t, most.from_trim, most.to_trim));
            }
        plan::Plan fixed;
        for (std::size_t c = 0; c < chains.size(); ++c) fixed.strokes.push_back(stroke(chains[c], deepest[c]));
        const auto chosen = plan::staggered(surface_, fixed, depths, o_.spacing);
        for (std::size_t i = 0; i < which.size(); ++i) *which[i] = std::move(laid[i][chosen[i]]);
    }

    // The rows of a chain with the turns between them; turns without a line are left out.
    [[nodiscard]] plan::Stroke stroke(const RowChain& chain, const std::vector<SurfaceTurn>& turns) const {
        plan::Stroke out;
        double off = 0;
        for (std::size_t i = 0; i < chain.size(); ++i) {
            const bool last = i + 1 == chain.size();
            const double end = last ? 0 : turns[i].from_trim;
            if (Line row = turner_.stretch(entry(chain[i]), off, end); row.size() > 1)
                out.sections.push_back({std::move(row), false});
            if (last) break;
            off = turns[i].to_trim;
            if (turns[i].line.size() > 1) out.sections.push_back({turns[i].line, false});
        }
        return out;
    }

    const Surface& surface_;
    const Rows& rows_;
    Transits transits_;
    Turner turner_;
    std::vector<SurfaceTurn> turns_;
    TurnOptions o_;
    double break_ = 1; // mm: cost of a chain that must be connected to another one; more than that of all turns
    std::optional<CandidatePath> best_;
};

} // namespace

plan::Plan boustrophedon(const Surface& s, const Rows& rows, const TurnOptions& o) {
    return RowPathPlanner(s, rows, o).plan();
}

} // namespace filum::surfpath::rows
