// Two spirals of lines along the boundary of a surface, one in and one out, side by side (Geo-FISO of Kipping et al.
// 2022, made one path).
#pragma once

#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

Plan geo_fiso(const surface::Sheet& sheet, const Options& options);

} // namespace filum::surfpath
