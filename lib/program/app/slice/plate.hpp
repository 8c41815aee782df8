// Reads and prepares the parts of one run of `slice`, and places them on the bed.
#pragma once

#include "app/slice/carved.hpp"
#include "app/slice/slice.hpp"
#include "plate/plate.hpp"
#include "slice/volume.hpp"
#include "stream/frame.hpp"

#include <memory>
#include <optional>

namespace filum::app::slice {

using geom::Vec2;

// One mesh with the places of its copies.  It is cut once for all of them.
struct BedPart {
    std::string name;
    mesh::Box3 box;
    mesh::PlacementMap placement{}; // map from the file's coordinates
    std::vector<Vec2> outline;      // its convex hull seen from above; only if there are several things on the bed
    std::unique_ptr<filum::slice::Part> part;
    std::optional<CarvedPart> carved{}; // if bodies are cut away; then `part` only gives the heights of the rest
    std::vector<plate::Place> at{{}};   // the place of each copy
    filum::slice::Sweep sweep;
    std::optional<filum::slice::VolumeSamples> measured;
    std::vector<double> area;          // mm2, of each layer
    std::vector<polygon::Loops> bores; // of each layer: outlines of bores that the layer leaves open
    Notes notes;                       // on the mesh, in the coordinates before copies are placed
    // Of bodies (bodies.hpp): the tool that prints it, and the width of its beads in mm (0: as the stages say).
    // The number of layers of the job that one of its layers covers (heights.hpp).
    std::uint32_t tool = 0;
    double width = 0;
    std::uint32_t layers = 1;
};

// The name of a part on the bed: the file's name without folder and ending, of letters, digits, '-' and '_' only.
std::string label(const std::string& path);

// The scale that compensates for the shrinkage (%) of a cooling part.  Both lists hold one number or three.
std::vector<double> enlarged(const std::vector<double>& scale, const std::vector<double>& shrinkage);

// Reads and places every input, checks its size and prepares it.  The checksum of the files is added to the settings of
// `self`.  Throws Error as the readers and checks.
std::vector<BedPart> read_parts(const Options& options, cli::Io& self);

// Finds places for several parts on the bed of options.machine, and moves them all by --center and --translate. Returns
// the names and outlines of all copies; empty for a single part.  Throws Error(bad_input) if the parts do not fit.
std::vector<stream::Object> place_on_bed(std::vector<BedPart>& parts, const Options& options, const cli::Io& io,
                                         Notes& notes);

// Appends the contours of one layer of a part, once for each of its copies.
void add_copies(const polygon::Loops& loops, const std::vector<plate::Place>& at, polygon::Loops& to);

// The notes on a part, with count and amount for all copies and the place of the first copy.
Notes as_placed(const BedPart& part, Notes notes);

// Prepares the cuts of all parts and returns the levels of all layers.  One part has the levels of slice::prepare.
// Several parts share the levels of their joint mesh; each is cut at the levels below its own top.  `notes` gets the
// notes of all parts, also those on the quality of their meshes.  Throws Error(bad_input) for a part lower than half a
// layer.
std::vector<filum::slice::Level> prepare(std::vector<BedPart>& parts, const Options& options, int threads,
                                         Notes& notes);

// The range of wanted layers: from `first` to before `last`.  `down`: the distance in mm by which they are lowered.
struct LayerRange {
    std::size_t first = 0, last = 0;
    double down = 0;
};
// The layers between --cut-below and --cut-above, from --from-layer on.  Throws Error(bad_input) if there is none.
LayerRange wanted(std::span<const filum::slice::Level> levels, const Options& options);

} // namespace filum::app::slice
