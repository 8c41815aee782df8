#include "base/number.hpp"
#include "choose/choose.hpp"

#include <algorithm>

namespace filum::choose {

namespace {

std::string number(double v, int decimals) { return std::isfinite(v) ? fixed_text(v, decimals) : "-"; }

std::string line(const std::string& patch, const Choice& choice, const Trial& t, bool best) {
    std::string out = patch + "\t" + number(choice.area, 1) + "\t" + surfpath::name(t.candidate.algorithm) + "\t" +
                      spoken(t.candidate.seed) + "\t" + number(t.estimate, 4) + "\t" +
                      (t.rough ? number(t.rough_score, 4) : "-");
    if (t.found) {
        const Criteria& c = *t.found;
        for (const double v : {c.coverage, c.load, c.paper_load}) out += "\t" + number(v, 4);
        out += "\t" + number(c.angle, 2) + "\t" + number(c.cuts, 0) + "\t" + number(c.length, 1);
        out += "\t" + number(c.overlap, 4) + "\t" + number(t.score, 4);
    } else {
        for (int k = 0; k < 8; ++k) out += "\t-";
    }
    std::string why = t.failed.empty() ? "-" : t.failed;
    std::replace_if(
        why.begin(), why.end(), [](char c) { return c == '\t' || c == '\n'; }, ' ');
    const bool round = surfpath::runs_round(t.candidate.algorithm);
    out += std::string("\t") + (best ? "*" : "-") + "\t" + why + "\t" + (round ? number(choice.rings_bound, 4) : "-");
    const auto mm = [&](double Criteria::*of) { return t.found ? number(*t.found.*of, 1) : "-"; };
    return out + "\t" + mm(&Criteria::tight) + "\t" + mm(&Criteria::kinks) + "\n";
}

} // namespace

Facts facts(const Choice& choice) {
    Facts out{{"", "candidates", static_cast<double>(choice.trials.size()), ""}};
    const auto laid =
        std::count_if(choice.trials.begin(), choice.trials.end(), [](const Trial& t) { return bool{t.found}; });
    out.push_back({"", "laid", static_cast<double>(laid), ""});
    out.push_back({"", "rings-bound", choice.rings_bound, ""});
    if (choice.best == kNothing) return out;
    const Trial& t = choice.trials[choice.best];
    const Criteria& c = *t.found;
    out.push_back({"", "score", t.score, ""});
    out.push_back({"", "coverage", c.coverage, ""});
    if (std::isfinite(c.load)) out.push_back({"", "load", c.load, ""});
    out.push_back({"", "angle", c.angle, "deg"});
    out.push_back({"", "cuts", c.cuts, ""});
    out.push_back({"", "overlap", c.overlap, ""});
    out.push_back({"", "tight-length", c.tight, "mm"});
    out.push_back({"", "kink-length", c.kinks, "mm"});
    return out;
}

std::string head() {
    return "patch\tarea_mm2\talgorithm\tseed\testimate\trough\tcoverage\tload\tpaper_load\tangle_deg\tcuts\tlength_"
           "mm\toverlap\t"
           "score\tchosen\tfailed\trings_bound\ttight_mm\tkink_mm\n";
}

std::string report(const std::string& patch, const Choice& choice) {
    std::string out;
    for (std::size_t i = 0; i < choice.trials.size(); ++i)
        out += line(patch, choice, choice.trials[i], i == choice.best);
    return out;
}

} // namespace filum::choose
