// Bodies that say of places in a part what is to hold there.
#pragma once

#include "base/note.hpp"
#include "geom/affine.hpp"
#include "polygon/region.hpp"
#include "stream/frame.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace filum::app::modifier {

// The name and value by which `slice` tells where it put a part, a mark and no option: the map from the coordinates of
// its file, in the file's own unit, to those of the layers.
stream::Setting placement_setting(const geom::Affine& map);

// How long the unit of the part's file is, mm, told likewise; 1 where nothing is told.  Bodies in files without a unit
// are in the part's.
stream::Setting unit_setting(double mm);
double unit_in(const stream::Header& header);

// The map that is told so in a history; none if there is not exactly one, as with several parts on a bed.
std::optional<geom::Affine> placement_in(const stream::Header& header);

// A body in a part: its outlines in each layer from the first to the last, empty where it is not, and its checksum.
struct Body {
    std::vector<polygon::Loops> outlines;
    std::string crc32c;
};

// The body in file `path`, in the coordinates of the part's file: moved as that was, and cut at the same heights.
// `notes` gets what was repaired, and that it meets no region.  Throws Error(bad_input) for a file that is no mesh, and
// where nobody says how the part was moved.
Body body(const std::string& path, const stream::Header& header, const std::vector<polygon::Region>& regions,
          int threads, Notes& notes);

// Modifiers of a slicer's project, with their settings as that has them.
struct Project {
    struct Modifier {
        std::vector<polygon::Loops> outlines; // as of Body
        std::vector<std::pair<std::string, std::string>> settings;
    };
    std::vector<Modifier> bodies;
    std::string crc32c;
};

// Those of the project in file `path`, likewise.  Throws Error(bad_input), too, if it has none.
Project modifiers(const std::string& path, const stream::Header& header, const std::vector<polygon::Region>& regions,
                  int threads, Notes& notes);

// Where supports are wanted, or not.
struct Places {
    Body body;
    double painted = 0; // mm2 of faces that look down, painted so
};

// What file `path` says of that: of a slicer's project with enforcers, blockers or painted faces those that are
// `wanted` or those that are not, where each layer leans out over the one below between painted faces; of others all
// that lies within.  Throws Error(bad_input), too, for a project that says it of the other only.
Places support_places(const std::string& path, bool wanted, const stream::Header& header,
                      const std::vector<polygon::Region>& regions, int threads, Notes& notes);

} // namespace filum::app::modifier
