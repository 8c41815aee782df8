// Bodies that say of places in a part what is to hold there.
#pragma once

#include "base/note.hpp"
#include "geom/affine.hpp"
#include "polygon/region.hpp"
#include "stream/frame.hpp"

#include <optional>
#include <string>

namespace filum::app::modifier {

// The name and value by which `slice` tells where it put a part, a mark and no option: the map from the coordinates of
// its file, in the file's own unit, to those of the layers.
stream::Setting placement_setting(const geom::Affine& map);

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

} // namespace filum::app::modifier
