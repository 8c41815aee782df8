// The build items of a 3MF: which plate of a slicer's project they are on, and how they stand on the bed. Private to
// lib/shapes/mesh.
#pragma once

#include "geom/vec.hpp"
#include "mesh/project.hpp"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace filum::mesh {

// Chooses the items of one plate of a project.
class Plates {
  public:
    // `plate` is the number of a plate. A project that lists no plates has one, 1.
    Plates(const std::vector<Plate>& plates, int plate);

    // True if the next build item, an instance of `object`, is on the plate.  Call it once per item, in file order.
    bool wanted(const std::string& object);
    // Call it after all items.  Returns why the plate cannot be printed, or "" if it can.
    [[nodiscard]] std::string fault() const;
    // Adds notes on the other plates, and on items that are on no plate.
    void tell(Notes& notes) const;

  private:
    const std::vector<Plate>& plates_;
    int plate_;
    std::map<std::string, int> instances_;
    std::map<int, std::size_t> items_; // how many are on each plate, by its number
    std::size_t nowhere_ = 0;          // items that are on no plate
};

// How far each item must go down (mm; negative: up) so that each group of items stands on the bed. Items whose boxes
// overlap, seen from above, form a group and move together, as they may be an assembly. All values are 0 if every group
// has the same lowest z: then the whole is placed later. Items without triangles have empty boxes.
std::vector<double> heights_to_lose(std::span<const geom::Box3> boxes, Notes& notes);

// If the item in `box` reaches below the bed (z = 0), adds a negative body that cuts that part away, as slicers do.
void cut_below_bed(const geom::Box3& box, std::uint32_t item, File& to);

// Turns closed parts that face inwards outwards, as slicers do when they read a project: each of its parts is a solid
// by itself. `part` tells the parts of the triangles from number `from` on apart.
void face_outwards(Mesh& mesh, std::size_t from, std::span<const std::size_t> part, Notes& notes);

// Adds notes on the bodies that change settings, and on those for supports.
void tell_bodies(File& to);

// Copies some triangles of a mesh, and the vertices that they use, into a new mesh.
Mesh part_of(const Mesh& mesh, std::span<const Triangle> triangles);

} // namespace filum::mesh
