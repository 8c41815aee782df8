#include "fill/inset.hpp"

#include "polygon/clip.hpp"

namespace filum::fill {

using polygon::Loops;

Loops inset(const Loops& area, double by) {
    constexpr double simplify = 0.002, arc = 0.004; // mm; nested insets add their errors up, so far below a bead
    return polygon::simplify(polygon::offset(area, -by, arc), simplify);
}

double note_unplaced(const Loops& region, const Loops& reached, double bead_width, Notes& notes) {
    const auto rest = polygon::subtract(region, reached);
    Note note{"", "not reached by a bead", 0, "mm2", 0};
    double largest = bead_width * bead_width;
    for (const auto& part : polygon::split(rest).part) {
        const double area = polygon::signed_area(part);
        if (area <= bead_width * bead_width || polygon::offset(part, -bead_width / 4).empty()) continue;
        note.amount += area;
        ++note.count;
        if (area <= largest) continue;
        largest = area;
        note.x = part[0][0].x;
        note.y = part[0][0].y;
    }
    if (note.count > 0) notes.push_back(note);
    return note.amount;
}

} // namespace filum::fill
