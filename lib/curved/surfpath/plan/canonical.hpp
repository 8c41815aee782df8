// The surface that lines of field are planned on: the given one without what rounding and the choice of axes add.
#pragma once

#include "surface/sheet.hpp"
#include "surfpath/plan/plan.hpp"

#include <array>

namespace filum::surfpath::plan {

// A frame whose axes are those of another frame in another order or direction, right-handed, with its origin at
// `centre`.
struct AxisFrame {
    std::array<int, 3> axis{0, 1, 2};    // per axis here: the axis there
    std::array<double, 3> sign{1, 1, 1}; // and its direction
    Vec3 centre;                         // mm, there
    [[nodiscard]] Vec3 into(const Vec3& direction) const;
    [[nodiscard]] Vec3 out_of(const Vec3& direction) const;
};

struct CanonicalSheet {
    surface::Sheet sheet; // in the frame
    AxisFrame frame;
    Vec3 direction; // the given one, in the frame and unit; like fields without its last bits
};

// Cells of the grid, in spacings. A power of two, so that points of the grid are exact.
inline constexpr double kGrid = 1.0 / 1024;

// The sheet with its vertices at points of a grid of kGrid spacings around the middle of its bounding box, in the one
// of 24 frames in which sums over these points are smallest. So two sheets that differ only by rounding, by the order
// of vertices, or by a motion whose rotation is by right angles become the same sheet, except for the order. A corner
// of a triangle that is lower than rules::kFineGrain spacings keeps its place to the last bit, because moving it could
// turn the triangle over. Other places lie at half cells only if they have more digits than files do: half a cell has
// eleven digits more than the spacing. `direction`: what lines shall follow; it decides between frames in which the
// surface looks the same, as fields do.
CanonicalSheet canonical(const surface::Sheet& sheet, double spacing, const Vec3& direction);

// Moves the plan of a canonical sheet to the sheet that it was made from, triangle by triangle.
void from_canonical(Plan& plan, const CanonicalSheet& canonical, const surface::Sheet& given);

} // namespace filum::surfpath::plan
