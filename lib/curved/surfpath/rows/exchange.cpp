#include "surfpath/rows/exchange.hpp"

#include "geom/cubic_turn.hpp"
#include "geom/polyline.hpp"
#include "geom/segment.hpp"
#include "surfpath/lanes/linked_lanes.hpp"
#include "surfpath/rows/beads.hpp"
#include "surfpath/rows/swath.hpp"
#include "surfpath/rules/rules.hpp"
#include "weave/join.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <queue>

namespace filum::surfpath::rows {

namespace {

using geom::Vec2;

// Half of what is cut out of each line, as it is tried: from tips that lead straight on to gaps that turns just cover.
// Sites are ranked at first by the third, at which two half turns are about as long as what they replace.
constexpr double kCuts[] = {0.4, 0.6, 0.8, 1, 1.2, 1.4};
constexpr std::size_t kMostTried = 12; // sites per pair of lines that are judged by their waste: limits the work

// An exchange between two lines: each is cut out around an arc length, by half of its cut on both sides.
struct LineExchange {
    double waste = 0; // mm2
    std::uint32_t a = 0, b = 0;
    double at_a = 0, at_b = 0, cut_a = 0, cut_b = 0; // mm
    bool judged = false;                             // whether `waste` is that of the best cuts
};

// The two turns of an exchange, on a chart: from the first line to the other, and back.
struct TurnPair {
    std::vector<Vec2> there, back;
    bool same = true; // whether the lines run in the same direction
};

class LineExchanger {
  public:
    LineExchanger(const Surface& s, const std::vector<Line>& lines, std::span<const char> keep,
                  const ExchangeOptions& o)
        : s_(s), given_(lines), d_(o.spacing), ends_(o.ends), radius_(o.radius), lanes_(s, closed(lines), o.spacing),
          linked_(lanes_), normals_(surface::curve::vertex_normals(s)), anchored_(lines.size(), 0),
          swath_(o.spacing, half_), rest_(swath_), beads_(s, lines, lanes_) {
        for (std::uint32_t l = 0; l < lines.size(); ++l) {
            anchored_[l] = keep[l] != 0 || !lines[l].closed ? 1 : 0;
            if (!lines[l].closed) linked_.cut(linked_.window(l, beads_.length(l), 0));
        }
    }

    ExchangeResult run() {
        ExchangeResult out;
        propose();
        const auto again = [&](LineExchange& e) {
            if (!open(e)) return weave::Verdict::never;
            const bool sure = e.judged;
            const double before = e.waste;
            judge(surroundings(lanes_.at(e.a, e.at_a)), e, kCuts, {0, -1, 1});
            e.judged = true;
            if (sure && e.waste <= before + rules::kSamePoint) return weave::Verdict::join;
            return worth_it(e) ? weave::Verdict::later : weave::Verdict::never; // one made since may be in the way
        };
        weave::join_cheapest(queue_, again, [&](const LineExchange& e) {
            if (!take(surroundings(lanes_.at(e.a, e.at_a)), e)) return;
            ++out.count;
            out.waste += e.waste;
        });
        return out;
    }

    // The lines that result; those that were taken into another one are empty.
    [[nodiscard]] std::vector<Line> lines() {
        std::vector<Line> out = given_;
        for (auto& path : linked_.curves()) {
            if (path.lanes.size() < 2) continue;
            std::uint32_t host = path.lanes[0];
            for (const std::uint32_t l : path.lanes) {
                out[l].places.clear();
                if (anchored_[l] == 1) host = l;
            }
            out[host] = path.take(given_[host][0]);
        }
        return out;
    }

  private:
    static std::vector<Line> closed(std::vector<Line> lines) {
        for (Line& l : lines) l.closed = true;
        return lines;
    }

    // Whether the two lines can still be joined.
    [[nodiscard]] bool open(const LineExchange& e) {
        const auto a = linked_.groups().root(e.a), b = linked_.groups().root(e.b);
        return a != b && (anchored_[a] == 0 || anchored_[b] == 0);
    }

