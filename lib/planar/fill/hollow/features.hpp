// What each part of the joined curves is: wall, skin, infill, bridge. Private to lib/planar/fill/hollow.
#pragma once

#include "fill/rings/rings.hpp"
#include "polygon/region.hpp"

namespace filum::fill::hollow {

// Closed curves, each of one feature.
struct LooseCurves {
    rings::Rings rings;
    std::vector<toolpath::Feature> feature; // per loop
};

// Sets the feature of every segment of the curves: that of the loop nearest to its middle, within `w` mm. Solid
// segments on a top surface become `top`. Regions that are not of the part get one of the features of supports and
// skirts.
void tell_features(const polygon::Region& region, const LooseCurves& from, double w,
                   std::vector<toolpath::Curve>& curves);

} // namespace filum::fill::hollow
