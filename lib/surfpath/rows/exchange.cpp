#include "surfpath/rows/exchange.hpp"

#include "geom/disjoint_sets.hpp"
#include "geom/polyline.hpp"
#include "geom/segment.hpp"
#include "surfpath/lanes/weave.hpp"
#include "surfpath/rows/beads.hpp"
#include "surfpath/rows/swath.hpp"
#include "surfpath/rows/turn.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <queue>

namespace filum::surfpath::rows {

namespace {

using geom::Vec2;

// Lengths in spacings.
// Between the points by which lines are judged: so what is half a spacing from a line is off by .4 % of that.
constexpr double kBeadGrain = 0.125;
// How far from each other lines side by side are, at most: from there on another one fits between.
constexpr double kBesideAt = 2;
// Half of what is cut of each, tried: from tips that lead straight on to a gap that turns just leave bare.
constexpr double kCuts[] = {0.4, 0.6, 0.8, 1, 1.2, 1.4};
// Likewise, by which places are ranked first: two half turns are as long as what they replace.
constexpr double kFirstCut = std::numbers::pi / 4;
constexpr double kPlacesApart = 0.5;                                  // between places that are tried
constexpr double kSlips[] = {0, -kPlacesApart / 2, kPlacesApart / 2}; // of one line along the other: half way there
// How far about a place what is covered can change: the farthest cut, what a turn bulges beyond it, half a bead.
constexpr double kSwathHalf = kCuts[5] + kPlacesApart / 2 + 0.5 + 0.5;
constexpr std::size_t kMostTried = 12; // places of two lines that are judged by what they waste: a limit of work
constexpr double kSameWaste = 1e-6;    // mm, mm2: less is rounding

// Where two lines are to be cut: about these ways, by half of the cuts to both sides.
struct Exchange {
    double waste = 0; // mm2
    std::uint32_t a = 0, b = 0;
    double at_a = 0, at_b = 0, cut_a = 0, cut_b = 0; // mm
    bool judged = false;                             // `waste` is that of the best cuts
};

// Two lines from the first line to the other and back, on a chart.
struct Turns {
    std::vector<Vec2> there, back;
    bool same = true; // the lines run the same way
};

class Exchanger {
  public:
    Exchanger(const Surface& s, const std::vector<Line>& lines, std::span<const char> keep, const Exchanges& o)
        : s_(s), given_(lines), d_(o.spacing), ends_(o.ends), lanes_(s, closed(lines), o.spacing), weave_(lanes_),
          sets_(lines.size()), normals_(surface::curve::vertex_normals(s)), anchored_(lines.size(), 0),
          swath_(o.spacing, kSwathHalf * o.spacing), rest_(swath_), beads_(s, lines, lanes_, kBeadGrain * o.spacing) {
        for (std::uint32_t l = 0; l < lines.size(); ++l) {
            anchored_[l] = keep[l] != 0 || !lines[l].closed ? 1 : 0;
            if (!lines[l].closed) weave_.cut(l, beads_.length(l), 0);
        }
    }

    Exchanged run() {
        Exchanged out;
        propose();
        while (!queue_.empty()) {
            Exchange e = queue_.top();
            queue_.pop();
            if (!open(e)) continue;
            const View view = look(lanes_.at(e.a, e.at_a));
            const bool sure = e.judged;
            const double before = e.waste;
            judge(view, e, kCuts, kSlips);
            e.judged = true;
            if (!sure || e.waste > before + kSameWaste) { // what was taken since may be in the way
                propose(e);
            } else if (take(view, e)) {
                ++out.count;
                out.waste += e.waste;
            }
        }
        return out;
    }

