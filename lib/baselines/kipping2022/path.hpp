// From points in space to strokes: even steps, smooth coordinates, nearest triangles.
#pragma once

#include "baselines/kipping2022/contours.hpp"
#include "baselines/kipping2022/options.hpp"
#include "surface/curve/locate.hpp"
#include "surfpath/plan/plan.hpp"

namespace filum::baselines::kipping2022 {

// Points in equal distances along the polyline, as near to `step` mm as may be; the ends of an open one stay.  At least
// two, three of a closed one.
Points resampled(std::span<const Vec3> points, bool closed, double step);

// The filter of A. Savitzky, M. J. E. Golay, 1964, on every coordinate: each point becomes the value there of the
// polynomial of `degree` that fits the `window` points around it best; the first and last half windows, those of the
// first and last window.  A window longer than the polyline is cut to the longest odd one; none longer than `degree`
// leaves all as it is.  Preconditions: window odd, degree >= 0.
Points smoothed(std::span<const Vec3> points, std::size_t window, std::size_t degree);

// Lays polylines as strokes.
class Strokes {
  public:
    Strokes(const Surface& surface, const Options& settled) : locator_(surface), o_(settled) {}

    // Resampled and smoothed.  Shorter than a step: noted and left out.
    void lay(std::span<const Vec3> points, surfpath::plan::Plan& to) const;

  private:
    surface::curve::Locator locator_;
    const Options& o_;
};

} // namespace filum::baselines::kipping2022
