// Marks paths with the region that they fill.
#pragma once

#include "polygon/region.hpp"
#include "toolpath/path.hpp"

namespace filum::toolpath {

// Copies id, layer, z, height, area, stroke, join, body, tool and skipped layers from `region` to `paths`. The curves
// stay as they are.
inline void identify(RegionPaths& paths, const polygon::Region& region) {
    paths.region = region.id;
    paths.layer = region.layer;
    paths.z = region.z;
    paths.height = region.height;
    paths.area = region.area;
    paths.stroke = region.stroke;
    paths.join = region.join;
    paths.body = region.body;
    paths.tool = region.tool;
    paths.skipped = region.skipped;
}

} // namespace filum::toolpath
