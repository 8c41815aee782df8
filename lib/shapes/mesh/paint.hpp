// Reads the paint that slicers store on triangles.  Private to lib/shapes/mesh.
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

// Calls put(paint, corners) for each painted part of a triangle. The text is in the format of PrusaSlicer, OrcaSlicer
// and Bambu Studio: hex digits, read from the last to the first. The lowest two bits of a digit are the number of sides
// that are halved. With none, the other two bits are the paint; 3 stands for the next digit plus three. Otherwise they
// number the corner from which the cut sides count, and the digits of two to four smaller triangles follow, the last
// triangle first. Returns false, maybe after some calls, if the text is malformed or splits a triangle more than 32
// times.
bool each_painted(std::string_view text, const Corners& corners, const std::function<void(Paint, const Corners&)>& put);

// The purpose of the paint in an attribute of a triangle: kSupportPaint, or another one in words; null if the attribute
// holds no paint.
extern const char* const kSupportPaint;
extern const char* const kSeamPaint;
const char* paint_of(std::string_view attribute);

// A triangle and its paint, in the text form of the project.
struct PaintedTriangle {
    Triangle triangle;
    const char* digits = nullptr;
};

// Adds the painted faces to `to` as bodies of the kinds `wanted` and `unwanted`, with a note on those whose paint
// cannot be read.
void add_painted(const std::vector<PaintedTriangle>& painted, Body::Purpose wanted, Body::Purpose unwanted, File& to);

} // namespace filum::mesh
