#include "surfpath/geo_contour.hpp"

#include "surfpath/ring_path.hpp"

namespace filum::surfpath {

Plan geo_contour(const surface::Sheet& sheet, const Options& options) { return ring_path(sheet, options, 1); }

} // namespace filum::surfpath
