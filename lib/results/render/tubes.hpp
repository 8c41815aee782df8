// The beads of a scene as round curves, and its meshes, as targets of rays (Embree).
#pragma once

#include "render/tint.hpp"

#include <array>
#include <memory>

namespace filum::render {

struct Hit {
    bool any = false;
    float distance = 0; // along the ray, in lengths of its direction
    geom::Vec3 normal;  // in the space of the part, length 1, facing the ray
    Rgb albedo;
};

// Beads and meshes for rays. Rays use the space of the part, moved so that `centre` is the origin. So floats suffice at
// any coordinates.
class Tubes {
  public:
    Tubes(const Scene& scene, const Tint& tint, bool travels, int threads);
    ~Tubes();
    Tubes(const Tubes&) = delete;
    Tubes& operator=(const Tubes&) = delete;

    // The first hits of four rays from one point. Faster than single rays if they run close together.
    [[nodiscard]] std::array<Hit, 4> shoot(geom::Vec3 from, const std::array<geom::Vec3, 4>& direction) const;
    // True if something lies within `reach` lengths of `direction`.
    [[nodiscard]] bool blocked(geom::Vec3 from, geom::Vec3 direction, float reach) const;

    [[nodiscard]] bool empty() const;
    [[nodiscard]] geom::Vec3 centre() const; // the origin of rays, in coordinates of the part
    [[nodiscard]] geom::Vec3 half() const;   // half the size of the bounding box
    [[nodiscard]] double thickness() const;  // mm, the larger half axis of a typical bead

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace filum::render
