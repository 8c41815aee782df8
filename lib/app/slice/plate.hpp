// The parts of one run of `slice`: each read and made ready, and where it stands on the bed.
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

// One mesh, cut once however often it stands there.
struct OnBed {
    std::string name;
    mesh::Box3 box;
    mesh::Placed placement{};  // from the file's coordinates
    std::vector<Vec2> outline; // its convex hull seen from above; of several things only
    std::unique_ptr<filum::slice::Part> part;
    std::optional<Carved> carved{};   // where bodies are cut away; then `part` only has the heights of what is left
    std::vector<plate::Place> at{{}}; // where each copy stands
    filum::slice::Sweep sweep;
    std::optional<filum::slice::Measured> measured;
    std::vector<double> area;          // of each of its layers, mm2
    std::vector<polygon::Loops> bores; // of each of its layers: outlines of those that it leaves open
    Notes notes;                       // on the mesh, where it was read
};

// Reads and places every input, checks its size and makes it ready.  The settings of `self` get what the files are
// known by.
std::vector<OnBed> read_parts(const Options& options, cli::Io& self);

// Finds places for several, on the bed of options.machine, and moves them by what --center and --translate say of
// the whole.  What they are called and where they stand.  Throws Error(bad_input) if they don't fit.
std::vector<stream::Object> place_on_bed(std::vector<OnBed>& parts, const Options& options, const cli::Io& io,
                                         Notes& notes);

// Notes on a part for all of its copies, with the place of the first.
Notes as_placed(const OnBed& part, Notes notes);

// The layers of all: of one part as slice::prepare; of several those of the highest, each cut by those below its own
// top, judged; `notes` gets those of all parts.  Throws Error(bad_input) for a part lower than half a layer.
std::vector<filum::slice::Level> prepare(std::vector<OnBed>& parts, const Options& options, int threads, Notes& notes);

// The layers that are wanted of all: those between the cuts, from `first` on to before `last`; `down` is how far they
// come down, mm.  Throws Error(bad_input) if none is.
struct Wanted {
    std::size_t first = 0, last = 0;
    double down = 0;
};
Wanted wanted(std::span<const filum::slice::Level> levels, const Options& options);

} // namespace filum::app::slice
