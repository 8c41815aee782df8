// Finds segments inside solid material, which no ray can reach.
#pragma once

#include "render/scene.hpp"

namespace filum::render {

// A grid of cells about one bead wide and one layer high. A segment is hidden if all cells on it, and the 26 cells
// around each of them, hold beads. Gaps between beads leave empty cells, so a visible segment is never hidden, except
// behind a chink narrower than a bead.
class HiddenBeads {
  public:
    // `width`, `height`: size of a typical bead, mm. In a scene of more than 2^29 cells nothing is hidden.
    HiddenBeads(const Scene& scene, double width, double height);
    [[nodiscard]] bool operator()(geom::Vec3 a, geom::Vec3 b) const;

  private:
    template <class F>
    void for_cells(geom::Vec3 a, geom::Vec3 b, F&& f) const;
    void erode();
    geom::Vec3 lo_, cell_;
    std::size_t words_ = 0, rows_ = 0, levels_ = 0; // words of 64 cells along x; cells along y; cells along z
    std::vector<std::uint64_t> full_;
};

} // namespace filum::render
