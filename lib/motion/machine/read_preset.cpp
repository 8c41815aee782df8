#include "machine/read_preset.hpp"

#include "geom/hull.hpp"

#include <algorithm>
#include <utility>

namespace filum::machine {

namespace {

// Reads the outline of a bed.  There is none if the bed is a rectangle along the axes, or if it is not convex.
void read_outline(const preset::Preset& preset, Bed& bed) {
    const bool orca = preset.slicer == "orca" || preset.slicer == "bambu";
    const auto found = preset.settings.find(orca ? "printable_area" : "bed_shape");
    if (found == preset.settings.end()) return;
    const std::vector<geom::Vec2> points = preset::corners(found->second);
    const auto hull = geom::convex_hull(points);
    const bool rectangle = hull.size() == 4 && std::ranges::all_of(hull, [&](const geom::Vec2& p) {
                               return (p.x == bed.x_min || p.x == bed.x_max) && (p.y == bed.y_min || p.y == bed.y_max);
                           });
    if (!rectangle && hull.size() >= 3 && hull.size() >= points.size()) bed.outline = hull;
}

} // namespace

void read_preset(Document& doc, Profile& p) {
    p.templates.primed = p.templates.start.find("{purge") != std::string::npos;
    if (!doc.has("preset")) return;
    auto preset = std::make_shared<preset::Preset>();
    doc.choice("preset.slicer", preset->slicer, {"", "slic3r", "prusa", "super", "orca", "bambu", "cura"});
    doc.text("preset.input", preset->input);
    doc.texts("preset.settings", preset->settings);
    doc.uses("{nozzle_temp}{first_nozzle_temp}{bed_temp}{first_bed_temp}");
    p.templates.primed = true;
    read_outline(*preset, p.bed);
    p.preset = std::move(preset);
}

} // namespace filum::machine
