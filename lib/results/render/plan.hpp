// Parallel projection onto a picture, and the triangle of a surface that each sample shows.
#pragma once

#include "geom/vec.hpp"
#include "surface/surface.hpp"

#include <cstdint>
#include <vector>

namespace filum::render {

// A parallel projection. Lengths across the line of sight have the same scale everywhere.
struct Plan {
    int width = 0, height = 0; // pixels
    // `centre` in mm; the others are unit vectors, and `towards` points to the viewer.
    geom::Vec3 centre, right, up, towards;
    double scale = 1; // pixels per mm

    // The place of `p` in the picture: pixels from the upper left corner, y downwards, and mm towards the viewer.
    [[nodiscard]] geom::Vec3 place(geom::Vec3 p) const;
};

// The direction that points up in a view from direction `from`: z, or y if z would look short.
geom::Vec3 upwards(geom::Vec3 from);

// A plan that looks from direction `from` and fits all points into a picture of that size. It leaves a margin, wider
// below for the legend. `above` points up and must not be parallel to `from`.
Plan lay_out(const std::vector<geom::Vec3>& points, geom::Vec3 from, geom::Vec3 above, int width, int height);

// What a sample of the picture shows: a triangle, and the height of its point.
struct Sight {
    std::uint32_t triangle = surface::kNone; // kNone: nothing
    float height = 0;                        // mm towards the viewer
};

// Samples in rows, with `fine` x `fine` of them in every pixel.
struct Sights {
    int columns = 0, rows = 0;
    std::vector<Sight> sample;
    [[nodiscard]] const Sight& at(int x, int y) const {
        return sample[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x)];
    }
};

// A depth buffer, computed in bands of pixel rows with at most about 32 MB each. The nearest triangle wins; ties: the
// first.
class Raster {
  public:
    // `fine`: samples along each side of a pixel.
    Raster(const surface::Surface& s, const Plan& plan, int fine);
    [[nodiscard]] int bands() const { return static_cast<int>(in_band_.size()); }
    [[nodiscard]] int rows() const { return rows_; } // rows of pixels in each band; the last may have fewer
    [[nodiscard]] Sights band(int b) const;
    // Barycentric coordinates of the point of `triangle` that sample (x, y) of the picture shows.
    [[nodiscard]] geom::Vec3 shares(std::uint32_t triangle, int x, int y) const;

  private:
    void cover(std::uint32_t triangle, int first_row, Sights& out) const;
    const surface::Surface* s_;
    Plan plan_;
    int fine_, rows_;
    std::vector<geom::Vec3> place_; // places of the vertices, in samples
    std::vector<std::vector<std::uint32_t>> in_band_;
};

} // namespace filum::render
