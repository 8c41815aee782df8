#include "surfpath/plan/stagger.hpp"

#include "parallel/parallel.hpp"
#include "surfpath/plan/path_segments.hpp"
#include "surfpath/plan/samples.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <numeric>

namespace filum::surfpath::plan {

namespace {

// Sample points that only turns may cover, and the variants of turns (numbered over all turns) that cover each.
struct ContestedSamples {
    std::vector<double> area;            // mm2 per point
    std::vector<std::uint32_t> count;    // per point: number of variants
    std::vector<std::uint32_t> variants; // of all points consecutively, ascending for each
};

// Sets `open` to the points that are farther than `reach` mm from every segment. Reorders the segments.
void uncovered(std::span<const Sample> points, std::vector<const PathSegment*>& stretches, double reach,
               std::vector<const Sample*>& open) {
    open.clear();
    for (const Sample& at : points) {
        const auto covering = std::find_if(stretches.begin(), stretches.end(),
                                           [&](const PathSegment* l) { return within(*l, at.p, reach); });
        if (covering == stretches.end())
            open.push_back(&at);
        else
            std::iter_swap(stretches.begin(), covering); // tried first for the next point, which is a neighbour
    }
}

// Contested samples per task, in the order of triangles.
std::vector<ContestedSamples> contested(const Surface& s, const Plan& fixed, const Plan& variants, double width) {
    const PathSegments laid(s, fixed), maybe(s, variants);
    std::vector<ContestedSamples> parts((s.triangles.size() + rules::kTrianglesAtOnce - 1) / rules::kTrianglesAtOnce);
    parallel::for_chunks(s.triangles.size(), rules::kTrianglesAtOnce, 0, [&](std::size_t begin, std::size_t end) {
        ContestedSamples& out = parts[begin / rules::kTrianglesAtOnce];
        std::vector<Sample> room;
        std::vector<const PathSegment*> sure, possible; // segments near the points
        std::vector<const Sample*> open;                // points that no fixed segment covers
        const auto look = [&](const Sample& at) {
            const std::size_t first = out.variants.size();
            for (const PathSegment* l : possible) { // ordered by strokes
                const bool known = out.variants.size() > first && out.variants.back() == l->stroke;
                if (!known && within(*l, at.p, width / 2)) out.variants.push_back(l->stroke);
            }
            if (out.variants.size() == first) return;
            out.area.push_back(at.area);
            out.count.push_back(static_cast<std::uint32_t>(out.variants.size() - first));
        };
        for (std::size_t t = begin; t < end; ++t)
            each_few(s, static_cast<std::uint32_t>(t), rules::kGrain * width, room, [&](std::span<const Sample> few) {
                const auto in_box = geom::grown(box_of(few), width / 2);
                maybe.in_box(in_box, few[0].normal, possible);
                if (possible.empty()) return;
                laid.in_box(in_box, few[0].normal, sure);
                uncovered(few, sure, width / 2, open);
                if (open.empty()) return;
                std::sort(possible.begin(), possible.end()); // by address, which is the order of strokes
                for (const Sample* one : open) look(*one);
            });
    });
    return parts;
}

double length(const Stroke& stroke) {
    double out = 0;
    for (const Section& piece : stroke.sections) out += surface::curve::length(piece.line);
    return out;
}

// Resamples a variant to the distance of sample points. Chords of the tightest turn, of half a width, are then 1/64
// off.
Stroke coarse(const Stroke& stroke, double apart) {
    Stroke out;
    for (const Section& piece : stroke.sections)
        out.sections.push_back({surface::curve::resampled(piece.line, apart), false});
    return out;
}

class StaggerSearch {
  public:
    StaggerSearch(const Surface& s, const Plan& fixed, std::span<const TurnVariants> turns, double width)
        : width_(width), chosen_(turns.size(), 0) {
        Plan variants;
        for (const TurnVariants& turn : turns) {
            first_.push_back(static_cast<std::uint32_t>(variants.strokes.size()));
            for (const Stroke& variant : turn) {
                length_.push_back(length(variant));
                variants.strokes.push_back(coarse(variant, rules::kGrain * width));
            }
        }
        first_.push_back(static_cast<std::uint32_t>(variants.strokes.size()));
        auto parts = contested(s, fixed, variants, width);
        begin_.assign(variants.strokes.size() + 1, 0);
        for (const ContestedSamples& part : parts)
            for (const std::uint32_t variant : part.variants) ++begin_[variant + 1];
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
        covered_.resize(begin_.back());
        auto next = begin_;
        for (ContestedSamples& part : parts) {
            std::size_t at = 0;
            for (std::size_t p = 0; p < part.area.size(); ++p) {
                const auto number = static_cast<std::uint32_t>(area_.size());
                for (const std::size_t end = at + part.count[p]; at < end; ++at)
                    covered_[next[part.variants[at]]++] = number;
                area_.push_back(part.area[p]);
            }
            part = {};
        }
        times_.assign(area_.size(), 0);
        for (std::uint32_t t = 0; t < turns.size(); ++t) count(variant(t), 1);
    }

    std::vector<std::uint32_t> run() {
        bool changed = true;
        for (int sweep = 0; sweep < rules::kMostRounds && changed; ++sweep) {
            changed = false;
            for (std::uint32_t t = 0; t < chosen_.size(); ++t) {
                count(variant(t), -1);
                const std::uint32_t best = choose(t);
                changed = changed || best != chosen_[t];
                chosen_[t] = best;
                count(variant(t), 1);
            }
        }
        return std::move(chosen_);
    }

  private:
    [[nodiscard]] std::uint32_t variant(std::uint32_t turn) const { return first_[turn] + chosen_[turn]; }

    [[nodiscard]] std::span<const std::uint32_t> covered(std::uint32_t variant) const {
        return std::span(covered_).subspan(begin_[variant], begin_[variant + 1] - begin_[variant]);
    }

    void count(std::uint32_t variant, int by) {
        for (const std::uint32_t p : covered(variant)) times_[p] += by;
    }

    // Overlap is the area of beads less the covered area. So area that only this variant covers counts twice against
    // its bead: once as a void avoided, once as less overlap.
    [[nodiscard]] std::uint32_t choose(std::uint32_t turn) const {
        std::uint32_t best = chosen_[turn];
        double least = waste(first_[turn] + best);
        for (std::uint32_t w = first_[turn]; w < first_[turn + 1]; ++w)
            if (const double now = waste(w);
                now < least - rules::kRounding || (now <= least && w < first_[turn] + best)) {
                least = now;
                best = w - first_[turn];
            }
        return best;
    }

    [[nodiscard]] double waste(std::uint32_t variant) const {
        double alone = 0;
        for (const std::uint32_t p : covered(variant)) alone += times_[p] == 0 ? area_[p] : 0;
        return length_[variant] * width_ - 2 * alone;
    }

    double width_;
    std::vector<std::uint32_t> chosen_, first_; // per turn: its variant; the number of its first variant
    std::vector<double> length_;                // per variant, mm
    std::vector<std::size_t> begin_;            // per variant, and one more: where its points begin in covered_
    std::vector<std::uint32_t> covered_;        // points that each variant covers
    std::vector<double> area_;                  // per point, mm2
    std::vector<int> times_;                    // per point: number of chosen variants that cover it
};

} // namespace

std::vector<std::uint32_t> staggered(const Surface& s, const Plan& fixed, std::span<const TurnVariants> turns,
                                     double width) {
    if (turns.empty()) return {};
    return StaggerSearch(s, fixed, turns, width).run();
}

} // namespace filum::surfpath::plan
