// Names for the cells of a surface and the tension on them; patches are sets of cells.
#pragma once

#include "surface/directions/pull.hpp"

namespace filum::partition {

using geom::Vec3;
using surface::kNone;
using surface::Surface;
using surface::directions::across;
using surface::directions::CellBorder;
using surface::directions::Cells;
using surface::directions::cells;
using surface::directions::percentile;
using surface::directions::Pull;
using surface::directions::pull;
using surface::directions::PullOptions;
using surface::directions::smooth;
using surface::directions::turned;

} // namespace filum::partition