    // Proposes the best few exchanges of every pair of lines.
    void propose() {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<LineExchange>> found;
        for (std::uint32_t a = 0; a < given_.size(); ++a) {
            if (!given_[a].closed) continue;
            const auto n = static_cast<std::size_t>(std::ceil(beads_.length(a) / (2 * rules::kGrain * d_)));
            for (std::size_t i = 0; i < n; ++i)
                for (LineExchange& e :
                     candidates(a, beads_.length(a) * static_cast<double>(i) / static_cast<double>(n)))
                    if (open(e)) found[std::minmax(e.a, e.b)].push_back(e);
        }
        for (auto& [pair, all] : found) {
            std::stable_sort(all.begin(), all.end(),
                             [](const LineExchange& x, const LineExchange& y) { return x.waste < y.waste; });
            if (all.size() > kMostTried) all.resize(kMostTried);
            for (LineExchange& e : all) {
                judge(surroundings(lanes_.at(e.a, e.at_a)), e, std::span(kCuts).subspan(2, 1), {0});
                if (worth_it(e)) queue_.push(e);
            }
        }
    }

    // Whether it wastes less than a pair of crossing shifts.
    [[nodiscard]] bool worth_it(const LineExchange& e) const { return e.waste < kCrossingWastes * d_ * d_; }

    // One exchange for every line beside this place, rated by the additional length only.
    [[nodiscard]] std::vector<LineExchange> candidates(std::uint32_t a, double way) const {
        const Place at = lanes_.at(a, way);
        const auto chart = chart_at(at);
        std::vector<LineExchange> out;
        for (const BeadPoint& bead : beads_.neighbours(a, at.point, chart.normal, rules::kBeside * d_)) {
            out.push_back({0, a, bead.line, way, bead.arc, kCuts[2] * d_, kCuts[2] * d_});
            out.back().waste = d_ * longer(out.back(), turn_pair(chart, out.back()));
        }
        return out;
    }

    [[nodiscard]] surface::curve::Chart chart_at(const Place& at) const {
        const Vec3 normal = surface::curve::normal_at(s_, normals_, at);
        const Vec3& corner = s_.vertices[s_.triangles[at.triangle][0]];
        const Vec3& next = s_.vertices[s_.triangles[at.triangle][1]];
        return surface::curve::chart(at, normal, next - corner);
    }

    // The bead points within the square of the swath and half a bead around it.
    [[nodiscard]] Surroundings surroundings(const Place& at) const {
        return beads_.around(chart_at(at), std::numbers::sqrt2 * half_ + d_ / 2);
    }

    [[nodiscard]] double longer(const LineExchange& e, const TurnPair& t) const {
        return geom::length(t.there) + geom::length(t.back) - 2 * e.cut_a - 2 * e.cut_b;
    }

    // A point of a line on the chart, and its unit tangent (or 0).
    struct Heading {
        Vec2 p, t;
    };
    [[nodiscard]] Heading heading(const surface::curve::Chart& chart, std::uint32_t line, double way) const {
        const Vec2 p = chart.to(lanes_.at(line, way).point),
                   a = chart.to(lanes_.at(line, way - rules::kFineGrain * d_).point),
                   b = chart.to(lanes_.at(line, way + rules::kFineGrain * d_).point);
        const double l = distance(a, b);
        return {p, l > 0 ? 1 / l * (b - a) : Vec2{}};
    }

    [[nodiscard]] TurnPair turn_pair(const surface::curve::Chart& chart, const LineExchange& e) const {
        TurnPair out;
        out.same = dot(heading(chart, e.a, e.at_a).t, heading(chart, e.b, e.at_b).t) >= 0;
        const Heading a0 = heading(chart, e.a, e.at_a - e.cut_a), a1 = heading(chart, e.a, e.at_a + e.cut_a),
                      b0 = heading(chart, e.b, e.at_b - e.cut_b), b1 = heading(chart, e.b, e.at_b + e.cut_b);
        const double step = rules::kFineGrain * d_;
        if (out.same) {
            out.there = geom::cubic_turn(a0.p, a0.t, b0.p, -1 * b0.t, step);
            out.back = geom::cubic_turn(b1.p, -1 * b1.t, a1.p, a1.t, step);
        } else {
            out.there = geom::cubic_turn(a0.p, a0.t, b1.p, b1.t, step);
            out.back = geom::cubic_turn(b0.p, b0.t, a1.p, a1.t, step);
        }
        return out;
    }

