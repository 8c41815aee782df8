#include "surfpath/ortheo.hpp"

#include "base/error.hpp"
#include "surface/curve/ease.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/fronts/front_lines.hpp"
#include "surfpath/rows/boustrophedon.hpp"
#include "surfpath/rules/rules.hpp"

#include <array>
#include <map>

namespace filum::surfpath {

namespace {

using surface::kNone;

// The line as a line, starting at its first spot.
Line drawn(const fronts::Fronts& fronts, const fronts::FrontLine& s) {
    Line out{{fronts.place(s.first, s.spots[0])}, false};
    for (std::size_t j = 1; j < s.spots.size(); ++j)
        surface::curve::append(
            out, surface::curve::join(fronts.surface(), out.places.back(), fronts.place(s.first + j, s.spots[j])));
    if (s.end != fronts::FrontLineEnd::interior) surface::curve::append(out, fronts.last(s.last(), s.spots.back()));
    return out;
}

// The line that continues each one at its start (0) and at its end (1): the one on the other side of the source, or
// the other one of a pair that is born or dies together.
std::vector<std::array<std::uint32_t, 2>> partners(const std::vector<fronts::FrontLine>& lines) {
    std::vector<std::array<std::uint32_t, 2>> out(lines.size(), {kNone, kNone});
    // lines that lack their partner, by group and side
    std::map<std::pair<std::uint32_t, std::size_t>, std::uint32_t> waiting;
    for (std::uint32_t i = 0; i < lines.size(); ++i) {
        out[i][0] = lines[i].mate;
        for (const std::size_t side : {0U, 1U}) {
            const std::uint32_t group = side == 0 ? lines[i].born_with : lines[i].dies_with;
            if (group == kNone) continue;
            const auto [it, first] = waiting.insert({{group, side}, i});
            if (first) continue;
            out[i][side] = it->second;
            out[it->second][side] = i;
            waiting.erase(it);
        }
    }
    return out;
}

// All lines: lines connected to their partners, in the order of their first lines.
std::vector<Line> lines(const fronts::Fronts& fronts, const std::vector<fronts::FrontLine>& lines, double spacing) {
    const auto next = partners(lines);
    std::vector<char> used(lines.size(), 0);
    std::vector<Line> out;
    const auto follow = [&](std::uint32_t i, std::size_t from) {
        Line all;
        bool turns = false;
        while (i != kNone && !used[i]) {
            used[i] = 1;
            Line more = drawn(fronts, lines[i]);
            if (from == 1) surface::curve::reverse(more);
            if (all.size() > 0 && distance(all.places.back().point, more[0]) > 1e-9) {
                surface::curve::append(all, surface::curve::join(fronts.surface(), all.places.back(), more.places[0]));
                turns = true;
            }
            surface::curve::append(all, more);
            from = 1 - from; // the next line is entered at its other end, in the same direction
            i = next[i][from];
        }
        if (turns)
            all =
                surface::curve::ease(fronts.surface(), all, {.radius = 0.45 * spacing, .corridor = 0.5 * spacing}).line;
        out.push_back(std::move(all));
    };
    for (std::uint32_t i = 0; i < lines.size(); ++i)
        for (const std::size_t side : {0U, 1U})
            if (next[i][side] == kNone) {
                if (!used[i]) follow(i, side);
                break;
            }
    for (std::uint32_t i = 0; i < lines.size(); ++i) // closed lines
        if (!used[i]) follow(i, 0);
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
    const fronts::Fronts fronts(s, sheet.sources, o.spacing);
    const bool alone = o.turns == RowTurns::none || o.turns == RowTurns::usual;
    const fronts::FrontLines found =
        fronts::front_lines(fronts, {o.spacing, o.turns == RowTurns::hairpin ? 2U : 1U, o.min_length});
    auto all = lines(fronts, found.lines, o.spacing);
    std::vector<rows::UnclippedLine> raw;
    for (std::size_t i = 0; i < all.size(); ++i) raw.push_back({std::move(all[i]), o.spacing * static_cast<double>(i)});
    rows::leave_out(raw, o.beyond);
    Plan out;
    if (alone) {
        for (rows::UnclippedLine& row : raw) {
            if (out.strokes.size() % 2 == 1) surface::curve::reverse(row.line);
            out.strokes.push_back({{{std::move(row.line), false}}});
        }
        fact(out, "rows", out.strokes.size());
    } else {
        rows::TurnOptions turns = rows::turn_options(o.spacing, o.least_radius, o.turns == RowTurns::hairpin);
        turns.staggered = o.beyond.empty();
        out = rows::boustrophedon(
            s, rows::rows(s, raw, {o.spacing / 2, o.spacing / 2, o.spacing / 4, rules::kMostGive * o.spacing}), turns);
    }
    fact(out, "births", found.born);
    fact(out, "deaths", found.died);
    fact(out, "births-lower-bound", found.bound);
    fact(out, "cuts", out.strokes.empty() ? 0 : out.strokes.size() - 1);
    for (const fronts::FrontLines::ShortLine& left : found.left_out) {
        const Vec3 p = fronts.place(left.level, left.spot).point;
        Note note{.code = NoteCode::line_too_short, .amount = left.length};
        note.x = p.x;
        note.y = p.y;
        note.z = p.z;
        out.notes.push_back(std::move(note));
    }
    return out;
}

} // namespace filum::surfpath
