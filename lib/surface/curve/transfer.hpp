// Fields from one surface to another.
#pragma once

#include "surface/curve/line.hpp"

namespace filum::surface::curve {

// The fields at the vertices of `to`, each interpolated at the nearest place of `from`; of places that are about as
// near (to a tenth of a mean edge), at one that faces the same way.  Infinite where a corner that counts is.  Vectors
// are directions without a sign: they are turned to the way of the nearest corner's before they are mixed, and keep
// their mean length.
std::vector<surface::Field> transferred(const Surface& from, std::span<const surface::Field> fields, const Surface& to);

// The CAD face of each triangle of `to`: that of the nearest place of `from` to its middle, of places about as near at
// one that faces the same way; none if `faces`, those of `from`, are none.
std::vector<std::uint32_t> transferred_faces(const Surface& from, std::span<const std::uint32_t> faces,
                                             const Surface& to);

} // namespace filum::surface::curve
