// Transfers fields from one surface to another.
#pragma once

#include "surface/curve/line.hpp"
#include "surface/curve/locate.hpp"

namespace filum::surface::curve {

// The fields at the vertices of `to`, each interpolated at the nearest place of `from`; of places about equally near
// (within a tenth of a mean edge) at one that faces the same way. Infinite where a corner with weight is infinite.
// Vectors are directions without sign: before interpolation they are reversed where necessary to agree with the
// nearest corner's, and the result has their mean length.
std::vector<surface::Field> transferred(const Surface& from, std::span<const surface::Field> fields, const Surface& to);

// The same for a surface with a locator.
std::vector<surface::Field> transferred(const Surface& from, const Locator& locator,
                                        std::span<const surface::Field> fields, const Surface& to);

// The CAD face of each triangle of `to`: that of the place of `from` nearest to its middle, chosen as above. Empty if
// `faces`, those of `from`, is empty.
std::vector<std::uint32_t> transferred_faces(const Surface& from, std::span<const std::uint32_t> faces,
                                             const Surface& to);

} // namespace filum::surface::curve
