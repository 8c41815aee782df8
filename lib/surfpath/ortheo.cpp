#include "surfpath/ortheo.hpp"

#include "base/error.hpp"
#include "curve/walk.hpp"
#include "surfpath/boustrophedon.hpp"
#include "surfpath/strands.hpp"

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

void fact(Plan& to, const char* name, std::size_t value) {
    to.facts.push_back({"", name, static_cast<double>(value), ""});
}

} // namespace

Plan ortheo(const surface::Sheet& sheet, const Options& o) {
    if (sheet.sources.empty())
        throw Error(Exit::bad_input, "cannot lay lines upright on a seed curve without one; run geodesic --source "
                                     "plane:NX,NY,NZ,D first");
    const Surface& s = sheet.surface;
    const Fronts fronts(s, sheet.sources, kStep * o.spacing, kGrain * o.spacing);
    const bool alone = o.turns == "none";
    const Strands found = strands(fronts, {o.spacing, o.turns == "hairpin" ? 2U : 1U, o.min_length});
    auto all = lines(fronts, found.strands);
    Plan out;
    if (alone) {
        for (Line& line : all) {
            if (out.strokes.size() % 2 == 1) curve::reverse(line);
            out.strokes.push_back({{{std::move(line), false}}});
        }
        fact(out, "rows", out.strokes.size());
    } else {
        std::vector<Raw> raw;
        for (std::size_t i = 0; i < all.size(); ++i)
            raw.push_back({std::move(all[i]), o.spacing * static_cast<double>(i)});
        const double radius = o.turns == "wide" ? o.least_radius : o.spacing / 2;
        out = boustrophedon(s, rows(s, raw, o.spacing / 2, o.spacing / 2), {o.spacing, radius});
        if (o.turns == "hairpin") // rows and turns take turns
            for (Stroke& stroke : out.strokes)
                for (std::size_t i = 1; i < stroke.pieces.size(); i += 2) stroke.pieces[i].hairpin = true;
    }
    fact(out, "births", found.born);
    fact(out, "deaths", found.died);
    fact(out, "births-lower-bound", found.bound);
    fact(out, "cuts", out.strokes.empty() ? 0 : out.strokes.size() - 1);
    for (const Strands::Short& left : found.left_out) {
        const Vec3 p = fronts.place(left.level, left.spot).point;
        Note note{.stage = "", .what = "line left out: too short", .amount = left.length, .unit = "mm"};
        note.x = p.x, note.y = p.y;
        out.notes.push_back(std::move(note));
    }
    return out;
}

} // namespace filum::surfpath
