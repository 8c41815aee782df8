// Cuts one chunk of layers: from sections of the mesh to the solid of each layer.
#include "polygon/simple.hpp"
#include "slice/bodies.hpp"
#include "slice/section.hpp"

#include <algorithm>
#include <cmath>

namespace filum::slice {

namespace {

constexpr double kTurnedShare = 0.05; // of all contours; if more is turned, parity decides instead of orientation

double perimeter(const Loops& loops) {
    double sum = 0;
    for (std::size_t i = 0; i < loops.size(); ++i) sum += polygon::perimeter(loops[i]);
    return sum;
}

void add_walls(const Loops& loops, bool marked, std::vector<polygon::Wall>& out) {
    for (polygon::Wall w : polygon::walls(loops)) {
        w.marked = marked;
        w.weight = marked ? 1 : 0;
        out.push_back(w);
    }
}

// The solid of a layer with open contours. If too much of them is turned, parity decides. Else closed contours decide
// alone if none of them is guessed; otherwise the winding number of the surface decides.
Loops open_solid(const Sweep& sweep, std::size_t layer, Loops loops, std::vector<OpenContour> contours, Notes& notes) {
    std::vector<polygon::Wall> walls;
    add_walls(loops, true, walls);
    for (const OpenContour& c : contours)
        for (std::size_t i = 1; i < c.points.size(); ++i) walls.push_back({c.points[i - 1], c.points[i], 1, true});
    const auto number = static_cast<std::int64_t>(layer);
    const ClosedContours closed = close_contours(
        std::move(contours), [&] { return lid_contours(sweep, layer); }, sweep.options, number, notes);
    add_walls(closed.guessed, false, walls);
    for (const Loops* more : {&closed.whole, &closed.guessed})
        for (std::size_t l = 0; l < more->size(); ++l) loops.add((*more)[l]);
    const double all = perimeter(loops);
    if (closed.turned > kTurnedShare * all) {
        notes.push_back({.code = NoteCode::inside_by_parity, .amount = all, .layer = number});
        return polygon::unite_exactly(loops, polygon::Fill::even_odd);
    }
    if (closed.guessed.empty()) return polygon::unite_exactly(loops);
    return solid_within(walls, *sweep.part->winding, sweep.levels[layer].plane + kLift);
}

Loops contours(const Sweep& sweep, std::size_t layer, Section section, Notes& notes) {
    const mesh::Bodies& bodies = sweep.part->bodies;
    const bool closed = section.open.empty(), simple = closed && polygon::is_simple(section.loops);
    if (simple && bodies.shells == 1) return std::move(section.loops);
    Loops solid = closed ? unite_bodies(section.loops, section.body, bodies.hollow)
                         : open_solid(sweep, layer, std::move(section.loops), std::move(section.open), notes);
    return heal_hairlines(std::move(solid), !simple, sweep.options.hairline, static_cast<std::int64_t>(layer), notes);
}

} // namespace

SlicedChunk cut(const Sweep& sweep, std::size_t chunk) {
    SlicedChunk out;
    std::size_t i = chunk * kChunk;
    for (Section& section : sections(sweep, chunk)) {
        const Level& level = sweep.levels[i];
        out.layers.push_back({static_cast<std::uint32_t>(i), level.z, level.height, level.plane,
                              contours(sweep, i, std::move(section), out.notes)});
        ++i;
    }
    return out;
}

} // namespace filum::slice
