// Places in figures.
#pragma once

#include "base/number.hpp"
#include "geom/vec.hpp"

#include <string>

namespace filum::metrics::surface {

// "x,y,z" in mm, to a hundredth.
inline std::string place_text(const geom::Vec3& p) {
    return fixed_text(p.x, 2) + "," + fixed_text(p.y, 2) + "," + fixed_text(p.z, 2);
}

} // namespace filum::metrics::surface