    // Whether neither line has been cut at these places.
    [[nodiscard]] bool free(const LineExchange& e) const {
        const auto there = [&](std::uint32_t line, double at, double cut) {
            const double all = beads_.length(line);
            const bool inside = given_[line].closed || (at - cut >= ends_ && at + cut <= all - ends_);
            return inside && 2 * cut + 2 * d_ <= all && beads_.whole(line, at, cut, rules::kFineGrain * d_);
        };
        return there(e.a, e.at_a, e.cut_a) && there(e.b, e.at_b, e.cut_b);
    }

    // Sets `e` to the cuts and the shift of one line against the other, in grains, of least waste; its waste is
    // infinite if none are possible.
    void judge(const Surroundings& view, LineExchange& e, std::span<const double> cuts,
               std::initializer_list<int> slips) {
        swath_.clear();
        rest_.clear();
        for (const auto& bead : view.beads) {
            swath_.add(bead.p);
            if (bead.line != e.a && bead.line != e.b) rest_.add(bead.p);
        }
        for (const Vec2& p : view.added) {
            swath_.add(p);
            rest_.add(p);
        }
        covered_ = swath_.covered();
        const LineExchange given = e;
        e.waste = std::numeric_limits<double>::infinity();
        for (const int slip : slips)
            for (const double cut_a : cuts)
                for (const double cut_b : cuts) {
                    LineExchange now = given;
                    now.at_b += slip * rules::kGrain * d_;
                    now.cut_a = cut_a * d_;
                    now.cut_b = cut_b * d_;
                    if (!free(now)) continue;
                    now.waste = waste(view, now);
                    if (now.waste < e.waste - rules::kSamePoint) e = now;
                }
    }

    [[nodiscard]] bool kept(const Surroundings::LinePoint& bead, const LineExchange& e) const {
        return (bead.line != e.a || beads_.off(e.a, bead.arc, e.at_a) > e.cut_a) &&
               (bead.line != e.b || beads_.off(e.b, bead.arc, e.at_b) > e.cut_b);
    }

    // mm of the polyline that turn tighter than the radius: its angles, as turns of half a spacing.
    [[nodiscard]] double tight(std::span<const Vec2> line) const {
        double out = 0;
        for (std::size_t i = 2; i < line.size(); ++i) {
            const Vec2 u = line[i - 1] - line[i - 2], v = line[i] - line[i - 1];
            const double angle = std::abs(std::atan2(cross(u, v), dot(u, v)));
            if (angle * radius_ > (norm(u) + norm(v)) / 2) out += angle * d_ / 2;
        }
        return out;
    }

    // Additional void, overlap and tight turns, mm2. Overlap is the area of beads less the covered area.
    [[nodiscard]] double waste(const Surroundings& view, const LineExchange& e) {
        const TurnPair t = turn_pair(view.chart, e);
        swath_ = rest_;
        double turns = tight(t.there) + tight(t.back);
        std::vector<Vec2> cut;
        for (const auto& bead : view.beads) {
            if (bead.line != e.a && bead.line != e.b) continue;
            if (kept(bead, e)) {
                turns -= tight(cut);
                cut.clear();
                swath_.add(bead.p);
            } else {
                cut.push_back(bead.p);
            }
        }
        turns -= tight(cut);
        for (const auto* line : {&t.there, &t.back})
            for (const Vec2& p : *line) swath_.add(p);
        return d_ * (longer(e, t) + turns) + 2 * (covered_ - swath_.covered());
    }

    // Whether a turn crosses another line or the other turn.
    [[nodiscard]] bool crosses(const Surroundings& view, const LineExchange& e, const TurnPair& t) const {
        const auto cross = [](std::span<const Vec2> line, Vec2 a, Vec2 b) {
            for (std::size_t i = 1; i < line.size(); ++i)
                if (geom::cross_properly(line[i - 1], line[i], a, b)) return true;
            return false;
        };
        for (std::size_t i = 1; i < view.beads.size(); ++i) {
            const auto &a = view.beads[i - 1], &b = view.beads[i];
            if (a.line != b.line || b.arc - a.arc > 1.5 * rules::kFineGrain * d_ || !kept(a, e) || !kept(b, e))
                continue;
            if (cross(t.there, a.p, b.p) || cross(t.back, a.p, b.p)) return true;
        }
        for (std::size_t i = 1; i < t.back.size(); ++i)
            if (cross(t.there, t.back[i - 1], t.back[i])) return true;
        return false;
    }

