// From points in space to strokes: even steps, smooth coordinates, nearest triangles.
#pragma once

#include "baselines/kipping2022/contours.hpp"
#include "baselines/kipping2022/options.hpp"
#include "surface/curve/locate.hpp"
#include "surfpath/plan/plan.hpp"

namespace filum::baselines::kipping2022 {

// Points at equal distances along the polyline, as close to `step` mm as possible; the ends of an open one stay. At
// least two points, three of a closed one.
Points resampled(std::span<const Vec3> points, bool closed, double step);

// The filter of A. Savitzky, M. J. E. Golay, 1964, on every coordinate: each point is replaced by the value of the
// polynomial of `degree` that fits the `window` points around it best; the first and last half windows, by the
// polynomials of the first and last window. A window longer than the polyline is reduced to the longest odd one; if
// that is not longer than `degree`, the points stay. Preconditions: window odd, degree >= 0.
Points smoothed(std::span<const Vec3> points, std::size_t window, std::size_t degree);

// Adds polylines to a plan as strokes.
class Strokes {
  public:
    Strokes(const Surface& surface, const Options& settled) : locator_(surface), o_(settled) {}

    // Resamples and smooths the polyline. One shorter than a step is omitted with a note.
    void lay(std::span<const Vec3> points, surfpath::plan::Plan& to) const;

  private:
    surface::curve::Locator locator_;
    const Options& o_;
};

} // namespace filum::baselines::kipping2022