    // Every line that took others in, with them; what was taken in empty.
    [[nodiscard]] std::vector<Line> lines() {
        std::vector<Line> out = given_;
        for (auto& course : weave_.courses()) {
            if (course.lanes.size() < 2) continue;
            std::uint32_t host = course.lanes[0];
            for (const std::uint32_t l : course.lanes) {
                out[l].places.clear();
                if (anchored_[l] == 1) host = l;
            }
            course.line.closed = course.closed;
            if (course.closed)
                course.line.places.pop_back(); // the first one again
            else if (distance(course.line[0], given_[host][0]) > kSameWaste)
                surface::curve::reverse(course.line);
            out[host] = std::move(course.line);
        }
        return out;
    }

  private:
    static std::vector<Line> closed(std::vector<Line> lines) {
        for (Line& l : lines) l.closed = true;
        return lines;
    }

    // Whether the two may still become one.
    [[nodiscard]] bool open(const Exchange& e) {
        const auto a = sets_.root(e.a), b = sets_.root(e.b);
        return a != b && (anchored_[a] == 0 || anchored_[b] == 0);
    }

    // All places that lines might be joined at, the best few of every two lines.
    void propose() {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Exchange>> found;
        for (std::uint32_t a = 0; a < given_.size(); ++a) {
            if (!given_[a].closed) continue;
            const auto n = static_cast<std::size_t>(std::ceil(beads_.length(a) / (kPlacesApart * d_)));
            for (std::size_t i = 0; i < n; ++i)
                for (Exchange& e : beside(a, beads_.length(a) * static_cast<double>(i) / static_cast<double>(n)))
                    if (open(e)) found[std::minmax(e.a, e.b)].push_back(e);
        }
        for (auto& [pair, all] : found) {
            std::stable_sort(all.begin(), all.end(),
                             [](const Exchange& x, const Exchange& y) { return x.waste < y.waste; });
            if (all.size() > kMostTried) all.resize(kMostTried);
            for (Exchange& e : all) {
                judge(look(lanes_.at(e.a, e.at_a)), e, std::span(&kFirstCut, 1), std::span(kSlips, 1));
                propose(e);
            }
        }
    }

    void propose(const Exchange& e) {
        if (e.waste < kCrossingWastes * d_ * d_) queue_.push(e);
    }

    // One for every line beside this place, by how much longer the lines get; as if nothing else lay about.
    [[nodiscard]] std::vector<Exchange> beside(std::uint32_t a, double way) const {
        const Place at = lanes_.at(a, way);
        const auto chart = chart_at(at);
        std::vector<Exchange> out;
        for (const Bead& bead : beads_.beside(a, at.point, chart.normal, kBesideAt * d_)) {
            out.push_back({0, a, bead.line, way, bead.way, kFirstCut * d_, kFirstCut * d_});
            out.back().waste = d_ * longer(out.back(), turns(chart, out.back()));
        }
        return out;
    }

    [[nodiscard]] surface::curve::Chart chart_at(const Place& at) const {
        const Vec3 normal = surface::curve::normal_at(s_, normals_, at);
        const Vec3& corner = s_.vertices[s_.triangles[at.triangle][0]];
        const Vec3& next = s_.vertices[s_.triangles[at.triangle][1]];
        return surface::curve::chart(at, normal, next - corner);
    }

    // What lies within the square of the swath, and half a bead about it.
    [[nodiscard]] View look(const Place& at) const {
        return beads_.look(chart_at(at), (std::numbers::sqrt2 * kSwathHalf + 0.5) * d_);
    }

    [[nodiscard]] double longer(const Exchange& e, const Turns& t) const {
        return geom::length(t.there) + geom::length(t.back) - 2 * e.cut_a - 2 * e.cut_b;
    }

    // Where a line is, and how it runs there: unit, or 0.
    struct Going {
        Vec2 p, t;
    };
    [[nodiscard]] Going going(const surface::curve::Chart& chart, std::uint32_t line, double way) const {
        const Vec2 p = chart.to(lanes_.at(line, way).point), a = chart.to(lanes_.at(line, way - kBeadGrain * d_).point),
                   b = chart.to(lanes_.at(line, way + kBeadGrain * d_).point);
        const double l = distance(a, b);
        return {p, l > 0 ? 1 / l * (b - a) : Vec2{}};
    }

