#include "surfpath/plan/round_path.hpp"

#include "surface/curve/rounding.hpp"
#include "surface/curve/turns.hpp"
#include "surfpath/rules/rules.hpp"

namespace filum::surfpath::plan {

namespace {

namespace curve = surface::curve;

void apply(const Surface& s, Plan& plan, const curve::RoundingOptions& o) {
    std::vector<Line> lines;
    for (const Stroke& stroke : plan.strokes) {
        lines.emplace_back();
        for (const Section& section : stroke.sections) curve::append(lines.back(), section.line);
    }
    curve::RoundingResult found = curve::rounded(s, lines, o);
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (found.moved[i]) plan.strokes[i].sections = {{std::move(found.lines[i]), false}};
}

} // namespace

void round_kinks(const Surface& s, Plan& plan, double spacing) {
    const double half = spacing / 2; // a bead that moves by half its width still lies on its old middle line
    apply(s, plan, {.spacing = spacing, .limit = curve::kKinkRadius * spacing, .radius = half, .corridor = half});
}

void round_bends(const Surface& s, Plan& plan, const PathRounding& o) {
    apply(s, plan,
          {.spacing = o.spacing,
           .limit = o.radius,
           .radius = rules::kSurely * o.radius,
           .corridor = rules::kMostGive * o.spacing,
           .nearest = o.nearest * o.spacing,
           .worth = o.spacing}); // a mm of tight length costs as much as a mm of gap or overlap of a bead
}

} // namespace filum::surfpath::plan
