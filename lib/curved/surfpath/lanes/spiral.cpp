#include "surfpath/lanes/spiral.hpp"

#include "geom/cubic_turn.hpp"
#include "surfpath/rules/rules.hpp"
#include "weave/join.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace filum::surfpath::lanes {

namespace {

weave::End first_rung(std::uint32_t window, double sense) { return {window, sense < 0}; }
weave::End last_rung(std::uint32_t window, double sense) { return {window, sense > 0}; }

// The window of lane number k between the first and the last rung.
weave::Window window(const LinkedLanes& linked, const Ladder& r, std::size_t k) {
    const double a = r.arcs.front()[k], b = r.arcs.back()[k];
    return r.sense[k] > 0 ? linked.window(r.lane[k], a, b) : linked.window(r.lane[k], b, a);
}

// The link from lane u0 to lane u1, between rungs v0 and v1.
std::vector<Vec2> change(const Ladder& r, double u0, double u1, double v0, double v1) {
    std::vector<Vec2> out;
    const int n = std::max(2, static_cast<int>(std::ceil(std::abs(v1 - v0) / rules::kGrain)));
    for (int i = 0; i <= n; ++i) {
        const double t = static_cast<double>(i) / n, v = v0 + t * (v1 - v0);
        out.push_back({u0 + (u1 - u0) * rules::shifted(v / r.last()), v});
    }
    return out;
}

std::vector<Vec2> straight(double u, double v0, double v1) {
    std::vector<Vec2> out;
    const int n = std::max(1, static_cast<int>(std::ceil(std::abs(v1 - v0) / rules::kGrain)));
    for (int i = 0; i <= n; ++i) out.push_back({u, v0 + (v1 - v0) * i / n});
    return out;
}

} // namespace

namespace {

// The longest run of consecutive rungs from rung `i` on the same lanes; it does not wrap around to `i`.
std::vector<Rung> run_from(const Lanes& lanes, std::span<const Rung> rungs, std::size_t i) {
    const std::size_t n = rungs.size();
    std::vector<Rung> out{rungs[i]};
    while (out.size() + 1 < n && follows(lanes, out.back(), rungs[(i + out.size()) % n]))
        out.push_back(rungs[(i + out.size()) % n]);
    return out;
}

// Whether every lane keeps at least half of its length outside the ladder.
bool fits(const Lanes& lanes, const Ladder& r) {
    for (std::size_t k = 0; k < r.lanes(); ++k)
        if (2 * lanes.ahead(r.lane[k], r.arcs.front()[k], r.arcs.back()[k], r.sense[k]) > lanes.length(r.lane[k]))
            return false;
    return true;
}

// The first rungs of a run: as many as make the shortest lane between them `wanted` mm long, or all; at least three.
Ladder first_of(const Lanes& lanes, std::span<const Rung> run, double wanted, double step) {
    for (std::size_t count = 3;;) {
        Ladder out = ladder({run.begin(), run.begin() + static_cast<std::ptrdiff_t>(count)}, step);
        const double l = shortest(lanes, out);
        if (l >= wanted || count == run.size()) return out;
        const double more = l > 0 ? wanted / l * static_cast<double>(count) : 0;
        count = std::min(run.size(), std::max(count + 1, static_cast<std::size_t>(more)));
    }
}

// The first ladder over the lanes of these rungs that is at least `least` mm long, and hardly longer; empty if there is
// none.
Ladder long_ladder(const Lanes& lanes, std::span<const Rung> rungs, double least, double step) {
    for (std::size_t i = 0; i < rungs.size();) {
        if (rungs[i].places.empty()) {
            ++i;
            continue;
        }
        const auto run = run_from(lanes, rungs, i);
        i += run.size();
        if (run.size() < 3) continue;
        Ladder out = first_of(lanes, run, least, step);
        if (shortest(lanes, out) >= least && fits(lanes, out)) return out;
    }
    return {};
}

} // namespace

