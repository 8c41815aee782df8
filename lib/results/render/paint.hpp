// Colours the points of a surface: shading, a field, lines, beads, voids and overlaps.
#pragma once

#include "render/plan.hpp"
#include "render/surface_beads.hpp"

namespace filum::render {

// What a picture of a surface and its path shows.
struct Show {
    // the field that colours the surface; "": grey. With a field and without `voids`, beads are drawn slim
    std::string by;
    std::string arrows; // the field of vectors that is drawn as strokes
    bool voids = false, overlap = false, centres = true;
    std::vector<double> around = {}; // x, y, z, radius in mm of the ball that fills the picture; empty: everything
};

// The amounts at the ends of a field's colour ramp: the least and greatest known values. If values beyond the 1st and
// 99th percentile would take more than a fifth of the ramp, they are these percentiles.
struct Scale {
    const surface::Field* field = nullptr;
    double lo = 0, hi = 1;
    bool below = false, above = false; // whether values lie beyond the ends
};

// The field of that name with that many components (0: any). Throws Error(usage), which lists the fields of the
// surface, if there is none.
const surface::Field& find_field(const surface::Sheet& sheet, const std::string& name, std::uint32_t components);

Scale scale_of(const surface::Field& field);
double amount(const surface::Field& field, std::size_t vertex); // the value at a vertex, or the length of the vector

Rgb void_colour();
Rgb overlap_colour();
Rgb unknown_colour();
Rgb patch_colour(std::size_t patch);

class Paint {
  public:
    // Keeps references to the scene and the path, which must outlive it.
    Paint(const Scene& scene, const SurfaceBeads& laid, const Show& show, const Plan& plan);
    // The colour of the point of `triangle` with these barycentric coordinates, in the light of the plan's lamp.
    [[nodiscard]] Rgb at(std::uint32_t triangle, geom::Vec3 shares) const;

  private:
    void draw_lines();
    [[nodiscard]] Rgb ground(std::uint32_t triangle, geom::Vec3 shares) const;
    [[nodiscard]] Rgb on_bead(const Cover& c, geom::Vec3& normal) const;
    const Scene* scene_;
    const surface::Sheet* sheet_;
    const SurfaceBeads* laid_;
    Show show_;
    Plan plan_;
    geom::Vec3 lamp_;
    Scale scale_;
    double slim_ = 1;                // share of their width that beads are drawn with
    std::vector<geom::Vec3> normal_; // per vertex
    Strokes lines_;                  // rims and isolines
};

} // namespace filum::render
