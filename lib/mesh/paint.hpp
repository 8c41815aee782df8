// What slicers paint on triangles.  Private to lib/mesh.
#pragma once

#include "mesh/read.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace filum::mesh {

using Corners = std::array<geom::Vec3, 3>;

enum class Paint : std::uint8_t { none, wanted, unwanted, other };

// Calls put(paint, corners) for what of a triangle is painted, as PrusaSlicer, OrcaSlicer and Bambu Studio keep it: hex
// digits from the last to the first.  The lowest two bits of a digit say how many sides of the triangle are cut in
// half. None: the other two are what it is painted with; 3 stands for three more than the next digit says.  Else they
// are the side that the cut is told from, and the digits of two to four smaller triangles follow, the last of them
// first. False, after some calls, for what is no such text, or cut more than 32 times.
bool each_painted(std::string_view text, const Corners& corners, const std::function<void(Paint, const Corners&)>& put);

// A triangle with what is painted on it, as a project writes that.
struct PaintedTriangle {
    Triangle triangle;
    const char* digits = nullptr;
};

// Adds the faces of `to` that are painted, as bodies, with a note on those whose paint cannot be read.
void add_painted(const std::vector<PaintedTriangle>& painted, File& to);

} // namespace filum::mesh