Ladder spiral_ladder(const Lanes& lanes, std::uint32_t start, double least) {
    const double step = lanes.spacing();
    const auto n = static_cast<std::size_t>(lanes.length(start) / step);
    std::vector<Rung> rungs;
    std::size_t most = 0;
    for (std::size_t i = 0; i < n; ++i) {
        rungs.push_back(rung(lanes, start, step * static_cast<double>(i), 1, rules::kBeside, lanes.size()));
        most = std::max(most, rungs.back().places.size());
    }
    for (std::size_t count = most; count >= 2; --count) {
        auto cropped = rungs;
        for (Rung& r : cropped) {
            const std::size_t kept = r.places.size() < count ? 0 : count;
            r.places.resize(kept);
            r.sense.resize(kept);
        }
        if (Ladder best = long_ladder(lanes, cropped, least, step); best.lanes() > 0) return best;
    }
    return {};
}

// The inner end of a spiral on a ridge: moves from the innermost lane to the middle between this lane and itself, and
// follows the ridge as long as a line fits. Empty if none does.
static Line along_ridge(const Lanes& lanes, std::uint32_t lane, double arc, double sense, double radius) {
    Line out;
    // A line fits into a gap where it costs less than the void that it covers. Of a gap of g spacings, g - 1 are void;
    // the line overlaps by 2 - g.
    const double fits = (1 + 2 * rules::kOverlapCosts) / (1 + rules::kOverlapCosts);
    const double d = lanes.spacing(), step = 0.3 * d;
    const Vec3 begin = lanes.tangent(lane, arc);
    for (double on = 0; on < lanes.length(lane) / 2; on += step) {
        const double here = arc + sense * on;
        const auto over = lanes.across(lane, here, 1, 1 + rules::kBeside);
        if (!over || over->lane != lane || over->distance < fits * d) break;
        if (dot(lanes.tangent(lane, here), begin) < 0) break; // the lane turns around the end of the ridge
        const Line line = surface::curve::join(lanes.surface(), lanes.at(lane, here), lanes.at(lane, over->arc));
        const auto arcs = surface::curve::arc_lengths(line);
        out.places.push_back(surface::curve::at(
            line, arcs,
            0.5 * rules::shifted(std::min(1.0, on / rules::shift_length(radius, over->distance / 2))) * arcs.back()));
    }
    return surface::curve::threaded(lanes.surface(), out);
}

// The way from an end of lane number k to that of the next lane between the rungs, which end at rung v: into the wedge
// that the links leave, on towards later rungs (side 1) or earlier ones (-1), and back by a half turn.
static std::vector<Vec2> half_turn(const Lanes& lanes, const Ladder& r, std::size_t k, double v, double side,
                                   double into = 0) {
    const double u = static_cast<double>(k), turned = v + side * into;
    std::vector<Vec2> out = straight(u, v, turned);
    for (const Vec2 p : geom::cubic_turn({u, 0}, {0, side}, {u + 1, 0}, {0, -side}, rules::kFineGrain))
        out.push_back({p.x, turned + p.y * lanes.spacing() / r.step});
    const auto back = straight(u + 1, turned, v);
    out.insert(out.end(), back.begin(), back.end());
    return out;
}

void shift(LinkedLanes& linked, const Lanes& lanes, const Ladder& r, int by, double radius) {
    const std::size_t n = r.lanes(), s = static_cast<std::size_t>(by);
    std::vector<std::uint32_t> opening;
    for (std::size_t k = 0; k < n; ++k) opening.push_back(linked.cut(window(linked, r, k)));
    for (std::size_t k = 0; k + s < n; ++k)
        linked.link(first_rung(opening[k], r.sense[k]), last_rung(opening[k + s], r.sense[k + s]),
                    drawn(lanes, r, change(r, static_cast<double>(k), static_cast<double>(k + s), 0, r.last())));
    const double half = r.last() / 2, end = r.last();
    linked.tail(last_rung(opening[0], r.sense[0]), drawn(lanes, r, straight(0, end, by == 1 ? half : 0.4 * end)));
    const auto inner = static_cast<double>(n - 1);
    if (by == 1) {
        Line end_line = along_ridge(lanes, r.lane[n - 1], r.arcs[0][n - 1], r.sense[n - 1], radius);
        if (end_line.size() < 2) end_line = drawn(lanes, r, straight(inner, 0, half));
        linked.tail(first_rung(opening[n - 1], r.sense[n - 1]), std::move(end_line));
        return;
    }
    linked.tail(last_rung(opening[1], r.sense[1]), drawn(lanes, r, straight(1, end, 0.8 * end)));
    linked.link(first_rung(opening[n - 2], r.sense[n - 2]), first_rung(opening[n - 1], r.sense[n - 1]),
                drawn(lanes, r, half_turn(lanes, r, n - 2, 0, 1)));
}

