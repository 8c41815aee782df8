// Whose paths they are.
#pragma once

#include "polygon/region.hpp"
#include "toolpath/path.hpp"

namespace filum::fill {

// Gives `paths` the number, place, area, stroke and join of the region that they fill; curves stay as they are.
inline void identify(toolpath::RegionPaths& paths, const polygon::Region& region) {
    paths.region = region.id;
    paths.layer = region.layer;
    paths.z = region.z;
    paths.height = region.height;
    paths.area = region.area;
    paths.stroke = region.stroke;
    paths.join = region.join;
}

} // namespace filum::fill
