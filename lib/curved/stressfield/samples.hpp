// Stresses of a finite-element program: at points, which may be the nodes of elements.
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

// Nodes in the order of Abaqus and VTK: corners, then midpoints of edges.
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
    std::uint32_t first = 0; // index in Samples::nodes of its first node
};

// A load case: either tensors, or directions and principal stresses.
struct Case {
    std::string name;
    std::vector<Tensor> tensors;       // per point; nan if unknown
    std::vector<Vec3> directions;      // per point: of the greatest principal stress, of any length; 0: isotropic
    std::vector<Principal> principals; // per point
    std::string origin = {};           // arrays or results of the file, order and unit
    bool unit_named = false;           // the file names the unit of the stresses
};

struct Samples {
    std::vector<Vec3> points; // mm
    std::vector<Element> elements;
    std::vector<std::uint32_t> nodes; // of the elements, as indices of points
    std::vector<Case> cases;
};

// A tensor with the greatest principal stress principal[0] along `direction` (of any length; 0: isotropic), and equal
// stresses in all directions perpendicular to it: the mean of the other two if they are known, otherwise s1 - |s1|.
// Averages of such tensors do not depend on the signs of the directions, and large stresses have the greatest weight.
Tensor about(const Vec3& direction, const Principal& principal);

} // namespace filum::stressfield
