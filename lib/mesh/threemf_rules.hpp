// What the 3MF standard says of extensions and of kinds of objects; private to lib/mesh.
#pragma once

#include "geom/affine.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pugi {
class xml_node;
}

namespace filum::mesh::threemf {

// The name of an element without its namespace prefix.
std::string_view local_name(const pugi::xml_node& node);

// Whether another element follows.
bool has_another(const pugi::xml_node& node);

// How long a unit of that name is, mm; none for an unknown one.
std::optional<double> unit_mm(std::string_view name);

// The map that the twelve numbers of a transform give; none if there are not twelve.
std::optional<geom::Affine> transform(const char* text);

// The first extension that `model` requires and that this reader does not support, by the name that people know it by:
// "beamlattice"; its whole namespace if that is not one of the consortium's, its prefix if no namespace is declared
// for it; "" if all are supported.  Extensions that leave the shape of objects alone (materials, triangle sets) are.
std::string unsupported_extension(const pugi::xml_node& model);

// What an object is for.
enum class Function : std::uint8_t { part, support, surface, other, unknown };
Function function_of(const pugi::xml_node& object);

// The name of what describes the shape of an object or a mesh beside its triangles, "beamlattice", "booleanshape", ...;
// "" if there is nothing of the kind.
std::string foreign_shape(const pugi::xml_node& object);

// True for an object whose triangles only hint at its shape, which is in its slices (slice extension).
bool is_low_resolution(const pugi::xml_node& object);

} // namespace filum::mesh::threemf
