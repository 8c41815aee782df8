// A sheet in the components that it consists of.
#pragma once

#include "surface/sheet.hpp"

namespace filum::surface {

// One component, with its share of the fields and of the sources; nothing else of the sheet.
struct Component {
    Sheet sheet;
    std::vector<std::uint32_t> triangles; // per triangle of it: its number in the whole
};

// By component; vertices, triangles and sources in the order that they have in the whole.
std::vector<Component> components(const Sheet& whole);

} // namespace filum::surface
