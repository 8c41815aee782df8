// What a point of a surface looks like: its shape, a field, lines on it, the beads that cover it, and where none does.
#pragma once

#include "render/plan.hpp"
#include "render/strokes.hpp"
#include "render/tint.hpp"

namespace filum::render {

// What is shown of a surface and the path on it.
struct Show {
    std::string by;     // the field that colours the surface; none: it is grey
    std::string arrows; // the field of vectors drawn as strokes
    bool voids = false, overlap = false, centres = true;
};

// What the ends of a field's ramp stand for: least and greatest of its known values, or the 1st and 99th percentile of
// those where the rest would take more than a fifth of the ramp.
struct Scale {
    const surface::Field* field = nullptr;
    double lo = 0, hi = 1;
    bool below = false, above = false; // there are values beyond the ends
};

// Throws Error(usage), naming the surface's fields, if it has no field of that name or of that many components
// (0: any).
const surface::Field& find_field(const surface::Sheet& sheet, const std::string& name, std::uint32_t components);

Scale scale_of(const surface::Field& field);
double amount(const surface::Field& field, std::size_t vertex); // the length of a vector

// Extruding spans as strokes: as wide as they are, on the side that their normals look to (none: on any).
std::vector<Stroke> beads(const Scene& scene, const Tint& tint);

Rgb void_colour();
Rgb overlap_colour();
Rgb unknown_colour();

class Paint {
  public:
    // `pixel`: mm; lines on the surface are drawn about that wide.
    Paint(const Scene& scene, const Strokes& beads, const Show& show, const Plan& plan);
    // Colour of the point of `triangle` with these shares of its corners, in the light of the plan's lamp.
    [[nodiscard]] Rgb at(std::uint32_t triangle, geom::Vec3 shares) const;

  private:
    void draw_lines();
    [[nodiscard]] Rgb ground(std::uint32_t triangle, geom::Vec3 shares) const;
    [[nodiscard]] Rgb on_bead(const Cover& c, geom::Vec3& normal) const;
    const surface::Sheet* sheet_;
    const Strokes* beads_;
    Show show_;
    Plan plan_;
    geom::Vec3 lamp_;
    Scale scale_;
    std::vector<geom::Vec3> normal_; // per vertex
    Strokes lines_;                  // rims and isolines
};

} // namespace filum::render
