#include "surfpath/rings.hpp"

#include "base/error.hpp"
#include "geodesic/exact.hpp"
#include "geodesic/isolines.hpp"
#include "parallel/parallel.hpp"
#include "surfpath/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace filum::surfpath {

namespace {

using surface::kNone;

constexpr double kWiderSpacing = 0.008, kNarrowerSpacing = 0.03; // of the spacing
constexpr double kOfRidge = 0.9;  // of the way to the ridge that a turn of a ring takes, where the ridge is near
constexpr double kRounder = 1.08; // least radii: what corners are rounded by, so that little remains to be eased
constexpr double kScales[] = {1, 0.65, 0.4, 0.2}; // of the least radius, that corners are rounded by
constexpr double kGains[] = {1,   1.3, 1.7, 2,  2.3,
                             2.6, 2.9, 3.2, 3.5};   // least radii of length for a radian of tight turn
constexpr double kTightPart = 0.01, kTighter = 0.8; // of the length, may turn tighter by so much on average
constexpr double kFall = 1.1;                       // spacings that radii may fall by from one level to the next
constexpr double kFarthestPlace = 1e4;              // spacings from the sources to the farthest place
constexpr double kTightest = 0.3;                   // spacings: no ring turns tighter
constexpr double kSameLevel = 1e-7;                 // spacings: a level that is a vertex's distance,
constexpr double kLevelShift = 1e-5;                // and is moved from it by this

// The sources, and all sides of rims that are none yet.
surface::Sources all_sources(const surface::Sheet& sheet) {
    const Surface& s = sheet.surface;
    surface::Sources out = sheet.sources;
    const auto key = [](const surface::Segment& g) {
        return std::tie(g.triangle, g.a.x, g.a.y, g.a.z, g.b.x, g.b.y, g.b.z);
    };
    const auto less = [&](const surface::Segment& x, const surface::Segment& y) { return key(x) < key(y); };
    auto have = out.segments;
    std::sort(have.begin(), have.end(), less);
    for (const auto& rim : s.rims)
        for (const auto h : rim.sides) {
            const surface::Segment side{h / 3, s.vertices[s.tail(h)], s.vertices[s.head(h)]};
            if (!std::binary_search(have.begin(), have.end(), side, less)) out.segments.push_back(side);
        }
    if (out.empty())
        throw Error(Exit::bad_input, "cannot lay rings on a closed surface without a source; run geodesic --source "
                                     "vertex:ID (or another) first");
    return out;
}

// The levels, each a little higher where that is just the distance of a vertex, as on a grid: there isolines fall apart
// by rounding.
std::vector<double> off_vertices(std::vector<double> levels, std::vector<double> distance, double spacing) {
    std::sort(distance.begin(), distance.end());
    for (double& level : levels)
        while (true) {
            const auto near = std::lower_bound(distance.begin(), distance.end(), level - kSameLevel * spacing);
            if (near == distance.end() || *near > level + kSameLevel * spacing) break;
            level = *near + kLevelShift * spacing;
        }
    return levels;
}

// The spacing near `d` for which the farthest place is a whole number of them and a half away; if there is none, one
// that is a little less than `d`, which wins more of the gaps at corners than it loses.
double stretched(double farthest, double d) {
    const double n = std::max(0.0, std::floor(farthest / d - 0.5)) + 0.5;
    for (const double fits : {farthest / n, farthest / (n + 1)})
        if (fits <= (1 + kWiderSpacing) * d && fits >= (1 - kNarrowerSpacing) * d) return fits;
    return (1 - kNarrowerSpacing / 2) * d;
}

// The highest vertex of the triangles that a line runs through; kNone if none is as high as the line.
std::uint32_t top(const Surface& s, const std::vector<double>& far, const Isoline& line) {
    std::uint32_t out = kNone;
    for (const auto t : line.triangles)
        for (const auto v : s.triangles[t])
            if (far[v] >= line.level && (out == kNone || far[v] > far[out] || (far[v] == far[out] && v < out))) out = v;
    return out;
}

// From where to find the highest vertex that can be reached without going below a level.
struct Climb {
    double level;
    std::uint32_t from;       // kNone: leads nowhere
    std::uint32_t to = kNone; // found
};
void climb(const Surface& s, const std::vector<double>& far, std::vector<Climb>& climbs) {
    const auto higher = [&](std::uint32_t a, std::uint32_t b) { return far[a] != far[b] ? far[a] > far[b] : a < b; };
    std::vector<std::uint32_t> order(far.size()), root(far.size()), turn(climbs.size());
    std::iota(order.begin(), order.end(), 0U);
    std::iota(root.begin(), root.end(), 0U);
    std::iota(turn.begin(), turn.end(), 0U);
    std::sort(order.begin(), order.end(), higher);
    std::stable_sort(turn.begin(), turn.end(), [&](auto a, auto b) { return climbs[a].level > climbs[b].level; });
    const auto find = [&](std::uint32_t v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    std::size_t at = 0;
    for (const auto i : turn) {
        Climb& c = climbs[i];
        for (; at < order.size() && far[order[at]] >= c.level; ++at)
            surface::each_outgoing(s, order[at], [&](std::uint32_t h) {
                for (const auto v : {s.head(h), s.tail(surface::prev(h))}) {
                    if (!(far[v] >= c.level)) continue;
                    const auto a = find(v), b = find(order[at]);
                    if (a != b) root[higher(a, b) ? b : a] = higher(a, b) ? a : b;
                }
            });
        if (c.from != kNone) c.to = find(c.from);
    }
}

class Making {
  public:
    Making(const surface::Sheet& sheet, const Options& o)
        : s_(sheet.surface), field_(geodesic::exact(s_, all_sources(sheet))), far_(field_.distance),
          least_(kRounder * o.least_radius) {
        for (const double d : far_)
            if (std::isfinite(d)) farthest_ = std::max(farthest_, d);
        if (farthest_ > kFarthestPlace * o.spacing)
            throw Error(Exit::usage, "cannot lay more than 10000 rings inside each other; raise --spacing");
        for (const double d : {stretched(farthest_, o.spacing), (1 - kNarrowerSpacing / 2) * o.spacing}) {
            d_ = d;
            levels_.clear();
            for (double l = d / 2; l < farthest_; l += d) levels_.push_back(l);
            levels_ = off_vertices(std::move(levels_), far_, d);
            outer_ = geodesic::isolines(s_, field_, levels_);
            if (d <= o.spacing || one_ridge()) break; // so there is no harm to others
        }
    }

    Rings run() {
        find_batches();
        find_inner();
        const Rounding rounding(s_, field_, least_, d_);
        each([&](Batch& b) { rounding.prepare(b); });
        const double gain = affordable(rounding);
        each([&](Batch& b) { rounding.finish(b, gain, floor_.at(b.level)); });
        Rings out;
        out.spacing = d_;
        for (auto& b : batches_)
            for (auto& line : b.lines) {
                out.lines.push_back(std::move(line));
                out.level.push_back(static_cast<int>(std::lround(b.level / d_ - 0.5)));
                out.radius.push_back(b.scales[0].radius);
            }
        return out;
    }

  private:
    // True if no level has two rings, but near its top.
    [[nodiscard]] bool one_ridge() const {
        for (std::size_t i = 1; i < outer_.size(); ++i)
            if (outer_[i].level == outer_[i - 1].level && outer_[i].level < farthest_ - least_) return false;
        return true;
    }

    template <class F>
    void each(const F& f) {
        parallel::for_chunks(batches_.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) f(batches_[i]);
        });
    }

