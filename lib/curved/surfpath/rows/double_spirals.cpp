#include "surfpath/rows/double_spirals.hpp"

#include "surfpath/lanes/spiral.hpp"
#include "surfpath/rules/rules.hpp"

#include <cmath>
#include <numbers>

namespace filum::surfpath::rows {

namespace {

// Two lines need two half turns in any way, so a double spiral gains only from three lines on.
constexpr std::size_t kFewest = 3;

// mm2 that stay void at both ends of the double spiral: the links leave a wedge, two lines wide where it begins, and
// half turns reach into it by the share `into` of its length.
double wedges(const lanes::Lanes& lanes, const lanes::Ladder& r, double into) {
    double out = 0;
    for (const std::size_t k : {std::size_t{0}, r.lanes() - 1})
        out += lanes.ahead(r.lane[k], r.arcs.front()[k], r.arcs.back()[k], r.sense[k]);
    return (1 - 2 * into) * out * lanes.spacing();
}

} // namespace

std::size_t wind_double(const Surface& s, std::vector<Line*> lines, const LoopOptions& o) {
    const double wanted = rules::shift_length(o.gentle, 2 * o.spacing); // an arm shifts by two lines on a lap
    // A link is eased by two parabolas: this share of it is so near to its lane that half turns fit beside it.
    const double into = std::sqrt((1 - o.nearest) / 4);
    // Square spacings that the two half turns of an exchange leave open: in the corners outside of each half circle.
    const double wasted = 2 * (2 - std::numbers::pi / 2);
    std::size_t out = 0;
    while (lines.size() >= kFewest) {
        std::vector<Line> here;
        for (const Line* line : lines) here.push_back(*line);
        const lanes::Lanes lanes(s, std::move(here), o.spacing);
        const lanes::Ladder ladder = lanes::spiral_ladder(lanes, 0, wanted);
        const bool leads = ladder.lanes() >= kFewest;
        const double exchanges = static_cast<double>(ladder.lanes()) - 1;
        if (!leads || wedges(lanes, ladder, into) > exchanges * wasted * o.spacing * o.spacing) {
            lines.erase(lines.begin());
            continue;
        }
        lanes::LinkedLanes linked(lanes);
        lanes::wind_loop(linked, lanes, ladder, into);
        std::vector<char> taken(lines.size(), 0);
        for (const std::uint32_t lane : ladder.lane) taken[lane] = 1;
        for (auto& curve : linked.curves()) {
            if (curve.lanes.size() < kFewest || !curve.closed) continue;
            for (const std::uint32_t lane : curve.lanes) lines[lane]->places.clear();
            curve.line.closed = true;
            curve.line.places.pop_back(); // equal to the first one
            *lines[ladder.lane[0]] = std::move(curve.line);
            out += ladder.lanes() - 1;
        }
        std::vector<Line*> rest;
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (taken[i] == 0) rest.push_back(lines[i]);
        lines = std::move(rest);
    }
    return out;
}

} // namespace filum::surfpath::rows
