// Surfaces of all kinds, at random: plates, caps, saddles, half cylinders, cones, helicoids, rolls, folds, tees, busts,
// with holes, slits, several components and rims.
#pragma once

#include "mesh/mesh.hpp"
#include "random.hpp"

#include <functional>
#include <string>

namespace filum::trials {

using geom::Vec2;
using geom::Vec3;
using mesh::Mesh;

// A part of the plane: positive inside, about the distance from its border, mm.
using Domain = std::function<double(Vec2)>;
using Lift = std::function<Vec3(Vec2)>;

// How triangles of a grid over a domain are to lie.
struct Grid {
    double u = 1, v = 1;  // mm: sides of its cells
    double jitter = 0;    // of the cells
    bool snapped = false; // cells end on whole multiples, so that lines of equal distance run through vertices
};

struct Shape {
    std::string name;
    Mesh mesh;
};

// Triangles of the grid over [0, a] x [0, b], cut off along the domain's border, put into space.
Mesh sheet(Vec2 size, const Grid& grid, const Domain& inside, const Lift& lift, Random& random);

// The level set 0 of `solid`, positive inside, within the box; mm between samples.  Faces outwards.
Mesh level_set(Vec3 lo, Vec3 hi, double step, const std::function<double(const Vec3&)>& solid);

// Takes out vertices where the surface is flat: what remains are those of its outlines.
void coarsen(Mesh& mesh);

// Any of them, between 15 and 60 mm wide; its triangles are not spoilt yet.
Shape random_shape(Random& random);

// The same surface in other triangles, or elsewhere.
void split_in_four(Mesh& mesh);
void shuffle(Mesh& mesh, Random& random); // vertices, triangles, and which corner is first
struct Motion {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, by{};
    [[nodiscard]] Vec3 way(const Vec3& v) const { return v.x * x + v.y * y + v.z * z; }
    [[nodiscard]] Vec3 point(const Vec3& p) const { return way(p) + by; }
};
Motion turned(Random& random);

// Spoils what lies in the triangles but not in the shape: their order, corners, orientation, sizes; turns the whole
// about and shifts it.  Returns what was done, in words.
std::string spoil(Mesh& mesh, Random& random);

} // namespace filum::trials