    [[nodiscard]] Turns turns(const surface::curve::Chart& chart, const Exchange& e) const {
        Turns out;
        out.same = dot(going(chart, e.a, e.at_a).t, going(chart, e.b, e.at_b).t) >= 0;
        const Going a0 = going(chart, e.a, e.at_a - e.cut_a), a1 = going(chart, e.a, e.at_a + e.cut_a),
                    b0 = going(chart, e.b, e.at_b - e.cut_b), b1 = going(chart, e.b, e.at_b + e.cut_b);
        const double step = kBeadGrain * d_;
        if (out.same) {
            out.there = led(a0.p, a0.t, b0.p, -1 * b0.t, step);
            out.back = led(b1.p, -1 * b1.t, a1.p, a1.t, step);
        } else {
            out.there = led(a0.p, a0.t, b1.p, b1.t, step);
            out.back = led(b0.p, b0.t, a1.p, a1.t, step);
        }
        return out;
    }

    // Whether both lines are there to be cut.
    [[nodiscard]] bool free(const Exchange& e) const {
        const auto there = [&](std::uint32_t line, double at, double cut) {
            const double all = beads_.length(line);
            const bool inside = given_[line].closed || (at - cut >= ends_ && at + cut <= all - ends_);
            return inside && 2 * cut + 2 * d_ <= all && beads_.whole(line, at, cut, kBeadGrain * d_);
        };
        return there(e.a, e.at_a, e.cut_a) && there(e.b, e.at_b, e.cut_b);
    }

    // Of these cuts and places of the other line those that waste least; infinite if none are possible.
    void judge(const View& view, Exchange& e, std::span<const double> cuts, std::span<const double> slips) {
        swath_.clear();
        rest_.clear();
        for (const auto& bead : view.beads) {
            swath_.add(bead.p);
            if (bead.line != e.a && bead.line != e.b) rest_.add(bead.p);
        }
        for (const Vec2& p : view.laid) {
            swath_.add(p);
            rest_.add(p);
        }
        covered_ = swath_.covered();
        const Exchange given = e;
        e.waste = std::numeric_limits<double>::infinity();
        for (const double slip : slips)
            for (const double cut_a : cuts)
                for (const double cut_b : cuts) {
                    Exchange now = given;
                    now.at_b += slip * d_;
                    now.cut_a = cut_a * d_;
                    now.cut_b = cut_b * d_;
                    if (!free(now)) continue;
                    now.waste = waste(view, now);
                    if (now.waste < e.waste - kSameWaste) e = now;
                }
    }

    [[nodiscard]] bool kept(const View::At& bead, const Exchange& e) const {
        return (bead.line != e.a || beads_.off(e.a, bead.way, e.at_a) > e.cut_a) &&
               (bead.line != e.b || beads_.off(e.b, bead.way, e.at_b) > e.cut_b);
    }

    // What is left bare and laid twice more than now.  What is laid twice is what is laid less what is covered.
    [[nodiscard]] double waste(const View& view, const Exchange& e) {
        const Turns t = turns(view.chart, e);
        swath_ = rest_;
        for (const auto& bead : view.beads)
            if ((bead.line == e.a || bead.line == e.b) && kept(bead, e)) swath_.add(bead.p);
        for (const auto* line : {&t.there, &t.back})
            for (const Vec2& p : *line) swath_.add(p);
        return d_ * longer(e, t) + 2 * (covered_ - swath_.covered());
    }

