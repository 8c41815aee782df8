// The build items of a 3MF: on which plate of a slicer's project they are, and how they stand on the bed; private to
// lib/mesh.
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
    // `plate` counts from 1.  A project without plates is one plate.
    Plates(const std::vector<Plate>& plates, int plate);

    // Whether the next item of the build, of this object, is on the plate.
    bool wanted(const std::string& object);
    // After all items: why the plate cannot be printed; "" if it can.
    [[nodiscard]] std::string fault() const;
    // Notes the other plates, and the items that are on none.
    void tell(Notes& notes) const;

  private:
    const std::vector<Plate>& plates_;
    std::size_t plate_; // from 0
    std::map<std::string, int> instances_;
    std::vector<std::size_t> items_; // of each plate
    std::size_t nowhere_ = 0;        // items that are on no plate
};

// How far each item goes down (mm; below zero: up) so that each group of items stands on the bed that now would hang in
// the air or reach below it.  Items whose boxes overlap, seen from above, stand or fall together: they may be an
// assembly.  All zero for a single group, which is placed later, as a whole.
// Items without triangles have empty boxes.
std::vector<double> heights_to_lose(std::span<const geom::Box3> boxes, Notes& notes);

// Adds a negative body for what of the item in `box` is below the bed, z = 0, as slicers leave that out.
void cut_below_bed(const geom::Box3& box, std::uint32_t item, File& to);

// Some triangles of a mesh as a mesh of their own.
Mesh part_of(const Mesh& mesh, std::span<const Triangle> triangles);

} // namespace filum::mesh
