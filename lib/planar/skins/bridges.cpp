#include "skins/bridges.hpp"

#include "polygon/clip.hpp"
#include "polygon/stretches.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <optional>

namespace filum::skins {

namespace {

using polygon::Loops;

constexpr std::size_t kDirections = 36; // over 180 degrees: the span is at most 0.1 % too long (1 / cos 2.5 degrees)

// The most lines per direction. More would not change the best direction: 4000 beads of 0.4 mm are 1.6 m of air.
constexpr double kMostLines = 4000;

// Lines of one direction, at even distances, across a piece of air.
struct Lines {
    double all = 0, bare = 0; // mm of all lines, and of those without material at some end
    double longest = 0;       // mm, of the lines with material at both ends
};

Lines lines_across(const Loops& air, const Loops& below, double angle, double bead_width, double apart) {
    const Loops piece = polygon::rotated(air, -angle), ground = polygon::rotated(below, -angle);
    const geom::Box2 box = polygon::bounds(piece);
    std::vector<double> y;
    for (double at = box.lo.y + apart / 2; at < box.hi.y; at += apart) y.push_back(at);
    const auto lines = polygon::scan(piece, y);
    Lines out;
    for (std::size_t i = 0; i < y.size(); ++i)
        for (const polygon::LevelStretch s : lines[i]) {
            const double length = s.to - s.from;
            const bool carried = polygon::contains(ground, {s.from - bead_width / 2, y[i]}) &&
                                 polygon::contains(ground, {s.to + bead_width / 2, y[i]});
            out.all += length;
            if (carried)
                out.longest = std::max(out.longest, length);
            else
                out.bare += length;
        }
    return out;
}

// The direction whose longest carried line is the shortest. Only directions count in which the lines with a loose end
// are at most one line longer than the least possible. nullopt if more than half of the line length has a loose end in
// all of them.
std::optional<double> shortest_span(const Loops& air, const Loops& below, double bead_width) {
    const geom::Box2 box = polygon::bounds(air);
    const double one = geom::distance(box.lo, box.hi); // no line is longer
    const double apart = std::max(bead_width, one / kMostLines);
    std::vector<Lines> found;
    std::vector<double> angle;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < kDirections; ++k) {
        angle.push_back(std::numbers::pi * static_cast<double>(k) / kDirections);
        found.push_back(lines_across(air, below, angle.back(), bead_width, apart));
        least = std::min(least, found.back().bare);
    }
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < kDirections; ++k) {
        if (found[k].bare > least + one || found[k].bare > found[k].all / 2) continue;
        if (!best || found[k].longest < found[*best].longest) best = k;
    }
    return best ? std::optional(angle[*best]) : std::nullopt;
}

} // namespace

std::vector<polygon::Area> bridges(const Loops& within, const Loops& below, const Options& o) {
    std::vector<polygon::Area> out;
    const Loops air = polygon::opened(polygon::subtract(within, below), o.bead_width / 2, polygon::kBeadArc);
    for (const Loops& piece : polygon::split(air).part) {
        if (polygon::offset(piece, -o.bridge / 2, polygon::kBeadArc).empty()) continue;
        if (const auto direction = shortest_span(piece, below, o.bead_width))
            out.push_back({polygon::AreaKind::bridge, piece, *direction, 0, {}});
    }
    return out;
}

} // namespace filum::skins