    // Whether a turn crosses what is there, or the other one.
    [[nodiscard]] bool crosses(const View& view, const Exchange& e, const Turns& t) const {
        const auto cross = [](std::span<const Vec2> line, Vec2 a, Vec2 b) {
            for (std::size_t i = 1; i < line.size(); ++i)
                if (geom::cross_properly(line[i - 1], line[i], a, b)) return true;
            return false;
        };
        for (std::size_t i = 1; i < view.beads.size(); ++i) {
            const auto &a = view.beads[i - 1], &b = view.beads[i];
            if (a.line != b.line || b.way - a.way > 1.5 * kBeadGrain * d_ || !kept(a, e) || !kept(b, e)) continue;
            if (cross(t.there, a.p, b.p) || cross(t.back, a.p, b.p)) return true;
        }
        for (std::size_t i = 1; i < t.back.size(); ++i)
            if (cross(t.there, t.back[i - 1], t.back[i])) return true;
        return false;
    }

    // False if the turns lead over nothing, or over other lines.
    bool take(const View& view, const Exchange& e) {
        const Turns t = turns(view.chart, e);
        if (crosses(view, e, t)) return false;
        const double a0 = e.at_a - e.cut_a, a1 = e.at_a + e.cut_a, b0 = e.at_b - e.cut_b, b1 = e.at_b + e.cut_b;
        const auto there = laid(view.chart, t.there, lanes_.at(e.a, a0), lanes_.at(e.b, t.same ? b0 : b1));
        const auto back = laid(view.chart, t.back, lanes_.at(e.b, t.same ? b1 : b0), lanes_.at(e.a, a1));
        if (there.size() < 2 || back.size() < 2) return false;
        const auto a = weave_.cut(e.a, a0, a1), b = weave_.cut(e.b, b0, b1);
        weave_.link({a, false}, {b, !t.same}, there);
        weave_.link({b, t.same}, {a, true}, back);
        beads_.cut(e.a, e.at_a, e.cut_a);
        beads_.cut(e.b, e.at_b, e.cut_b);
        beads_.lay(there);
        beads_.lay(back);
        const bool anchored = anchored_[sets_.root(e.a)] != 0 || anchored_[sets_.root(e.b)] != 0;
        sets_.unite(e.a, e.b);
        char& root = anchored_[sets_.root(e.a)];
        if (anchored && root == 0) root = 2;
        return true;
    }

    // The turn on the surface; empty if it does not lead there.
    [[nodiscard]] Line laid(const surface::curve::Chart& chart, std::vector<Vec2> turn, const Place& from,
                            const Place& to) const {
        turn.front() = chart.to(from.point);
        turn.back() = chart.to(to.point);
        auto out = surface::curve::lay(s_, chart, from, turn);
        if (!out.whole || distance(out.line.places.back().point, to.point) > kSameWaste) return {};
        out.line.places.back() = to;
        return std::move(out.line);
    }

    struct Later {
        bool operator()(const Exchange& x, const Exchange& y) const {
            return std::tie(x.waste, x.a, x.at_a, x.b) > std::tie(y.waste, y.a, y.at_a, y.b);
        }
    };

    const Surface& s_;
    const std::vector<Line>& given_;
    double d_, ends_;
    lanes::Lanes lanes_;
    lanes::Weave weave_;
    geom::DisjointSets sets_;
    std::vector<Vec3> normals_;
    std::vector<char> anchored_; // per line; of a set that of its root: 1 if it takes in others only, 2 if a line of it
    Swath swath_, rest_;
    double covered_ = 0; // mm2 of the swath, before anything changes
    Beads beads_;
    std::priority_queue<Exchange, std::vector<Exchange>, Later> queue_;
};

} // namespace

Exchanged exchange_loops(const Surface& s, std::vector<Line>& lines, std::span<const char> keep,
                         const Exchanges& options) {
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
    Exchanger exchanger(s, there, kept, options);
    const Exchanged out = exchanger.run();
    auto made = exchanger.lines();
    if (out.count > 0)
        for (std::size_t i = 0; i < which.size(); ++i) lines[which[i]] = std::move(made[i]);
    return out;
}

} // namespace filum::surfpath::rows
