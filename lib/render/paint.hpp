// What a point of a surface looks like: its shape, a field, lines on it, the beads that cover it, and where none does.
#pragma once

#include "render/lay.hpp"
#include "render/plan.hpp"

namespace filum::render {

// What is shown of a surface and the path on it.
struct Show {
    std::string by;     // the field that colours the surface; none: it is grey.  Without `voids` beads are then slim
    std::string arrows; // the field of vectors drawn as strokes
    bool voids = false, overlap = false, centres = true;
    std::vector<double> around = {}; // x, y, z, radius in mm of what the picture is filled with; none: everything
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

Rgb void_colour();
Rgb overlap_colour();
Rgb unknown_colour();
Rgb patch_colour(std::size_t patch);

class Paint {
  public:
    // Keeps references to the scene and the path.
    Paint(const Scene& scene, const Laid& laid, const Show& show, const Plan& plan);
    // Colour of the point of `triangle` with these shares of its corners, in the light of the plan's lamp.
    [[nodiscard]] Rgb at(std::uint32_t triangle, geom::Vec3 shares) const;

  private:
    void draw_lines();
    [[nodiscard]] Rgb ground(std::uint32_t triangle, geom::Vec3 shares) const;
    [[nodiscard]] Rgb on_bead(const Cover& c, geom::Vec3& normal) const;
    const Scene* scene_;
    const surface::Sheet* sheet_;
    const Laid* laid_;
    Show show_;
    Plan plan_;
    geom::Vec3 lamp_;
    Scale scale_;
    double slim_ = 1;                // share of their width that beads are drawn
    std::vector<geom::Vec3> normal_; // per vertex
    Strokes lines_;                  // rims and isolines
};

} // namespace filum::render
