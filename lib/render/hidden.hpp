// Which segments lie inside solid material, where no ray comes.
#pragma once

#include "render/scene.hpp"

namespace filum::render {

// A grid of cells about one bead wide and one layer high; a segment is hidden if all cells that it passes, and all 26
// around each, hold beads.  Spans of beads that leave gaps have cells without beads, so what can be seen is never
// hidden, but for a chink narrower than a bead.
class Hidden {
  public:
    // `width`, `height`: of a typical bead, mm.  A scene of more than 2^29 cells hides nothing.
    Hidden(const Scene& scene, double width, double height);
    [[nodiscard]] bool operator()(geom::Vec3 a, geom::Vec3 b) const;

  private:
    template <class F>
    void for_cells(geom::Vec3 a, geom::Vec3 b, F&& f) const;
    void erode();
    geom::Vec3 lo_, cell_;
    std::size_t words_ = 0, rows_ = 0, levels_ = 0; // of 64 cells along x; along y; along z
    std::vector<std::uint64_t> full_;
};

} // namespace filum::render
