// One spiral of lines along the boundary of a surface (Geo-Contour of Kipping et al. 2022, made one path).
#pragma once

#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

Plan geo_contour(const surface::Sheet& sheet, const Options& options);

} // namespace filum::surfpath
