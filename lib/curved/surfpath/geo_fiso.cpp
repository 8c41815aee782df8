#include "surfpath/geo_fiso.hpp"

#include "surfpath/ring_path.hpp"

namespace filum::surfpath {

Plan geo_fiso(const surface::Sheet& sheet, const Options& options) { return ring_path(sheet, options, 2); }

} // namespace filum::surfpath
