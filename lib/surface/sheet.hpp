// What surface stages hand on: a surface, and what they found out about it.
#pragma once

#include "surface/surface.hpp"

#include <string>

namespace filum::surface {

// A number per vertex.
struct Field {
    std::string name;           // lower case, words joined by '-': "distance"
    std::vector<double> values; // infinite where nothing is known
};

// A line on the surface along which a field has one value.  What is less lies to its left, seen from the side that the
// surface faces.
struct Isoline {
    double level = 0; // mm
    bool closed = false;
    std::vector<Vec3> points;             // mm; wherever it crosses an edge, and between; the first is not repeated
    std::vector<std::uint32_t> triangles; // that each stretch lies in: one fewer than points, or as many if closed
};

struct Sheet {
    Surface surface;
    std::vector<Field> fields;
    std::vector<Isoline> isolines; // of the last field, by level
};

} // namespace filum::surface
