#include "infill/infill.hpp"

#include "infill/cells.hpp"
#include "infill/corridors.hpp"
#include "infill/links.hpp"
#include "parallel/parallel.hpp"
#include "polygon/clip.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace filum::infill {

namespace {

using polygon::Pattern;

constexpr double kWidest = 64; // spacings of endless lines: the widest that is tried
constexpr double kSame = 1e-3; // relative precision of the spacing
constexpr double kNear = 5e-3; // the same, if areas are filled to find it: a quarter of the 2 % tolerance of the share
constexpr std::size_t kTried = 48; // areas, at least, that are filled to measure how much corners take
constexpr int kRounds = 2;         // of filling
constexpr double kAround = 1.25;   // concentric lines, which come and go whole: the spacing is sought by filling,
                                   // within this factor

// The area where loops may run.
Loops inner(const Loops& area, double bead_width) { return polygon::offset(area, -bead_width / 2, polygon::kBeadArc); }

// `lines` with a rim: `area` if they have none.
Lines drawn_in(const Loops& area, Lines lines) {
    if (lines.rim == nullptr) lines.rim = &area;
    return lines;
}

// Links the outlines of cells along a rim, which come near to each other where the rim does. Before that, gaps narrower
// than a bead are filled, then cells narrower than a bead left out.
Loops linked(const Loops& cells, const Loops& room, double w) {
    const Loops wide = polygon::intersect(polygon::closed(cells, w / 2, polygon::kBeadArc), room);
    return with_links(polygon::opened(wide, w / 2, polygon::kBeadArc), room, w);
}

// A sample of the areas, filled to measure the length of their loops.
struct Sample {
    std::span<const Task> tasks;
    std::vector<std::size_t> of;

    explicit Sample(std::span<const Task> all) : tasks(all) {
        const std::size_t stride = std::max<std::size_t>(1, all.size() / kTried);
        for (std::size_t i = stride / 2; i < all.size(); i += stride) of.push_back(i);
    }
    [[nodiscard]] double area() const {
        double sum = 0;
        for (const std::size_t i : of) sum += polygon::signed_area(*tasks[i].area);
        return sum;
    }
    // mm of loops at this spacing
    [[nodiscard]] double laid(double spacing) const {
        std::vector<double> each(of.size());
        parallel::for_chunks(of.size(), 1, 0, [&](std::size_t k, std::size_t) {
            Lines lines = tasks[of[k]].lines;
            lines.spacing = spacing;
            each[k] = length(loops(*tasks[of[k]].area, lines));
        });
        return std::accumulate(each.begin(), each.end(), 0.0);
    }
};

// The spacing between lo and hi at which `length_of` is `wanted`; hi if the length is greater even there.
template <class LengthOf>
double bisected(double lo, double hi, double wanted, LengthOf&& length_of) {
    if (length_of(hi) > wanted) return hi;
    while (hi - lo > kSame * lo) {
        const double middle = (lo + hi) / 2;
        (length_of(middle) > wanted ? lo : hi) = middle;
    }
    return (lo + hi) / 2;
}

// The spacing, among those tried around `from`, at which the loops of the sample are nearest to the wanted share.
double nearest_by_filling(const Sample& sample, double from, double density, double bead_width) {
    const double wanted = density * sample.area() / bead_width;
    double lo = from / kAround, hi = from * kAround, best = from, off = 1e300;
    while (hi - lo > kNear * lo) {
        const double middle = (lo + hi) / 2, more = sample.laid(middle) - wanted;
        if (std::abs(more) < off) {
            best = middle;
            off = std::abs(more);
        }
        (more > 0 ? lo : hi) = middle;
    }
    return best;
}

} // namespace

Loops loops(const Loops& area, const Lines& o) {
    if (o.spacing >= kHollow) return {};
    const double half = o.bead_width / 2;
    const Loops room = inner(area, o.bead_width);
    if (room.empty()) return {};
    if (o.pattern == Pattern::concentric)
        return linked(polygon::intersect(room, even_cells(room, drawn_in(area, o))), room, o.bead_width);
    return polygon::opened(polygon::intersect(room, even_cells(room, o)), half, polygon::kBeadArc);
}

Loops loops(const Loops& area, std::span<const Task> parts) {
    if (parts.empty()) return {};
    if (parts.size() == 1) return loops(area, parts[0].lines);
    const double w = parts[0].lines.bead_width;
    Loops cells;
    for (const Task& t : parts)
        if (t.lines.spacing < kHollow)
            cells.add(polygon::intersect(*t.area, even_cells(*t.area, drawn_in(area, t.lines))));
    if (cells.empty()) return {};
    const Loops room = inner(area, w);
    const Loops within = polygon::intersect(polygon::unite(cells), room);
    if (std::any_of(parts.begin(), parts.end(), [](const Task& t) { return t.lines.pattern == Pattern::concentric; }))
        return linked(within, room, w);
    return with_corridors(polygon::opened(within, w / 2, polygon::kBeadArc), room, w);
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
    const Sample sample(tasks);
    double laid = 1; // mm per calculated mm: corners are rounded, and narrow cells left out
    double spacing = bisected(bead_width, kWidest * endless, wanted, by_calculation);
    for (int round = 0; round < kRounds; ++round) {
        double calculated = 0;
        for (const std::size_t i : sample.of) {
            Lines lines = tasks[i].lines;
            lines.spacing = spacing;
            calculated += even_length(rooms[i], lines);
        }
        const double real = sample.laid(spacing);
        if (real > 0) laid = real / calculated;
        spacing = bisected(bead_width, kWidest * endless, wanted / laid, by_calculation);
    }
    if (std::none_of(tasks.begin(), tasks.end(), [](const Task& t) { return t.lines.pattern == Pattern::concentric; }))
        return spacing;
    return nearest_by_filling(sample, spacing, density, bead_width);
}

double share_laid(std::span<const Task> tasks, double spacing, double bead_width) {
    const Sample sample(tasks);
    return bead_width * sample.laid(spacing) / sample.area();
}

} // namespace filum::infill