    // Rings by level, those within low ridges apart.
    void find_batches() {
        std::vector<Climb> climbs;
        for (const auto& line : outer_) climbs.push_back({line.level, top(s_, far_, line)});
        climb(s_, far_, climbs);
        for (const double l : levels_) {
            Batch high{l, {}, {}};
            for (const double part : kScales) high.scales.push_back({part * least_});
            std::vector<std::uint32_t> high_tops;
            const std::size_t first = batches_.size();
            for (std::size_t i = 0; i < outer_.size(); ++i) {
                if (!outer_[i].closed || outer_[i].level != l || climbs[i].to == kNone) continue;
                const double rise = far_[climbs[i].to] - l, radius = kOfRidge * rise;
                if (rise > least_) {
                    high.outer.push_back(&outer_[i]), high_tops.push_back(climbs[i].to);
                    continue;
                }
                if (radius < kTightest * d_) continue;
                std::size_t own = batches_.size(); // of the rings about the same top
                while (own > first && tops_[own - 1][0] != climbs[i].to) --own;
                if (own > first) {
                    batches_[own - 1].outer.push_back(&outer_[i]);
                    continue;
                }
                batches_.push_back({l, {&outer_[i]}, {{radius}, {0.6 * radius}, {0.35 * radius}, {0.2 * least_}}});
                tops_.push_back({climbs[i].to});
            }
            if (!high.outer.empty()) batches_.push_back(std::move(high)), tops_.push_back(std::move(high_tops));
        }
    }

