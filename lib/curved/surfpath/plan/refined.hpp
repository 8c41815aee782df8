// Refines a sheet until its triangles are small compared with the spacing.
#pragma once

#include "surface/sheet.hpp"
#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

struct RefinedSheet {
    surface::Sheet sheet;              // surface and sources only
    std::vector<std::uint32_t> parent; // per triangle: the triangle of the given sheet that contains it
    std::vector<std::uint32_t> vertex; // per vertex of the given sheet, in the new order: its number there; new ones
                                       // follow
};

// The sheet, refined until triangles have sides of at most `edge` mm or there are rules::kMostPieces of them. Lines are
// straight within a triangle, so small triangles let neighbouring lines differ. The order of vertices and triangles
// does not depend on that of the given sheet.
RefinedSheet refined(const surface::Sheet& sheet, double edge);

// Fields of the given sheet at the vertices of the refined one.
std::vector<surface::Field> on_refined(const surface::Sheet& given, std::span<const surface::Field> fields,
                                       const RefinedSheet& refined);

// Replaces the triangles of the plan's places by their parents in the given sheet.
void to_parents(Plan& plan, const RefinedSheet& refined);

} // namespace filum::surfpath::plan
