// What surface stages pass on: a surface with its fields, isolines and sources.
#pragma once

#include "surface/sources.hpp"

#include <span>
#include <string>

namespace filum::surface {

// A number or a vector per vertex.
struct Field {
    std::string name;             // lower case, words joined by '-', as "distance"; "stress.CASE.s1" for load cases
    std::vector<double> values;   // `components` consecutive numbers per vertex; infinite where unknown
    std::uint32_t components = 1; // 1 or 3

    [[nodiscard]] Vec3 vector(std::size_t vertex) const {
        return {values[3 * vertex], values[3 * vertex + 1], values[3 * vertex + 2]};
    }
};

// The values at the given vertices, in their order.
inline Field picked(const Field& field, std::span<const std::uint32_t> vertices) {
    Field out{field.name, {}, field.components};
    out.values.reserve(vertices.size() * field.components);
    for (const std::size_t v : vertices)
        for (std::size_t k = 0; k < field.components; ++k) out.values.push_back(field.values[field.components * v + k]);
    return out;
}

// A line of constant value of a field. Smaller values are on its left, seen from the side that the surface faces.
struct Isoline {
    double level = 0; // mm
    bool closed = false;
    std::vector<Vec3> points;             // mm; at crossings with edges, and in between; the first is not repeated
    std::vector<std::uint32_t> triangles; // of each segment: one fewer than points, or as many if closed
};

struct Sheet {
    Surface surface;
    std::vector<Field> fields;
    std::vector<Isoline> isolines;      // of the field "distance", by level
    Sources sources{};                  // from which "distance" was measured
    std::string name{};                 // of a patch, as "A"; letters, digits and '._-'
    std::vector<std::uint32_t> faces{}; // per triangle its CAD face, from 1; empty: unknown
    std::string algorithm{};            // algorithm of its path, by its name in surfpath
};

} // namespace filum::surface
