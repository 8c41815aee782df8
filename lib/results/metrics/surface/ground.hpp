// The surface under a path, and the places of the surface that are nearest to the path.
#pragma once

#include "metrics/surface/fibres.hpp"
#include "surface/curve/locate.hpp"
#include "surface/finer.hpp"

namespace filum::metrics::surface {

using filum::surface::Surface;

inline constexpr std::size_t kGrain = 256; // samples, triangles or vertices per task of a thread

// A surface, its refinement, and the search for nearest places on both.
class Ground {
  public:
    // `edge`: mm, the greatest length of sides of the finer triangles.
    Ground(const Surface& surface, double edge);
    Ground(const Ground&) = delete;
    Ground& operator=(const Ground&) = delete;

    const Surface& surface;
    filum::surface::FinerSurface finer;

    // The place of the given surface (or of the finer one) nearest to `p`. If `axis` is not (0, 0, 0), only triangles
    // that face in its direction count, unless they are more than two `edge` farther away: this distinguishes the two
    // sides of a thin wall.
    [[nodiscard]] filum::surface::curve::Place foot(const Vec3& p, const Vec3& axis) const;
    [[nodiscard]] filum::surface::curve::Place fine_foot(const Vec3& p, const Vec3& axis) const;

    // The unit normal at a place of the given surface, interpolated between the corners.
    [[nodiscard]] Vec3 normal(const filum::surface::curve::Place& place) const;

  private:
    std::vector<Vec3> normals_;
    filum::surface::curve::Locator locator_, fine_locator_;
    double farther_; // mm
};

// Whether a point of a path of that width is beyond the rim with its foot, by more than a twentieth of the width.
bool past_rim(const Surface& s, const filum::surface::curve::Place& foot, const Vec3& p, double width);

// A short segment of a chain, and the surface at its middle.
struct Sample {
    std::uint32_t chain = 0;
    std::uint32_t layer = 0;
    double along = 0;                    // mm from the chain's start to the middle
    double length = 0;                   // mm
    double width = 0;                    // mm, of the bead
    bool turning = false;                // in or near a turn, see Bends; set by the caller
    bool hairpin = false;                //
    Vec3 at{}, a{}, b{};                 // its middle and its ends, on the path
    Vec3 tangent{};                      // unit, from end to end
    Vec3 axis{};                         // from the surface to the tool; (0, 0, 0) if unknown
    Vec3 normal{};                       // unit, of the surface
    filum::surface::curve::Place foot{}; // nearest to the middle
    double off = 0;                      // mm between the middle and its foot
    bool beside = false;                 // past_rim() of the middle
};

// Segments of equal length of every chain, as close to `step` mm as divides it evenly.
std::vector<Sample> samples(const Fibres& fibres, const Ground& ground, double step, int threads);

// Per chain the surface normals at its points, and the distances of the points from the surface, weighted by half of
// the adjacent segments. For points past a rim, or farther from the surface than a bead is wide, where the nearest
// place may be on another wall, the tool's axis is used instead, if known.
struct Feet {
    std::vector<std::vector<Vec3>> normals;
    std::vector<Weighted> off;
};
Feet feet(const Fibres& fibres, const Ground& ground, int threads);

// The projection of the path onto the finer surface: segments within triangles. Path past a rim, and path farther from
// the surface than half a bead above `level`, has no shadow.
struct Shadow {
    std::vector<filum::surface::Segment> segments;
    std::vector<double> width; // mm, per segment
    double lost = 0;           // mm of path without a connected projection: across gaps
    double beside = 0;         // mm of path past a rim
    double beside_area = 0;    // mm2: that length times its width
    double aloft = 0;          // mm of path too far from the surface
};
// For the segments of one layer. `level`: mm, the intended distance of the path from the surface. `step`: mm, the
// length projected at a time.
struct ShadowOptions {
    std::uint32_t layer = 0;
    double level = 0, step = 0.5;
};
Shadow shadow(const Fibres& fibres, const Ground& ground, const ShadowOptions& options, int threads);

} // namespace filum::metrics::surface
