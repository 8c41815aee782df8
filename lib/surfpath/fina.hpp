// FInA: rows along lines of equal distance from a seed curve.
#pragma once

#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

Plan fina(const surface::Sheet& sheet, const Options& options);

} // namespace filum::surfpath
