// The cells of a surface and along what they are pulled: what patches are made of.
#pragma once

#include "surface/directions/pull.hpp"

namespace filum::partition {

using geom::Vec3;
using surface::kNone;
using surface::Surface;
using surface::directions::across;
using surface::directions::Cells;
using surface::directions::cells;
using surface::directions::percentile;
using surface::directions::Pull;
using surface::directions::pull;
using surface::directions::PullOptions;
using surface::directions::Side;
using surface::directions::smooth;
using surface::directions::turned;

} // namespace filum::partition
