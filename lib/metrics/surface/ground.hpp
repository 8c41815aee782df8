// The surface below a path, and where the path touches it.
#pragma once

#include "metrics/surface/chains.hpp"
#include "surface/curve/locate.hpp"
#include "surface/finer.hpp"

namespace filum::metrics::surface {

using filum::surface::Surface;

inline constexpr std::size_t kGrain = 256; // samples, triangles or vertices of a piece of work

// A surface, the same in finer triangles, and what finds places on both.
class Ground {
  public:
    // `edge`: mm, the longest side of the finer triangles.
    Ground(const Surface& surface, double edge);
    Ground(const Ground&) = delete;
    Ground& operator=(const Ground&) = delete;

    const Surface& surface;
    filum::surface::FinerSurface finer;

    // The place of the given surface (or of the finer one) nearest to `p`; if `axis` is not (0, 0, 0), among triangles
    // that face its way, unless those are more than two `edge` farther off: so a thin wall's skins are told apart.
    [[nodiscard]] filum::surface::curve::Place foot(const Vec3& p, const Vec3& axis) const;
    [[nodiscard]] filum::surface::curve::Place fine_foot(const Vec3& p, const Vec3& axis) const;

    // Unit, interpolated between the corners'; of a place on the given surface.
    [[nodiscard]] Vec3 normal(const filum::surface::curve::Place& place) const;

  private:
    std::vector<Vec3> normals_;
    filum::surface::curve::Locator locator_, fine_locator_;
    double farther_; // mm
};

// Whether a place of a path of that width lies past the rim that its foot is on, by more than a twentieth of the bead.
bool past_rim(const Surface& s, const filum::surface::curve::Place& foot, const Vec3& p, double width);

// A short stretch of a chain, and the surface at its middle.
struct Sample {
    std::uint32_t chain = 0;
    std::uint32_t layer = 0;
    double along = 0;                    // mm from the chain's start to the middle
    double length = 0;                   // mm
    double width = 0;                    // mm, of the bead
    bool turning = false;                // in or near a turn, see Bends; set by whoever has them
    bool hairpin = false;                //
    Vec3 at{}, a{}, b{};                 // its middle and its ends, on the path
    Vec3 tangent{};                      // unit, from end to end
    Vec3 axis{};                         // where the tool comes from; (0, 0, 0) where that is not said
    Vec3 normal{};                       // unit, of the surface
    filum::surface::curve::Place foot{}; // nearest to the middle
    double off = 0;                      // mm between the middle and its foot
    bool beside = false;                 // it lies past a rim, by more than a twentieth of the bead
};

// Every chain in stretches of equal length, as near to `step` mm as divides it evenly.
std::vector<Sample> samples(const Fibres& fibres, const Ground& ground, double step, int threads);

// Per chain the surface's normals at its points; past a rim, or farther off than a bead is wide, where the nearest
// place may be on another wall, the tool's axis, if that is known; and how far the points are from the surface,
// weighted by half of the stretches beside them.
struct Feet {
    std::vector<std::vector<Vec3>> normals;
    std::vector<Weighted> off;
};
Feet feet(const Fibres& fibres, const Ground& ground, int threads);

// The shadow of the path on the finer surface: stretches within triangles.  It has none where it lies past a rim by
// more than a twentieth of the bead, or is farther from the surface than half a bead above `level`.
struct Shadow {
    std::vector<filum::surface::Segment> segments;
    std::vector<double> width; // mm, per segment
    double lost = 0;           // mm of path that no way on the surface follows: across gaps
    double beside = 0;         // mm of path past a rim,
    double beside_area = 0;    // mm2, times its width
    double aloft = 0;          // mm of path too far from the surface
};
// Of the stretches of one layer.  `level`: mm, how far the path is meant to be from the surface.  `step`: mm, stretches
// laid at once.
struct ShadowOptions {
    std::uint32_t layer = 0;
    double level = 0, step = 0.5;
};
Shadow shadow(const Fibres& fibres, const Ground& ground, const ShadowOptions& options, int threads);

} // namespace filum::metrics::surface
