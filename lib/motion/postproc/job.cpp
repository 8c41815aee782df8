#include "postproc/job.hpp"

#include "base/number.hpp"
#include "figures/meanings.hpp"
#include "postproc/digits.hpp"

#include <optional>

namespace filum::postproc {

namespace {

// The totals of one tool, or of all.
struct Sum {
    std::optional<std::uint32_t> tool; // none: all tools
    std::string name;
    ToolTotals totals;
    double volume = 0, mass = 0; // mm3 with the flow factor, g
    bool weighed = true;         // the density of every material is known
    double cost = 0;             // in the user's money
    bool priced = true;          // the price of every material is known
};

Sum of_tool(const machine::Profile& p, std::uint32_t number, const ToolTotals& t) {
    const auto& e = machine::of_tool(p, number).extrusion;
    const double density = t.fibre ? p.fibre.density : e.density;
    const double volume = t.volume * (t.fibre ? 1 : e.flow);
    return {number,
            "tool " + std::to_string(number) + (t.fibre ? " (fibre)" : ""),
            t,
            volume,
            volume / 1000 * density,
            density > 0 || volume == 0,
            volume / 1e6 * density * e.cost,
            (density > 0 && e.cost > 0 && !t.fibre) || volume == 0};
}

std::vector<Sum> sums(const machine::Profile& profile, const FirstPass& first_pass) {
    std::vector<Sum> out;
    Sum all{{}, "job", {}};
    for (const auto& [number, totals] : first_pass.tools) {
        out.push_back(of_tool(profile, number, totals));
        const Sum& s = out.back();
        auto& t = all.totals;
        t.fibre = t.fibre || totals.fibre;
        t.strokes += totals.strokes;
        t.cuts += totals.cuts;
        t.path_len += totals.path_len;
        t.travel_len += totals.travel_len;
        t.fibre_len += totals.fibre_len;
        t.print_seconds += totals.print_seconds;
        t.travel_seconds += totals.travel_seconds;
        all.volume += s.volume;
        all.mass += s.mass;
        all.weighed = all.weighed && s.weighed;
        all.cost += s.cost;
        all.priced = all.priced && s.priced;
    }
    out.push_back(all);
    return out;
}

} // namespace

figures::Figures job(const machine::Profile& profile, const FirstPass& first_pass) {
    figures::Figures out;
    for (const Sum& s : sums(profile, first_pass)) {
        const ToolTotals& t = s.totals;
        const std::size_t first = out.size();
        const auto tell = [&](const std::string& key, decltype(figures::Figure::value) value) {
            figures::tell(out, figures::job_meanings(), (s.tool ? "tool.*." : "job.") + key, std::move(value),
                          s.tool ? std::to_string(*s.tool) : "");
        };
        tell("strokes", t.strokes);
        tell("cuts", t.cuts);
        tell("laid_mm", t.path_len);
        if (t.fibre) tell("fibre_used_mm", t.fibre_len);
        tell("travel_mm", t.travel_len);
        tell("material_mm3", s.volume);
        if (s.weighed) tell("mass_g", s.mass);
        if (s.priced && s.cost > 0) tell("cost", s.cost);
        tell("print_time_s", t.print_seconds);
        tell("travel_time_s", t.travel_seconds);
        for (std::size_t k = first; k < out.size(); ++k) out[k].group = s.name;
    }
    return out;
}

double cost(const machine::Profile& profile, const FirstPass& first_pass) {
    const Sum all = sums(profile, first_pass).back();
    return all.priced ? all.cost : 0;
}

std::vector<std::string> job_lines(const machine::Profile& profile, const FirstPass& first_pass) {
    const auto all = sums(profile, first_pass);
    std::vector<std::string> out;
    if (all.size() < 3 && !all.back().totals.fibre) return out;
    for (const Sum& s : all) {
        const ToolTotals& t = s.totals;
        std::string line = " " + s.name + ": " + std::to_string(t.strokes) + " strokes, " + std::to_string(t.cuts) +
                           " cuts, " + fixed_text(t.path_len, 1) + " mm laid";
        if (t.fibre) line += ", " + fixed_text(t.fibre_len, 1) + " mm of fibre";
        line += ", " + fixed_text(s.volume, 2) + " mm3";
        if (s.weighed) line += ", " + fixed_text(s.mass, 3) + " g";
        line += ", printing " + duration(t.print_seconds) + ", travel " + duration(t.travel_seconds);
        out.push_back(std::move(line));
    }
    return out;
}

Notes omissions(const FirstPass& first_pass) {
    const OmittedMoves& o = first_pass.omitted;
    if (o.count == 0) return {};
    return {{NoteCode::fibre_too_short, o.length, o.count, static_cast<std::int64_t>(o.layer), o.at.x, o.at.y}};
}

} // namespace filum::postproc
