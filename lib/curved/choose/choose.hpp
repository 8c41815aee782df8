// `choose`: selects an algorithm and a seed for a patch by running candidates.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "choose/candidates.hpp"
#include "choose/score.hpp"
#include "surfpath/surfpath.hpp"

#include <functional>
#include <optional>

namespace filum::choose {

struct Options {
    surfpath::Options plan;                   // spacing, least radius and so on; its algorithm only with `by_hand`
    bool by_hand = false;                     // use that algorithm with the sheet's sources, and try nothing else
    std::vector<surfpath::Algorithm> among{}; // without `by_hand`: candidates of these algorithms only; empty: of all
    Weights weights;
    std::int64_t finals = 3;           // number of candidates that are planned as asked
    std::function<void(double)> far{}; // called with the progress, 0 to 1; from any thread, one at a time
};

struct Trial {
    Candidate candidate;
    double estimate = std::nan("");       // see estimate()
    std::optional<Criteria> rough, found; // of the path on the rough patch, and of that on the patch itself
    double rough_score = 0, score = 0;    // of these paths
    std::string failed;                   // reason of failure; empty if there is none
};

inline constexpr std::size_t kNothing = ~std::size_t{0};

struct Choice {
    std::vector<Trial> trials;   // in the order of candidates()
    std::size_t best = kNothing; // the one with the greatest score; ties: the first
    double area = 0;             // mm2
    double rings_bound = 1; // share of it that rings of the least radius can cover at most (surfpath/rings/reach.hpp)
};

// Selects the best of candidates() for the patch in three rounds:
// 1. every candidate by its estimate() on a rough patch, which has triangles with sides of about two spacings;
// 2. of each algorithm the most promising ones (two of each that needs no line, five fina, three fexa, three ortheo,
// two field; without load cases the first) by a path on the rough patch at twice the scale, unless the patch is
// smaller than 25 spacings squared;
// 3. the best `finals` of these by score, and what the patch carried, by a path on the patch as asked; if all fail,
// the next ones.
// Sets the best one's algorithm and sources in the sheet, and the field "distance" from these; isolines are removed.
// Failures are recorded in the trials; if all fail, the sheet has no algorithm, and the note NoteCode::no_path_found
// gives its area and place. Same result for any `threads`.
Choice choose(Sheet& sheet, const Options& options, int threads, Notes& notes);

// Facts about the choice: "rings-bound", "score", "coverage", "load", "angle", "cuts", "overlap", "laid" (candidates
// in round 3), "candidates".
Facts facts(const Choice& choice);

// A line per candidate as TSV, below the line of head() (docs/metrics.md): patch, area, algorithm, seed, estimate,
// rough score, coverage, load, paper load, angle, cuts, length, overlap, score, chosen ("*"), reason of failure, and
// for rings and spirals the bound on coverage. "-": unknown.
std::string head();
std::string report(const std::string& patch, const Choice& choice);

} // namespace filum::choose
