// What surface stages hand on: a surface, and what they found out about it.
#pragma once

#include "surface/sources.hpp"

#include <span>
#include <string>

namespace filum::surface {

// A number or a vector per vertex.
struct Field {
    std::string name;             // lower case, words joined by '-': "distance"; of load cases "stress.CASE.s1"
    std::vector<double> values;   // `components` per vertex, together; infinite where nothing is known
    std::uint32_t components = 1; // 1 or 3

    [[nodiscard]] Vec3 vector(std::size_t vertex) const {
        return {values[3 * vertex], values[3 * vertex + 1], values[3 * vertex + 2]};
    }
};

// The values at these vertices, in this order.
inline Field picked(const Field& field, std::span<const std::uint32_t> vertices) {
    Field out{field.name, {}, field.components};
    out.values.reserve(vertices.size() * field.components);
    for (const std::size_t v : vertices)
        for (std::size_t k = 0; k < field.components; ++k) out.values.push_back(field.values[field.components * v + k]);
    return out;
}

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
    std::vector<Isoline> isolines;      // of the field "distance", by level
    Sources sources{};                  // from where "distance" was measured
    std::string name{};                 // of a patch: "A"; letters, digits and '._-'
    std::vector<std::uint32_t> faces{}; // per triangle, the CAD face that it lies on, from 1; none: not known
    std::string algorithm{};            // the path planned for it, in surfpath's words
};

} // namespace filum::surface
