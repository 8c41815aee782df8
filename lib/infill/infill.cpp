#include "infill/infill.hpp"

#include "infill/cells.hpp"
#include "infill/corridors.hpp"
#include "polygon/clip.hpp"

#include <algorithm>
#include <cmath>

namespace filum::infill {

namespace {

constexpr double kArc = 0.01;      // mm, of round corners
constexpr double kWidest = 64;     // spacings of endless lines
constexpr double kNeck = 1.25;     // bead widths: closed by this, corners that meet get a neck as wide as a bead
constexpr double kSame = 1e-3;     // of the spacing: as near as it is found
constexpr std::size_t kTried = 48; // areas that are filled to know how much corners take
constexpr int kRounds = 2;         // of that

// Where loops may run.
Loops inner(const Loops& area, double bead_width) { return polygon::offset(area, -bead_width / 2, kArc); }

// What of `a` is at least 2 `radius` wide.
Loops opened(const Loops& a, double radius) { return polygon::offset(polygon::offset(a, -radius, kArc), radius, kArc); }

// The spacing with which `length_of` is `wanted`.
template <class LengthOf>
double bisected(double lo, double hi, double wanted, LengthOf&& length_of) {
    if (length_of(hi) > wanted) return hi;
    while (hi - lo > kSame * lo) {
        const double middle = (lo + hi) / 2;
        (length_of(middle) > wanted ? lo : hi) = middle;
    }
    return (lo + hi) / 2;
}

} // namespace

Loops loops(const Loops& area, const Lines& o) {
    const double half = o.bead_width / 2;
    const Loops room = inner(area, o.bead_width);
    if (room.empty()) return {};
    return opened(polygon::intersect(room, even_cells(room, o)), half);
}

Loops loops(const Loops& area, std::span<const Task> parts) {
    if (parts.empty()) return {};
    if (parts.size() == 1) return loops(area, parts[0].lines);
    const double w = parts[0].lines.bead_width;
    Loops cells;
    for (const Task& t : parts) {
        const Loops own = polygon::intersect(*t.area, even_cells(*t.area, t.lines));
        for (std::size_t i = 0; i < own.size(); ++i) cells.add(own[i]);
    }
    const Loops room = inner(area, w);
    return with_corridors(opened(polygon::intersect(polygon::unite(cells), room), w / 2), room, w);
}

double length(const Loops& loops) {
    double sum = 0;
    for (std::size_t i = 0; i < loops.size(); ++i) sum += polygon::perimeter(loops[i]);
    return sum;
}

double spacing_for(std::span<const Task> tasks, double density, double bead_width) {
    std::vector<Loops> rooms;
    double area = 0;
    for (const Task& t : tasks) {
        rooms.push_back(inner(*t.area, bead_width));
        area += polygon::signed_area(*t.area);
    }
    const double wanted = density * area / bead_width, endless = bead_width / density;
    const auto by_calculation = [&](double spacing) {
        double sum = 0;
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            Lines lines = tasks[i].lines;
            lines.spacing = spacing;
            sum += even_length(rooms[i], lines);
        }
        return sum;
    };
    double laid = 1; // of what is calculated: corners are round, cells that are too narrow left out
    double spacing = bisected(bead_width, kWidest * endless, wanted, by_calculation);
    const std::size_t stride = std::max<std::size_t>(1, tasks.size() / kTried);
    for (int round = 0; round < kRounds; ++round) {
        double real = 0, calculated = 0;
        for (std::size_t i = stride / 2; i < tasks.size(); i += stride) {
            Lines lines = tasks[i].lines;
            lines.spacing = spacing;
            real += length(loops(*tasks[i].area, lines));
            calculated += even_length(rooms[i], lines);
        }
        if (real > 0) laid = real / calculated;
        spacing = bisected(bead_width, kWidest * endless, wanted / laid, by_calculation);
    }
    return spacing;
}

} // namespace filum::infill
