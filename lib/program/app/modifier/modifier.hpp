// Bodies that change settings, or ask for supports, in a place of a part.
#pragma once

#include "base/note.hpp"
#include "geom/affine.hpp"
#include "geom/segment_grid.hpp"
#include "mesh/mesh.hpp"
#include "polygon/region.hpp"
#include "stream/frame.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace filum::app::modifier {

// The setting by which `slice` records in the history where it placed a part.  It is a mark, not an option.  Its value
// is the map from the coordinates of the file, in the file's own unit, to those of the layers.
stream::Setting placement_setting(const geom::Affine& map);

// The setting by which `slice` records the unit of the part's file, mm; and the unit that a history records, else 1.
// Bodies in files without a unit have the unit of the part.
stream::Setting unit_setting(double mm);
double unit_in(const stream::Header& header);

// The map of the part in a history; none if the history does not record exactly one, as with several parts on a bed.
std::optional<geom::Affine> placement_in(const stream::Header& header);

// A body in a part: its outlines in each layer, indexed by layer number and empty where the body is absent, and its
// checksum.
struct Body {
    std::vector<polygon::Loops> outlines;
    std::string crc32c;
};

// The body in the file `path`, which has the coordinates of the part's file.  The body is moved as the part was, and
// cut at the same heights.  `notes` gets a note on each repair, and one if the body meets no region.  Throws
// Error(bad_input) for a file that is no mesh, and if `header` does not record how the part was moved.
Body body(const std::string& path, const stream::Header& header, const std::vector<polygon::Region>& regions,
          int threads, Notes& notes);

// Whether the file with this checksum is the one of the part. Then notes that bodies of it are ignored no longer hold.
bool is_part(const std::string& crc32c, const stream::Header& header);

// The modifiers of a slicer's project, with their settings as in the project. Printed parts with settings of their own
// come first.
struct Project {
    struct Modifier {
        std::vector<polygon::Loops> outlines; // as in Body
        std::vector<std::pair<std::string, std::string>> settings;
    };
    std::vector<Modifier> bodies;
    std::string crc32c;
};

// The modifiers of the project in the file `path`, moved and cut as by body().  Throws Error(bad_input) as body(), and
// if the project has no modifiers.
Project modifiers(const std::string& path, const stream::Header& header, const std::vector<polygon::Region>& regions,
                  int threads, Notes& notes);

// The faces of a project that are painted for seams, and against them, moved as the part was.
struct SeamFaces {
    mesh::Mesh wanted, unwanted;
};

// The faces painted for seams in the project in the file `path`.  Throws Error(bad_input) as body(), and if nothing is
// painted for seams.
SeamFaces seam_faces(const std::string& path, const stream::Header& header, Notes& notes);

// The lines along which the horizontal plane at `z` cuts faces.
std::vector<geom::Segment> lines_at(const mesh::Mesh& faces, double z);

// The places where supports are wanted, or not wanted.
struct Places {
    Body body;
    double painted = 0; // mm2, area of painted faces that face down
};

// The places for supports (`wanted`), or without supports, from the file `path`.  In a slicer's project with enforcers,
// blockers or painted faces, `wanted` means enforcers and faces painted for supports.  Otherwise the places are
// blockers and faces painted against supports.  A painted face counts where a layer overhangs the one below.  In any
// other file the place is the inside of the mesh. Throws Error(bad_input) as body(), and for a project that has only
// places of the other kind.
Places support_places(const std::string& path, bool wanted, const stream::Header& header,
                      const std::vector<polygon::Region>& regions, int threads, Notes& notes);

} // namespace filum::app::modifier