    // What lies a radius within each batch.
    void find_inner() {
        std::vector<double> levels;
        for (const auto& b : batches_)
            for (const auto& scale : b.scales) levels.push_back(b.level + scale.radius);
        std::sort(levels.begin(), levels.end());
        levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
        inner_ = geodesic::isolines(s_, field_, levels);
        struct Use {
            std::size_t batch, scale;
            const Isoline* line;
        };
        std::vector<Use> uses;
        std::vector<Climb> climbs;
        for (std::size_t b = 0; b < batches_.size(); ++b)
            for (std::size_t k = 0; k < batches_[b].scales.size(); ++k) {
                const double level = batches_[b].level + batches_[b].scales[k].radius;
                auto at = std::lower_bound(inner_.begin(), inner_.end(), level,
                                           [](const Isoline& l, double x) { return l.level < x; });
                for (; at != inner_.end() && at->level == level; ++at)
                    if (at->closed)
                        uses.push_back({b, k, &*at}), climbs.push_back({batches_[b].level, top(s_, far_, *at)});
            }
        climb(s_, far_, climbs);
        for (std::size_t i = 0; i < uses.size(); ++i) {
            const auto& t = tops_[uses[i].batch];
            if (std::find(t.begin(), t.end(), climbs[i].to) != t.end())
                batches_[uses[i].batch].scales[uses[i].scale].inner.push_back(uses[i].line);
        }
    }

    // How much too tight all turn, rad; finds the floors.  From one level to the next radii may fall by a spacing, or a
    // tip would reach over the one outside of it.
    double tight(const Rounding& rounding, double gain) {
        double out = 0, before = least_;
        floor_.clear();
        for (const double l : levels_) {
            const double floor = floor_[l] = before - kFall * d_;
            before = least_;
            for (const auto& b : batches_) {
                if (b.level != l) continue;
                const auto turns = rounding.turns(b, gain, floor);
                out += turns.tight;
                before = std::min(before, turns.least);
            }
        }
        return out;
    }

    // The least gain that is taken for tight turns, so that they do not make the tightest part of the path much
    // tighter.
    [[nodiscard]] double affordable(const Rounding& rounding) {
        double length = 0;
        for (const auto& line : outer_) length += surface::curve::length(surface::curve::line(line));
        const double most = kTightPart * length * kTighter / least_;
        for (const double gain : kGains)
            if (tight(rounding, gain) <= most) return gain;
        return kGains[std::size(kGains) - 1];
    }

    const Surface& s_;
    ExactField field_;
    const std::vector<double>& far_;
    double least_, farthest_ = 0, d_ = 0;
    std::vector<double> levels_;
    std::vector<Isoline> outer_, inner_;
    std::vector<Batch> batches_;
    std::map<double, double> floor_;               // mm: per level, the least radius
    std::vector<std::vector<std::uint32_t>> tops_; // per batch: where its rings lead up to
};

} // namespace

Rings rings(const surface::Sheet& sheet, const Options& o, Facts& facts) {
    Rings out = Making(sheet, o).run();
    if (out.lines.empty())
        throw Error(Exit::bad_input,
                    "cannot lay a ring: no vertex is farther than half a spacing from the sources; lower "
                    "--spacing, or make smaller triangles by geodesic --remesh");
    facts.push_back({"", "rings", static_cast<double>(out.lines.size()), ""});
    facts.push_back({"", "stretch", out.spacing / o.spacing, ""});
    return out;
}

} // namespace filum::surfpath
