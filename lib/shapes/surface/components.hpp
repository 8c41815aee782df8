// Splits a sheet into its connected components.
#pragma once

#include "surface/sheet.hpp"

namespace filum::surface {

// One component with its part of the fields and sources; the rest of the sheet is left out.
struct Component {
    Sheet sheet;
    std::vector<std::uint32_t> triangles; // per triangle: its number in the whole sheet
};

// The components in their order; vertices, triangles and sources keep the order of the whole.
std::vector<Component> components(const Sheet& whole);

} // namespace filum::surface
