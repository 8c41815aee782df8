#include "surfpath/plan/stagger.hpp"

#include "parallel/parallel.hpp"
#include "surfpath/plan/samples.hpp"
#include "surfpath/plan/stretches.hpp"

#include <algorithm>
#include <numeric>

namespace filum::surfpath::plan {

namespace {

constexpr double kSampleApart = 0.25;       // widths, between points: the steps by which turns go deeper
constexpr std::size_t kSampledAtOnce = 256; // triangles of a piece of work
constexpr int kMostSweeps = 20;             // over all turns; a few do

// Points that only turns may cover, and the ways (numbered over all turns) that do, one point's behind the other's.
struct Contested {
    std::vector<double> area;         // mm2, per point
    std::vector<std::uint32_t> count; // per point: its ways
    std::vector<std::uint32_t> ways;  // of each point ascending
};

// Puts those of the points into `open` that no stretch comes as near to as `reach`, mm.  Changes the order of
// stretches.
void uncovered(std::span<const Sample> points, std::vector<const Stretch*>& stretches, double reach,
               std::vector<const Sample*>& open) {
    open.clear();
    for (const Sample& at : points) {
        const auto covering =
            std::find_if(stretches.begin(), stretches.end(), [&](const Stretch* l) { return within(*l, at.p, reach); });
        if (covering == stretches.end())
            open.push_back(&at);
        else
            std::iter_swap(stretches.begin(), covering); // asked first for the next point, which lies beside
    }
}

// In the order of triangles, piece by piece.
std::vector<Contested> contested(const Surface& s, const Plan& fixed, const Plan& ways, double width) {
    const Stretches laid(s, fixed), maybe(s, ways);
    std::vector<Contested> parts((s.triangles.size() + kSampledAtOnce - 1) / kSampledAtOnce);
    parallel::for_chunks(s.triangles.size(), kSampledAtOnce, 0, [&](std::size_t begin, std::size_t end) {
        Contested& out = parts[begin / kSampledAtOnce];
        std::vector<Sample> room;
        std::vector<const Stretch*> sure, possible; // near the points
        std::vector<const Sample*> open;            // of the points, those that nothing sure covers
        const auto look = [&](const Sample& at) {
            const std::size_t first = out.ways.size();
            for (const Stretch* l : possible) { // by strokes
                const bool known = out.ways.size() > first && out.ways.back() == l->stroke;
                if (!known && within(*l, at.p, width / 2)) out.ways.push_back(l->stroke);
            }
            if (out.ways.size() == first) return;
            out.area.push_back(at.area);
            out.count.push_back(static_cast<std::uint32_t>(out.ways.size() - first));
        };
        for (std::size_t t = begin; t < end; ++t)
            each_few(s, static_cast<std::uint32_t>(t), kSampleApart * width, room, [&](std::span<const Sample> few) {
                const auto about = geom::grown(box_of(few), width / 2);
                maybe.about(about, few[0].normal, possible);
                if (possible.empty()) return;
                laid.about(about, few[0].normal, sure);
                uncovered(few, sure, width / 2, open);
                if (open.empty()) return;
                std::sort(possible.begin(), possible.end()); // as they are listed, which is by strokes
                for (const Sample* one : open) look(*one);
            });
    });
    return parts;
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
        auto parts = contested(s, fixed, ways, width);
        begin_.assign(ways.strokes.size() + 1, 0);
        for (const Contested& part : parts)
            for (const std::uint32_t way : part.ways) ++begin_[way + 1];
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
        covered_.resize(begin_.back());
        auto next = begin_;
        for (Contested& part : parts) {
            std::size_t at = 0;
            for (std::size_t p = 0; p < part.area.size(); ++p) {
                const auto number = static_cast<std::uint32_t>(area_.size());
                for (const std::size_t end = at + part.count[p]; at < end; ++at)
                    covered_[next[part.ways[at]]++] = number;
                area_.push_back(part.area[p]);
            }
            part = {};
        }
        times_.assign(area_.size(), 0);
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

    [[nodiscard]] std::span<const std::uint32_t> covered(std::uint32_t way) const {
        return std::span(covered_).subspan(begin_[way], begin_[way + 1] - begin_[way]);
    }

    void count(std::uint32_t way, int by) {
        for (const std::uint32_t p : covered(way)) times_[p] += by;
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
        for (const std::uint32_t p : covered(way)) alone += times_[p] == 0 ? area_[p] : 0;
        return length_[way] * width_ - 2 * alone;
    }

    static constexpr double kSame = 1e-9; // mm2: less is rounding, and would let turns change for ever
    double width_;
    std::vector<std::uint32_t> chosen_, first_; // per turn
    std::vector<double> length_;                // per way, mm
    std::vector<std::size_t> begin_;            // per way, and one more: of those points
    std::vector<std::uint32_t> covered_;        // that each way covers
    std::vector<double> area_;                  // per point, mm2
    std::vector<int> times_;                    // per point: the chosen ways that cover it
};

} // namespace

std::vector<std::uint32_t> staggered(const Surface& s, const Plan& fixed, std::span<const Depths> turns, double width) {
    if (turns.empty()) return {};
    return Staggering(s, fixed, turns, width).run();
}

} // namespace filum::surfpath::plan
