// A sheet in triangles that are small beside the spacing.
#pragma once

#include "surface/sheet.hpp"
#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

struct Fine {
    surface::Sheet sheet;              // its surface, and its sources; nothing else
    std::vector<std::uint32_t> parent; // per triangle: the one of the given sheet that it is part of
};

// The same sheet, in an order that does not depend on the given one, and in triangles with sides of at most `edge` mm,
// or as near to that as half a million triangles come. Lines are straight between sides of triangles: so what several
// lines do within one triangle does not depend on them.
Fine fine(const surface::Sheet& sheet, double edge);

// The plan on the given sheet: its places named by the triangles of that.
void back(Plan& plan, const Fine& fine);

} // namespace filum::surfpath::plan
