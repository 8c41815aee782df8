// The beads of a scene as round curves, and its meshes, that rays can be shot at (Embree).
#pragma once

#include "render/tint.hpp"

#include <array>
#include <memory>

namespace filum::render {

struct Hit {
    bool any = false;
    float distance = 0; // along the ray, in lengths of its direction
    geom::Vec3 normal;  // in the part's space, length 1, towards the ray's side
    Rgb albedo;
};

// Space for rays: that of the part, moved so that `centre` is the origin (floats then suffice at any coordinates).
class Tubes {
  public:
    Tubes(const Scene& scene, const Tint& tint, bool travels, int threads);
    ~Tubes();
    Tubes(const Tubes&) = delete;
    Tubes& operator=(const Tubes&) = delete;

    // What four rays from one point hit first; faster than one by one where they run close together.
    [[nodiscard]] std::array<Hit, 4> shoot(geom::Vec3 from, const std::array<geom::Vec3, 4>& direction) const;
    // True if something lies within `reach` lengths of `direction`.
    [[nodiscard]] bool blocked(geom::Vec3 from, geom::Vec3 direction, float reach) const;

    [[nodiscard]] bool empty() const;
    [[nodiscard]] geom::Vec3 centre() const; // in the part's coordinates
    [[nodiscard]] geom::Vec3 half() const;   // half the size of the box around everything
    [[nodiscard]] double thickness() const;  // mm, of a typical bead: the larger of its half axes

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace filum::render
