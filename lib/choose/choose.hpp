// The whole job of `choose`: an algorithm and a seed for a patch, by running candidates.
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
    surfpath::Options plan;            // spacing, least radius and so on; its algorithm counts only
    bool by_hand = false;              // here: it is laid from the sheet's sources, and nothing else is tried
    Weights weights;                   //
    std::int64_t finals = 3;           // how many candidates are laid as asked
    std::function<void(double)> far{}; // called with the share that is done, 0 to 1; from any thread, one at a time
};

struct Trial {
    Candidate candidate;
    double estimate = std::nan("");       // see estimate()
    std::optional<Criteria> rough, found; // of the path on the rough patch, and of that on the patch itself
    double rough_score = 0, score = 0;    // of those
    std::string failed;                   // why there is none
};

inline constexpr std::size_t kNothing = ~std::size_t{0};

struct Choice {
    std::vector<Trial> trials;   // as candidates() lists them
    std::size_t best = kNothing; // the one with the greatest score, of equals the first
    double area = 0;             // mm2
    double rings_bound = 1;      // share of it that rings of the least radius can cover, at most (surfpath/reach.hpp)
};

// The best of candidates() for the patch, in three rounds:
// 1. each by its estimate() on a rough patch: the same in triangles with sides of (mostly) two spacings;
// 2. of every algorithm the most promising (two of each that needs no line, five fina, three fexa, three ortheo, two
// field; without
//    load cases the first) are laid on the rough patch, everything twice as large, unless the patch is smaller than 25
//    spacings square;
// 3. the best `finals` of these by their scores, and what the patch came with, are laid on the patch as asked; if all
//    fail, the next.
// Puts the best one's algorithm and sources into the sheet, and the field "distance" from them; isolines are left out.
// Failures of candidates are kept in the trials; if all fail, the sheet has no algorithm then, and a note says "no path
// found", with its area and place.  Same result for any `threads`.
Choice choose(Sheet& sheet, const Options& options, int threads, Notes& notes);

// What is known of the choice: "rings-bound", "score", "coverage", "load", "angle", "cuts", "overlap", "laid"
// (candidates in round 3), "candidates".
Facts facts(const Choice& choice);

// A line per candidate, TSV, under a head line (docs/metrics.md): patch, area, algorithm, seed, estimate, rough score,
// coverage, load, paper load, angle, cuts, length, overlap, score, chosen ("*"), why it failed, and of those that run
// round rims or a point the bound on coverage.  "-": not known.
std::string head();
std::string report(const std::string& patch, const Choice& choice);

} // namespace filum::choose
