#include "surfpath/rings.hpp"

#include "base/error.hpp"
#include "geodesic/beyond.hpp"
#include "geodesic/exact.hpp"
#include "geodesic/query.hpp"
#include "parallel/parallel.hpp"
#include "surfpath/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <map>
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
    for (const surface::Segment& side : surface::rim_sources(s).segments)
        if (!std::binary_search(have.begin(), have.end(), side, less)) out.segments.push_back(side);
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

class Making {
  public:
    Making(const surface::Sheet& sheet, const Options& o)
        : s_(sheet.surface), field_(geodesic::exact(s_, all_sources(sheet))), least_(kRounder * o.least_radius) {
        farthest_ = geodesic::farthest(s_, field_);
        if (farthest_ > kFarthestPlace * o.spacing)
            throw Error(Exit::usage, "cannot lay more than 10000 rings inside each other; raise --spacing");
        for (const double d : {stretched(farthest_, o.spacing), (1 - kNarrowerSpacing / 2) * o.spacing}) {
            d_ = d;
            levels_.clear();
            for (double l = d / 2; l < farthest_; l += d) levels_.push_back(l);
            levels_ = off_vertices(std::move(levels_), field_.distance, d);
            begins_.clear();
            outer_ = geodesic::isolines(s_, field_, levels_, &begins_);
            if (d <= o.spacing || one_ridge()) break; // so there is no harm to others
        }
    }

    Rings run() {
        find_batches();
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
        std::vector<Level> found(levels_.size());
        parallel::for_chunks(levels_.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) found[i] = batches_at(levels_[i]);
        });
        for (Level& level : found) {
            std::move(level.batches.begin(), level.batches.end(), std::back_inserter(batches_));
            inner_.push_back(std::move(level.inner));
        }
    }

    // The batches of one level, by the parts of the surface that their rings go round, and what lies a radius within
    // each.
    struct Level {
        std::vector<Batch> batches{};
        std::vector<Isoline> inner{};
    };
    [[nodiscard]] Level batches_at(double level) const {
        const geodesic::Beyond beyond(s_, field_, level);
        Level out;
        std::vector<std::vector<std::uint32_t>> parts; // per batch
        Batch high{level, {}, {}};
        std::vector<std::uint32_t> high_parts;
        for (const double share : kScales) high.scales.push_back({share * least_});
        for (std::size_t i = 0; i < outer_.size(); ++i) {
            if (!outer_[i].closed || outer_[i].level != level) continue;
            const std::uint32_t part = beyond.part(begins_[i]);
            if (part == kNone) continue;
            const double rise = beyond.highest(part) - level, radius = kOfRidge * rise;
            if (rise > least_) {
                high.outer.push_back(&outer_[i]);
                high_parts.push_back(part);
                continue;
            }
            if (radius < kTightest * d_) continue;
            const auto own =
                static_cast<std::size_t>(std::find(parts.begin(), parts.end(), std::vector{part}) - parts.begin());
            if (own == parts.size()) {
                parts.push_back({part});
                out.batches.push_back({level, {}, {{radius}, {0.6 * radius}, {0.35 * radius}, {0.2 * least_}}});
            }
            out.batches[own].outer.push_back(&outer_[i]);
        }
        if (!high.outer.empty()) {
            out.batches.push_back(std::move(high));
            parts.push_back(std::move(high_parts));
        }
        find_inner(beyond, level, parts, out);
        return out;
    }

    void find_inner(const geodesic::Beyond& beyond, double level, const std::vector<std::vector<std::uint32_t>>& parts,
                    Level& out) const {
        std::vector<double> levels;
        for (const auto& b : out.batches)
            for (const auto& scale : b.scales) levels.push_back(level + scale.radius);
        std::sort(levels.begin(), levels.end());
        levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
        std::vector<geodesic::OnEdge> begins;
        out.inner = geodesic::isolines(s_, field_, levels, &begins);
        for (std::size_t i = 0; i < out.inner.size(); ++i) {
            if (!out.inner[i].closed) continue;
            const std::uint32_t part = beyond.part(begins[i]);
            for (std::size_t b = 0; b < out.batches.size(); ++b) {
                if (std::find(parts[b].begin(), parts[b].end(), part) == parts[b].end()) continue;
                for (auto& scale : out.batches[b].scales)
                    if (level + scale.radius == out.inner[i].level) scale.inner.push_back(&out.inner[i]);
            }
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
    double least_, farthest_ = 0, d_ = 0;
    std::vector<double> levels_;
    std::vector<Isoline> outer_;
    std::vector<geodesic::OnEdge> begins_; // per outer line
    std::vector<std::vector<Isoline>> inner_;
    std::vector<Batch> batches_;
    std::map<double, double> floor_; // mm: per level, the least radius
};

} // namespace

Rings rings(const surface::Sheet& sheet, const Options& o, Facts& facts) {
    Rings out = Making(sheet, o).run();
    if (out.lines.empty())
        throw Error(
            Exit::bad_input,
            "cannot lay a ring: nowhere between the sources is there room for one, half a spacing from them and round "
            "a third of one; lower --spacing");
    facts.push_back({"", "rings", static_cast<double>(out.lines.size()), ""});
    facts.push_back({"", "stretch", out.spacing / o.spacing, ""});
    return out;
}

} // namespace filum::surfpath
