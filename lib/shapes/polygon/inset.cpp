#include "polygon/inset.hpp"

#include "polygon/clip.hpp"

namespace filum::polygon {

Loops inset(const Loops& area, double by) {
    constexpr double kThin = 0.002, kArc = 0.004; // mm; far below a bead, because nested insets add up their errors
    return simplify(offset(area, -by, kArc), kThin);
}

double note_unplaced(const Loops& region, const Loops& reached, double bead_width, Notes& notes) {
    const auto rest = subtract(region, reached);
    Note note{NoteCode::area_unreached, 0, 0};
    double largest = bead_width * bead_width;
    for (const auto& part : split(rest).part) {
        const double area = signed_area(part);
        if (area <= bead_width * bead_width || offset(part, -bead_width / 4).empty()) continue;
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

} // namespace filum::polygon
