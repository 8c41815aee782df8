// Rules of the 3MF standard for units, transforms, extensions and kinds of objects; private to lib/shapes/mesh.
#pragma once

#include "geom/affine.hpp"

#include <array>
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

// The attribute "path" of the production extension, with any namespace prefix; "" if there is none.
std::string part_path(const pugi::xml_node& node);

// The twelve numbers of a transform.
std::array<double, 12> numbers(const geom::Affine& place);

// True if another element follows, of any name.
bool has_another(const pugi::xml_node& node);

// The length of a unit in mm; none for an unknown name.
std::optional<double> unit_mm(std::string_view name);

// The map of a transform attribute with twelve numbers; none if there are not twelve.
std::optional<geom::Affine> transform(const char* text);

// The first extension that `model` requires and this reader does not support, or "" if all are supported. The result is
// the extension's usual name, such as "beamlattice". It is the whole namespace if that is not one of the consortium's,
// and the prefix if no namespace is declared for it. Extensions that do not change the shape of objects (materials,
// triangle sets) are supported.
std::string unsupported_extension(const pugi::xml_node& model);

// The purpose of an object.
enum class Function : std::uint8_t { part, support, surface, other, unknown };
Function function_of(const pugi::xml_node& object);

// The name of an element other than triangles that describes the shape of an object or a mesh, such as "beamlattice" or
// "booleanshape". "" if there is none.
std::string foreign_shape(const pugi::xml_node& object);

// True if the triangles of an object only approximate its shape, which is given by slices (slice extension).
bool is_low_resolution(const pugi::xml_node& object);

} // namespace filum::mesh::threemf
