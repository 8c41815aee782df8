// Bodies that say of places in a part what is to hold there, as outlines in its layers.
#pragma once

#include "base/note.hpp"
#include "geom/affine.hpp"
#include "polygon/region.hpp"
#include "stream/frame.hpp"

#include <optional>
#include <string>

namespace filum::app::modifier {

// The name and value by which `slice` tells where it put a part: the map from the coordinates of its file, in the
// file's own unit, to those of the layers.
stream::Setting placement_setting(const geom::Affine& map);

// The map that is told so in a history; none if there is not exactly one, as with several parts on a bed.
std::optional<geom::Affine> placement_in(const stream::Header& header);

// The outlines of the body in file `path` in each layer of a part from the first to the last, cut at the same heights;
// empty where it is not.  The body is in the coordinates of the part's file, and moved as that was.  `notes` gets what
// was repaired, and that it meets no region.  Throws Error(bad_input) for a file that is no mesh, and where nobody says
// how the part was moved.
std::vector<polygon::Loops> outlines(const std::string& path, const stream::Header& header,
                                     const std::vector<polygon::Region>& regions, int threads, Notes& notes);

} // namespace filum::app::modifier
