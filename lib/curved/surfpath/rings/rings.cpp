#include "surfpath/rings/rings.hpp"

#include "base/error.hpp"
#include "geodesic/exact.hpp"
#include "geodesic/query.hpp"
#include "geodesic/superlevel_set.hpp"
#include "parallel/parallel.hpp"
#include "surfpath/rings/levels.hpp"
#include "surfpath/rings/rounding.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace filum::surfpath::rings {

namespace {

using surface::kNone;

// Spacings: least radius of a ring around a low ridge. Tuned: half a spacing leaves 0.06 of a ball without a line.
constexpr double kTightest = 0.3;
constexpr double kScales[] = {1, 0.65, 0.4, 0.2};    // radii of rounding, in least radii
constexpr double kGains[] = {1,   1.3, 1.7, 2,  2.3, // gains that are tried: least radii of length
                             2.6, 2.9, 3.2, 3.5};    // per radian of tight turn
// The sheet's sources, and all sides of rims that are not among them.
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

class RingMaker {
  public:
    RingMaker(const surface::Sheet& sheet, const RingLimits& limits, Facts& facts, Notes& notes)
        : s_(sheet.surface), field_(geodesic::exact(s_, all_sources(sheet))),
          least_(rules::kRounded * limits.least_radius), d_(limits.spacing) {
        if (geodesic::farthest(s_, field_) > rules::kMostLines * d_)
            throw Error(Exit::usage, "cannot plan more than 10000 nested rings; raise --spacing");
        levels_ = levels(s_, field_, {d_, least_, limits.ridge}, facts, notes);
    }

    Rings run() {
        const Rounding rounding(s_, field_, least_, d_);
        find_batches(rounding);
        const double gain = affordable(rounding);
        each([&](Batch& b) { rounding.finish(b, gain); });
        Rings out;
        for (auto& b : batches_)
            for (auto& line : b.lines) {
                out.lines.push_back(std::move(line));
                out.level.push_back(b.ring);
                out.radius.push_back(b.radii[0]);
            }
        return out;
    }

  private:
    template <class F>
    void each(const F& f) {
        parallel::for_chunks(batches_.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) f(batches_[i]);
        });
    }

    // Groups the isolines of every level into batches, those around low ridges separately.
    void find_batches(const Rounding& rounding) {
        std::vector<std::vector<Batch>> found(levels_.at.size());
        parallel::for_chunks(found.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) found[i] = batches_at(static_cast<std::uint32_t>(i), rounding);
        });
        for (auto& level : found) std::move(level.begin(), level.end(), std::back_inserter(batches_));
    }

    // The batches of one level.  Isolines around one superlevel component that is low share a batch.
    [[nodiscard]] std::vector<Batch> batches_at(std::uint32_t number, const Rounding& rounding) const {
        const double level = levels_.at[number];
        const std::uint32_t ring = levels_.ring[number];
        const geodesic::SuperlevelSet beyond(s_, field_, level);
        std::vector<Batch> out;
        std::vector<std::vector<std::uint32_t>> parts; // components of each batch
        Batch high{level, ring, {}, {}};
        std::vector<std::uint32_t> high_parts;
        for (const double share : kScales) high.radii.push_back(share * least_);
        const auto own_lines = std::equal_range(levels_.of.begin(), levels_.of.end(), number);
        const auto line = [&](auto at) { return static_cast<std::size_t>(at - levels_.of.begin()); };
        for (std::size_t i = line(own_lines.first); i < line(own_lines.second); ++i) {
            const std::uint32_t part = beyond.component(levels_.begins[i]);
            if (part == kNone) continue;
            // The middle of a disc must stay below the ridge, also of discs that are somewhat larger.
            const double rise = beyond.highest(part) - level, radius = rise / rules::kRounded;
            if (rise > least_) {
                high.outer.push_back(&levels_.lines[i]);
                high_parts.push_back(part);
                continue;
            }
            if (radius < kTightest * d_) continue;
            const auto own =
                static_cast<std::size_t>(std::find(parts.begin(), parts.end(), std::vector{part}) - parts.begin());
            if (own == parts.size()) {
                parts.push_back({part});
                out.push_back({level, ring, {}, {}});
                for (const double share : kScales) out.back().radii.push_back(share * radius);
            }
            out[own].outer.push_back(&levels_.lines[i]);
        }
        if (!high.outer.empty()) {
            out.push_back(std::move(high));
            parts.push_back(std::move(high_parts));
        }
        IsolinesByRadius by_radius;
        for (std::size_t b = 0; b < out.size(); ++b)
            rounding.prepare(out[b], [&](double r) { return within(beyond, parts[b], level + r, by_radius); });
        return out;
    }

    // Isolines by level, with their starts; only a few radii are needed.
    struct RadiusIsolines {
        std::vector<Isoline> lines{};
        std::vector<geodesic::EdgePlace> begins{};
    };
    using IsolinesByRadius = std::map<double, RadiusIsolines>;
    [[nodiscard]] std::vector<const Isoline*> within(const geodesic::SuperlevelSet& beyond,
                                                     const std::vector<std::uint32_t>& parts, double level,
                                                     IsolinesByRadius& by_radius) const {
        const auto [at, fresh] = by_radius.try_emplace(level);
        RadiusIsolines& found = at->second;
        if (fresh) found.lines = geodesic::isolines(s_, field_, {&level, 1}, &found.begins);
        std::vector<const Isoline*> out;
        for (std::size_t i = 0; i < found.lines.size(); ++i)
            if (found.lines[i].closed &&
                std::find(parts.begin(), parts.end(), beyond.component(found.begins[i])) != parts.end())
                out.push_back(&found.lines[i]);
        return out;
    }

    // The excess of all turns over the least radius, rad.
    [[nodiscard]] double tight(const Rounding& rounding, double gain) const {
        double out = 0;
        for (const Batch& b : batches_) out += rounding.tight(b, gain);
        return out;
    }

    // The least of the gains for which tight turns remain rare.
    [[nodiscard]] double affordable(const Rounding& rounding) const {
        double length = 0;
        for (const auto& line : levels_.lines) length += surface::curve::length(surface::curve::line(line));
        // As much as if a hundredth of the length turned twice as tightly.
        const double most = rules::kNegligible * length / least_;
        for (const double gain : kGains)
            if (tight(rounding, gain) <= most) return gain;
        return kGains[std::size(kGains) - 1];
    }

    const Surface& s_;
    ExactField field_;
    double least_, d_;
    Levels levels_;
    std::vector<Batch> batches_;
};

} // namespace

Rings rings(const surface::Sheet& sheet, const RingLimits& limits, Facts& facts, Notes& notes) {
    Rings out = RingMaker(sheet, limits, facts, notes).run();
    if (out.lines.empty())
        throw Error(Exit::bad_input, "cannot plan a ring: no place is half a spacing away from all sources and has "
                                     "room for a turn of a third of "
                                     "a spacing; lower --spacing");
    facts.push_back({"", "rings", static_cast<double>(out.lines.size()), ""});
    return out;
}

} // namespace filum::surfpath::rings