    // Makes the exchange. Returns false if the turns leave the surface or cross other lines.
    bool take(const Surroundings& view, const LineExchange& e) {
        const TurnPair t = turn_pair(view.chart, e);
        if (crosses(view, e, t)) return false;
        const double a0 = e.at_a - e.cut_a, a1 = e.at_a + e.cut_a, b0 = e.at_b - e.cut_b, b1 = e.at_b + e.cut_b;
        auto there = on_surface(view.chart, t.there, lanes_.at(e.a, a0), lanes_.at(e.b, t.same ? b0 : b1));
        auto back = on_surface(view.chart, t.back, lanes_.at(e.b, t.same ? b1 : b0), lanes_.at(e.a, a1));
        if (there.size() < 2 || back.size() < 2) return false;
        beads_.cut(e.a, e.at_a, e.cut_a);
        beads_.cut(e.b, e.at_b, e.cut_b);
        beads_.add(there);
        beads_.add(back);
        auto& groups = linked_.groups();
        const bool anchored = anchored_[groups.root(e.a)] != 0 || anchored_[groups.root(e.b)] != 0;
        surface::curve::reverse(back);
        linked_.exchange({e.a, a0, a1}, {e.b, b0, b1}, t.same, {std::move(there), std::move(back)});
        char& root = anchored_[groups.root(e.a)];
        if (anchored && root == 0) root = 2;
        return true;
    }

    // The turn on the surface; empty if it leaves that.
    [[nodiscard]] Line on_surface(const surface::curve::Chart& chart, std::vector<Vec2> turn, const Place& from,
                                  const Place& to) const {
        turn.front() = chart.to(from.point);
        turn.back() = chart.to(to.point);
        auto out = surface::curve::from_chart(s_, chart, from, turn);
        if (!out.whole || distance(out.line.places.back().point, to.point) > rules::kSamePoint) return {};
        out.line.places.back() = to;
        return std::move(out.line);
    }

    struct MoreWaste {
        bool operator()(const LineExchange& x, const LineExchange& y) const {
            return std::tie(x.waste, x.a, x.at_a, x.b) > std::tie(y.waste, y.a, y.at_a, y.b);
        }
    };

    const Surface& s_;
    const std::vector<Line>& given_;
    double d_, ends_, radius_;
    // mm: within which coverage can change: the longest cut, the bulge of a turn beyond it, half a bead
    double half_ = (kCuts[5] + rules::kGrain + 0.5 + 0.5) * d_;
    lanes::Lanes lanes_;
    lanes::LinkedLanes linked_;
    std::vector<Vec3> normals_;
    std::vector<char>
        anchored_; // per group, at its root: 1 if the line only takes in others, 2 if one of the group does
    Swath swath_, rest_;
    double covered_ = 0; // mm2 of the swath before the exchange
    BeadMap beads_;
    std::priority_queue<LineExchange, std::vector<LineExchange>, MoreWaste> queue_;
};

} // namespace

ExchangeResult exchange_loops(const Surface& s, std::vector<Line>& lines, std::span<const char> keep,
                              const ExchangeOptions& options) {
    std::vector<std::uint32_t> which;
    std::vector<Line> there;
    std::vector<char> kept;
    for (std::uint32_t i = 0; i < lines.size(); ++i) {
        if (lines[i].size() < 2) continue;
        which.push_back(i);
        there.push_back(lines[i]);
        kept.push_back(keep[i]);
    }
    if (std::none_of(there.begin(), there.end(), [](const Line& l) { return l.closed; })) return {};
    LineExchanger exchanger(s, there, kept, options);
    const ExchangeResult out = exchanger.run();
    auto made = exchanger.lines();
    if (out.count > 0)
        for (std::size_t i = 0; i < which.size(); ++i) lines[which[i]] = std::move(made[i]);
    return out;
}

} // namespace filum::surfpath::rows
