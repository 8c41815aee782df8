#include "surfpath/ortheo.hpp"

#include "base/error.hpp"
#include "curve/walk.hpp"
#include "surfpath/strands.hpp"

#include <algorithm>

namespace filum::surfpath {

namespace {

using surface::kNone;

constexpr double kStep = 0.5;  // spacings, from front to front
constexpr double kGrain = 0.5; // spacings, between the lines that tell where all others lead

// The strand as a line, from its first spot on.
Line drawn(const Fronts& fronts, const Strand& s) {
    Line out{{fronts.place(s.first, s.spots[0])}, false};
    for (std::size_t j = 1; j < s.spots.size(); ++j)
        curve::append(out, curve::join(fronts.surface(), out.places.back(), fronts.place(s.first + j, s.spots[j])));
    if (s.end != End::law) curve::append(out, fronts.last(s.last(), s.spots.back()));
    return out;
}

// All lines, those that begin on both sides of the source at one place joined, in their order along the source.
std::vector<Line> lines(const Fronts& fronts, const std::vector<Strand>& strands) {
    std::vector<Line> out;
    for (std::uint32_t i = 0; i < strands.size(); ++i) {
        const std::uint32_t mate = strands[i].mate;
        if (mate != kNone && mate < i) continue;
        Line line = drawn(fronts, strands[i]);
        if (mate != kNone) {
            Line whole = drawn(fronts, strands[mate]);
            curve::reverse(whole);
            curve::append(whole, line);
            line = std::move(whole);
        }
        out.push_back(std::move(line));
    }
    return out;
}

} // namespace

Plan ortheo(const surface::Sheet& sheet, const Options& o) {
    if (sheet.sources.empty())
        throw Error(Exit::bad_input, "cannot lay lines upright on a seed curve without one; run geodesic --source "
                                     "plane:NX,NY,NZ,D first");
    const Fronts fronts(sheet.surface, sheet.sources, kStep * o.spacing, kGrain * o.spacing);
    const Strands found = strands(fronts, {o.spacing, 1, 0});
    Plan out;
    for (Line& line : lines(fronts, found.strands)) {
        if (out.strokes.size() % 2 == 1) curve::reverse(line);
        out.strokes.push_back({{{std::move(line)}}});
    }
    const auto fact = [&](const char* name, std::size_t v, const char* unit) {
        out.facts.push_back({"", name, static_cast<double>(v), unit});
    };
    fact("lines", out.strokes.size(), "");
    fact("births", found.born, "");
    fact("deaths", found.died, "");
    fact("births-lower-bound", found.bound, "");
    fact("cuts", out.strokes.empty() ? 0 : out.strokes.size() - 1, "");
    return out;
}

} // namespace filum::surfpath
