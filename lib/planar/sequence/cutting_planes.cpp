#include "sequence/cutting_planes.hpp"

#include <algorithm>
#include <cmath>

namespace filum::sequence {

namespace {

constexpr Index kShared = 2; // cuts per round in which a link may be before further ones are postponed

} // namespace

CuttingPlanes::CuttingPlanes(const Graph& g, const Columns& columns, std::uint64_t most_work)
    : g_(g), columns_(columns), successors_(g, columns, most_work), link_(g.size(), kNone), so_far_(g.size()),
      level_(g.size()), work_(successors_.work()) {
    for (const auto& member : columns.member)
        for (std::size_t p = 0; p + 1 < member.size(); ++p) {
            const auto up = g.up[member[p]];
            const auto it = std::lower_bound(up.begin(), up.end(), member[p + 1]);
            if (it != up.end() && *it == member[p + 1])
                link_[member[p]] = g.up.start[member[p]] + static_cast<Index>(it - up.begin());
        }
}

std::vector<Inequality> CuttingPlanes::degrees() const {
    std::vector<Inequality> out;
    std::vector<std::vector<Index>> entering(g_.size());
    for (Index u = 0; u < g_.size(); ++u) {
        Inequality leaving;
        for (Index a = g_.up.start[u]; a < g_.up.start[u + 1]; ++a) {
            leaving.link.push_back(a);
            entering[g_.up.to[a]].push_back(a);
        }
        leaving.least = static_cast<Index>(std::max<std::size_t>(1, leaving.link.size()) - 1);
        if (leaving.least > 0) out.push_back(std::move(leaving));
    }
    for (auto& links : entering)
        if (const auto many = static_cast<Index>(links.size()); many > 1) out.push_back({std::move(links), many - 1});
    return out;
}

std::vector<Inequality> CuttingPlanes::apart() const {
    std::vector<Inequality> out;
    for (Index c = 0; c < columns_.member.size(); ++c)
        for (Index p = 0; p < columns_.member[c].size();) {
            const Index head = successors_.again(columns_.member[c][p]);
            if (head == kNone) break; // no higher region has one either
            Inequality next = cut({{c, p, head}}, 1);
            if (next.least > 0) out.push_back(std::move(next));
            p = head;
        }
    return out;
}

void CuttingPlanes::sum_up(std::span<const double> unused) {
    for (const auto& member : columns_.member) {
        so_far_[member[0]] = 0;
        level_[member[0]] = 0;
        for (std::size_t p = 1; p < member.size(); ++p) {
            const Index a = link_[member[p - 1]];
            const double here = a == kNone ? 1 : std::max(0.0, unused[a]);
            so_far_[member[p]] = so_far_[member[p - 1]] + here;
            level_[member[p]] = here > 1e-9 ? static_cast<Index>(p) : level_[member[p - 1]];
        }
    }
}

std::vector<CuttingPlanes::Violation> CuttingPlanes::again() const {
    std::vector<Violation> out;
    for (Index c = 0; c < columns_.member.size(); ++c)
        for (Index p = 0; p < columns_.member[c].size(); ++p) {
            const Index head = successors_.again(columns_.member[c][p]);
            if (head == kNone) continue;
            if (p + 1 < columns_.member[c].size() && successors_.again(columns_.member[c][p + 1]) == head) continue;
            if (const double by = 1 - broken(c, p, head); by > kLeastViolation) out.push_back({by, {{c, p, head}}, 1});
        }
    return out;
}

// Adds the stretch of another column that increases the breaks least; `sum` is the total. False if none fits.
bool CuttingPlanes::add_rival(Stretches& s, double& sum) {
    Stretches best;
    double least = 0;
    for (Index c = 0; c < columns_.member.size(); ++c) {
        Index head = 0;
        for (const Stretch& x : s) {
            ++work_;
            head = x.column == c ? kNone : std::max(head, successors_.first(columns_.member[x.column][x.foot], c));
            if (head == kNone) break;
        }
        if (head == kNone) continue;
        // Of places with equally many breaks below them the lowest has the lowest heads; the foot is raised later.
        for (Index foot = level_[columns_.member[c][head]];; foot = level_[columns_.member[c][foot - 1]]) {
            double all = broken(c, foot, head);
            if (all >= 1) break;
            Stretches longer = s;
            for (Stretch& x : longer) {
                ++work_;
                const Index h = successors_.first(columns_.member[c][foot], x.column);
                if (h == kNone) {
                    longer.clear();
                    break;
                }
                x.head = std::max(x.head, h);
                all += broken(x.column, x.foot, x.head);
            }
            if (!longer.empty() && (best.empty() || all < least)) {
                least = all;
                longer.push_back({c, foot, head});
                best = std::move(longer);
            }
            if (foot == 0) break;
        }
    }
    if (best.empty()) return false;
    s = std::move(best);
    sum = least;
    return true;
}

// Shortens the stretches from below as far as their heads stay the same.
void CuttingPlanes::raise_feet(Stretches& s) const {
    for (Stretch& x : s) {
        const auto may_rise = [&] {
            return std::all_of(s.begin(), s.end(), [&](const Stretch& o) {
                return o.column == x.column ||
                       successors_.first(columns_.member[x.column][x.foot + 1], o.column) <= o.head;
            });
        };
        while (x.foot < x.head && may_rise()) ++x.foot;
    }
}

// Starting with a stretch from each place above a break, adds rivals one by one as long as a violation is likely.
std::vector<CuttingPlanes::Violation> CuttingPlanes::rivals() {
    constexpr double kHope = 0.7;
    std::vector<Violation> out;
    for (Index c = 0; c < columns_.member.size(); ++c)
        for (Index p = 0; p < columns_.member[c].size(); ++p) {
            if (level_[columns_.member[c][p]] != p) continue;
            Stretches s{{c, p, p}};
            Violation best{kLeastViolation, {}, 0};
            double sum = 0;
            while (add_rival(s, sum)) {
                const double by = static_cast<double>(s.size() - 1) - sum;
                if (by > best.by) best = {by, s, static_cast<Index>(s.size() - 1)};
                if (by < -kHope) break;
            }
            if (best.stretches.empty()) continue;
            raise_feet(best.stretches);
            std::sort(best.stretches.begin(), best.stretches.end());
            out.push_back(std::move(best));
        }
    return out;
}

Inequality CuttingPlanes::cut(const Stretches& s, Index least) const {
    Inequality out{{}, least};
    for (const Stretch& x : s)
        for (Index p = x.foot; p < x.head; ++p) {
            if (const Index a = link_[columns_.member[x.column][p]]; a != kNone)
                out.link.push_back(a);
            else if (out.least > 0)
                --out.least; // a step that is not a link is a break in any case
        }
    std::sort(out.link.begin(), out.link.end());
    out.link.erase(std::unique(out.link.begin(), out.link.end()), out.link.end()); // a circle may pass a link twice
    return out;
}

std::vector<Inequality> CuttingPlanes::violated(std::span<const double> unused) {
    sum_up(unused);
    work_ += g_.size();
    auto found = again();
    if (found.empty()) found = rivals();
    if (found.empty()) found = circles();
    std::sort(found.begin(), found.end(), [](const Violation& a, const Violation& b) {
        return a.by > b.by || (a.by == b.by && a.stretches < b.stretches);
    });
    const auto same = [](const Violation& a, const Violation& b) { return a.stretches == b.stretches; };
    found.erase(std::unique(found.begin(), found.end(), same), found.end());
    std::vector<Index> shared(g_.up.size(), 0);
    std::vector<Inequality> out;
    for (const Violation& f : found) {
        Inequality c = cut(f.stretches, f.least);
        const auto often = std::count_if(c.link.begin(), c.link.end(), [&](Index a) { return shared[a] >= kShared; });
        if (2 * static_cast<std::size_t>(often) > c.link.size()) continue;
        for (const Index a : c.link) ++shared[a];
        out.push_back(std::move(c));
    }
    return out;
}

} // namespace filum::sequence
