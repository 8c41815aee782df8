// Parallel projection onto a picture, and which triangle of a surface every sample of it shows.
#pragma once

#include "geom/vec.hpp"
#include "surface/surface.hpp"

#include <cstdint>
#include <vector>

namespace filum::render {

// Lengths across the line of sight are true to scale everywhere.
struct Plan {
    int width = 0, height = 0;             // pixels
    geom::Vec3 centre, right, up, towards; // unit vectors; `towards` the viewer
    double scale = 1;                      // pixels per mm

    // Pixels from the upper left corner, y downwards, and mm towards the viewer.
    [[nodiscard]] geom::Vec3 place(geom::Vec3 p) const;
};

// Which way is up where one looks from direction `from`: z, or y where z would be short.
geom::Vec3 upwards(geom::Vec3 from);

// Looks from direction `from` so that all points fill a picture of that size, but for a margin, wider below, where the
// legend is.  `above`, not along `from`, points up.
Plan lay_out(const std::vector<geom::Vec3>& points, geom::Vec3 from, geom::Vec3 above, int width, int height);

// What a sample of the picture shows: the triangle, and the point of it.
struct Sight {
    std::uint32_t triangle = surface::kNone; // none: nothing
    float height = 0;                        // mm towards the viewer
};

// Rows of samples: `fine` x `fine` in every pixel.
struct Sights {
    int columns = 0, rows = 0;
    std::vector<Sight> sample;
    [[nodiscard]] const Sight& at(int x, int y) const {
        return sample[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x)];
    }
};

// A depth buffer by bands of rows of pixels, some 32 MB each at most; the nearest triangle counts, the first of equals.
class Raster {
  public:
    // `fine`: samples along either side of a pixel.
    Raster(const surface::Surface& s, const Plan& plan, int fine);
    [[nodiscard]] int bands() const { return static_cast<int>(in_band_.size()); }
    [[nodiscard]] int rows() const { return rows_; } // of pixels, in every band but the last
    [[nodiscard]] Sights band(int b) const;
    // The point of `triangle` that sample (x, y) of the picture shows, as shares of its corners.
    [[nodiscard]] geom::Vec3 shares(std::uint32_t triangle, int x, int y) const;

  private:
    void cover(std::uint32_t triangle, int first_row, Sights& out) const;
    const surface::Surface* s_;
    Plan plan_;
    int fine_, rows_;
    std::vector<geom::Vec3> place_; // of the vertices, in samples
    std::vector<std::vector<std::uint32_t>> in_band_;
};

} // namespace filum::render