void wind_loop(LinkedLanes& linked, const Lanes& lanes, const Ladder& r, double into) {
    const std::size_t n = r.lanes();
    std::vector<std::uint32_t> opening;
    for (std::size_t k = 0; k < n; ++k) opening.push_back(linked.cut(window(linked, r, k)));
    for (std::size_t k = 0; k + 2 < n; ++k)
        linked.link(first_rung(opening[k], r.sense[k]), last_rung(opening[k + 2], r.sense[k + 2]),
                    drawn(lanes, r, change(r, static_cast<double>(k), static_cast<double>(k + 2), 0, r.last())));
    linked.link(last_rung(opening[0], r.sense[0]), last_rung(opening[1], r.sense[1]),
                drawn(lanes, r, half_turn(lanes, r, 0, r.last(), -1, into * r.last())));
    linked.link(first_rung(opening[n - 2], r.sense[n - 2]), first_rung(opening[n - 1], r.sense[n - 1]),
                drawn(lanes, r, half_turn(lanes, r, n - 2, 0, 1, into * r.last())));
}

namespace {

// A place where two lanes can be joined.
struct ExchangeSite {
    double cost;
    std::uint32_t a, b;
    double arc, side, gap;
    double over = -1; // arc length on lane b; negative: not yet known
};

class LaneExchanger {
  public:
    LaneExchanger(LinkedLanes& linked, const Lanes& lanes, double radius)
        : linked_(linked), lanes_(lanes), radius_(radius) {}

    void run() {
        find_sites();
        for (const double share : rules::kRadiusShares)
            weave::join(linked_.groups(), sites_, [&](const ExchangeSite& s) { join(s, share * radius_); });
        turns_back();
        if (linked_.groups().sets() == 1) return;
        nearby_sites();
        turns_back();
    }

  private:
    std::uint32_t find(std::uint32_t l) { return linked_.groups().root(l); }

    void turns_back() {
        for (const double part : {0.15, 0.05})
            weave::join(linked_.groups(), sites_, [&](const ExchangeSite& s) { turn_back(s, part); });
    }

    void find_sites() {
        sites_across(
            [&](std::uint32_t l, double arc, double side) { return lanes_.across(l, arc, side, rules::kBeside); });
        sort_sites();
    }
    // Adds what across(lane, arc, side) finds on both sides of each lane, unless the two lanes are joined already.
    template <class Across>
    void sites_across(const Across& across) {
        const double d = lanes_.spacing();
        for (std::uint32_t l = 0; l < lanes_.size(); ++l) {
            const auto n = static_cast<std::size_t>(std::ceil(lanes_.length(l) / (0.5 * d)));
            for (std::size_t i = 0; i < n; ++i) {
                const double arc = lanes_.length(l) * static_cast<double>(i) / static_cast<double>(n);
                for (const double side : {1.0, -1.0})
                    if (const auto next = across(l, arc, side); next && find(next->lane) != find(l))
                        add(l, arc, side, *next);
            }
        }
    }
    // Finds sites from every lane to the nearest lane that it is not joined to, in any direction.
    void nearby_sites() {
        const double d = lanes_.spacing();
        sites_.clear();
        for (std::uint32_t l = 0; l < lanes_.size(); ++l) {
            const auto n = static_cast<std::size_t>(std::ceil(lanes_.length(l) / (0.2 * d)));
            for (std::size_t i = 0; i < n; ++i) {
                const double arc = lanes_.length(l) * static_cast<double>(i) / static_cast<double>(n);
                const auto other = [&](std::uint32_t o, double) { return find(o) != find(l); };
                for (const double reach : {1.0, rules::kBeside, 2 * rules::kBeside})
                    if (const auto near = lanes_.nearest(lanes_.at(l, arc), reach * d, other)) {
                        sites_.push_back({near->distance, l, near->lane, arc, 0, near->distance, near->arc});
                        break;
                    }
            }
        }
        sort_sites();
    }
    void sort_sites() {
        std::sort(sites_.begin(), sites_.end(), [](const ExchangeSite& a, const ExchangeSite& b) {
            return std::tie(a.cost, a.a, a.arc, a.side) < std::tie(b.cost, b.a, b.arc, b.side);
        });
    }
    void add(std::uint32_t l, double arc, double side, const LanePlace& next) {
        const double gap = next.distance / lanes_.spacing();
        const double bend = std::max(lanes_.curvature(l, arc), lanes_.curvature(next.lane, next.arc));
        sites_.push_back({std::abs(gap - 1) + 4 * bend * lanes_.spacing(), l, next.lane, arc, side, next.distance, -1});
    }

