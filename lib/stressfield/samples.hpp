// Stresses as a finite-element program gives them: at points, which may be the nodes of elements.
#pragma once

#include "geom/vec.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace filum::stressfield {

using geom::Vec3;

using Tensor = std::array<double, 6>;    // xx yy zz xy yz zx, MPa
using Principal = std::array<double, 3>; // s1 >= s2 >= s3, MPa; infinite where unknown

// Nodes in the order of Abaqus and VTK: corners, then the middles of edges.
enum class Shape : std::uint8_t {
    tet4,
    tet10,
    hex8,
    hex20,
    wedge6,
    wedge15,
    pyramid5,
    triangle3,
    triangle6,
    quad4,
    quad8
};

struct Element {
    Shape shape = Shape::tet4;
    std::uint32_t first = 0; // its nodes in Samples::nodes begin here
};

// Tensors, or else directions and principal stresses.
struct Case {
    std::string name;
    std::vector<Tensor> tensors;       // per point; nan where there is none
    std::vector<Vec3> directions;      // per point: of the greatest principal stress, of any length; 0: to all sides
    std::vector<Principal> principals; // per point
    std::string origin = {};           // what of the file it is, in which order and unit
};

struct Samples {
    std::vector<Vec3> points; // mm
    std::vector<Element> elements;
    std::vector<std::uint32_t> nodes; // of the elements, as indices of points
    std::vector<Case> cases;
};

// A tensor whose greatest principal stress is principal[0] along `direction` (any length; 0: to all sides); across it,
// the same stress all round: the mean of the other two if they are known, else as much below the greatest as that is
// from 0.  So averages of such tensors do not depend on the signs of the directions, and strong ones count most.
Tensor about(const Vec3& direction, const Principal& principal);

} // namespace filum::stressfield
