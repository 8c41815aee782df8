#include "surfpath/stagger.hpp"

#include "parallel/parallel.hpp"
#include "surfpath/samples.hpp"
#include "surfpath/stretches.hpp"

#include <algorithm>

namespace filum::surfpath {

namespace {

constexpr double kSampleApart = 0.25;       // widths, between points: the steps by which turns go deeper
constexpr std::size_t kSampledAtOnce = 256; // triangles of a piece of work
constexpr int kMostSweeps = 20;             // over all turns; a few do

// A point that only turns may cover, and the ways (numbered over all turns) that do.
struct Contested {
    double area = 0;
    std::vector<std::uint32_t> ways;
};

std::vector<Contested> contested(const Surface& s, const Plan& fixed, const Plan& ways, double width) {
    const Stretches laid(s, fixed), maybe(s, ways);
    std::vector<std::vector<Contested>> parts((s.triangles.size() + kSampledAtOnce - 1) / kSampledAtOnce);
    parallel::for_chunks(s.triangles.size(), kSampledAtOnce, 0, [&](std::size_t begin, std::size_t end) {
        const auto look = [&](const Sample& at) {
            Contested point{at.area, {}};
            maybe.near(at.p, at.normal, width / 2,
                       [&](const Stretch& l, double, double) { point.ways.push_back(l.stroke); });
            if (point.ways.empty()) return;
            bool sure = false;
            laid.near(at.p, at.normal, width / 2, [&](const Stretch&, double, double) { sure = true; });
            if (sure) return;
            std::sort(point.ways.begin(), point.ways.end());
            point.ways.erase(std::unique(point.ways.begin(), point.ways.end()), point.ways.end());
            parts[begin / kSampledAtOnce].push_back(std::move(point));
        };
        for (std::size_t t = begin; t < end; ++t)
            each_sample(s, static_cast<std::uint32_t>(t), kSampleApart * width, look);
    });
    std::vector<Contested> out;
    for (auto& part : parts) out.insert(out.end(), part.begin(), part.end());
    return out;
}

double length(const Stroke& stroke) {
    double out = 0;
    for (const Piece& piece : stroke.pieces) out += surface::curve::length(piece.line);
    return out;
}

// With as few places as points call for: chords of the tightest turn, of half a width, are then 1/64 of it off.
Stroke coarse(const Stroke& stroke, double apart) {
    Stroke out;
    for (const Piece& piece : stroke.pieces)
        out.pieces.push_back({surface::curve::resampled(piece.line, apart), false});
    return out;
}

class Staggering {
  public:
    Staggering(const Surface& s, const Plan& fixed, std::span<const Depths> turns, double width)
        : width_(width), chosen_(turns.size(), 0) {
        Plan ways;
        for (const Depths& turn : turns) {
            first_.push_back(static_cast<std::uint32_t>(ways.strokes.size()));
            for (const Stroke& way : turn) {
                length_.push_back(length(way));
                ways.strokes.push_back(coarse(way, kSampleApart * width));
            }
        }
        first_.push_back(static_cast<std::uint32_t>(ways.strokes.size()));
        points_ = contested(s, fixed, ways, width);
        covered_.resize(ways.strokes.size());
        for (std::uint32_t p = 0; p < points_.size(); ++p)
            for (const std::uint32_t way : points_[p].ways) covered_[way].push_back(p);
        times_.assign(points_.size(), 0);
        for (std::uint32_t t = 0; t < turns.size(); ++t) count(way(t), 1);
    }

    std::vector<std::uint32_t> run() {
        bool changed = true;
        for (int sweep = 0; sweep < kMostSweeps && changed; ++sweep) {
            changed = false;
            for (std::uint32_t t = 0; t < chosen_.size(); ++t) {
                count(way(t), -1);
                const std::uint32_t best = choose(t);
                changed = changed || best != chosen_[t];
                chosen_[t] = best;
                count(way(t), 1);
            }
        }
        return std::move(chosen_);
    }

  private:
    [[nodiscard]] std::uint32_t way(std::uint32_t turn) const { return first_[turn] + chosen_[turn]; }

    void count(std::uint32_t way, int by) {
        for (const std::uint32_t p : covered_[way]) times_[p] += by;
    }

    // What is laid twice is what is laid less what is covered; so what a way covers alone counts twice against its
    // length.
    [[nodiscard]] std::uint32_t choose(std::uint32_t turn) const {
        std::uint32_t best = chosen_[turn];
        double least = waste(first_[turn] + best);
        for (std::uint32_t w = first_[turn]; w < first_[turn + 1]; ++w)
            if (const double now = waste(w); now < least - kSame || (now <= least && w < first_[turn] + best)) {
                least = now;
                best = w - first_[turn];
            }
        return best;
    }

    [[nodiscard]] double waste(std::uint32_t way) const {
        double alone = 0;
        for (const std::uint32_t p : covered_[way]) alone += times_[p] == 0 ? points_[p].area : 0;
        return length_[way] * width_ - 2 * alone;
    }

    static constexpr double kSame = 1e-9; // mm2: less is rounding, and would let turns change for ever
    double width_;
    std::vector<std::uint32_t> chosen_, first_; // per turn
    std::vector<double> length_;                // per way, mm
    std::vector<std::vector<std::uint32_t>> covered_;
    std::vector<Contested> points_;
    std::vector<int> times_; // per point: the chosen ways that cover it
};

} // namespace

std::vector<std::uint32_t> staggered(const Surface& s, const Plan& fixed, std::span<const Depths> turns, double width) {
    if (turns.empty()) return {};
    return Staggering(s, fixed, turns, width).run();
}

} // namespace filum::surfpath