    // Without room for an exchange of lanes side by side: each lane turns back into the other at two places.
    void turn_back(const ExchangeSite& s, double part) {
        const double d = lanes_.spacing(), half = part * d;
        double there = s.over;
        if (there < 0) {
            const auto over = lanes_.across(s.a, s.arc, s.side, std::max(1.7, s.gap / d + 0.7));
            if (!over || over->lane != s.b) return;
            there = over->arc;
        }
        const double sense = dot(lanes_.tangent(s.a, s.arc), lanes_.tangent(s.b, there)) > 0 ? 1 : -1;
        const weave::Window a{s.a, s.arc - half, s.arc + half}, b{s.b, there - half, there + half};
        if (!linked_.free(a, half) || !linked_.free(b, half)) return;
        std::array<Line, 2> links;
        for (const std::size_t k : {0U, 1U}) {
            const double end = k == 0 ? -half : half;
            links[k] = surface::curve::join(lanes_.surface(), lanes_.at(s.a, s.arc + end),
                                            lanes_.at(s.b, there + end * sense));
            if (!surface::curve::leads(lanes_.surface(), links[k])) return;
        }
        linked_.exchange(a, b, sense > 0, std::move(links));
    }

    // Exchanges lanes that run side by side, with turns of the radius.
    void join(const ExchangeSite& s, double radius) {
        const double long_ = rules::shift_length(radius, s.gap), d = lanes_.spacing();
        const auto n = static_cast<std::size_t>(std::max(4.0, std::ceil(long_ / (rules::kGrain * d))));
        const double step = long_ / static_cast<double>(n);
        if (long_ > 0.7 * std::min(lanes_.length(s.a), lanes_.length(s.b))) return;
        std::vector<Rung> rungs;
        for (std::size_t i = 0; i <= n; ++i) {
            const double arc = s.arc + step * (static_cast<double>(i) - static_cast<double>(n) / 2);
            rungs.push_back(rung(lanes_, s.a, arc, s.side, std::max(1.7, s.gap / d + 0.7), 2));
            if (rungs[i].places.size() < 2 || rungs[i].places[1].lane != s.b) return;
            if (i > 0 && !follows(lanes_, rungs[i - 1], rungs[i])) return;
        }
        const Ladder r = ladder(rungs, step);
        const weave::Window a = window(linked_, r, 0), b = window(linked_, r, 1);
        if (!linked_.free(a, 0) || !linked_.free(b, 0)) return;
        const std::uint32_t w[2] = {linked_.cut(a), linked_.cut(b)};
        for (const std::size_t k : {0U, 1U})
            linked_.link(first_rung(w[k], r.sense[k]), last_rung(w[1 - k], r.sense[1 - k]),
                         drawn(lanes_, r, change(r, k == 0 ? 0 : 1, k == 0 ? 1 : 0, 0, r.last())));
    }

    LinkedLanes& linked_;
    const Lanes& lanes_;
    double radius_;
    std::vector<ExchangeSite> sites_;
};

} // namespace

void exchange_lanes(LinkedLanes& linked, const Lanes& lanes, double radius) {
    LaneExchanger(linked, lanes, radius).run();
}

} // namespace filum::surfpath::lanes
