// The content of a report on one stream: its geometry as columns, its figures, and the places of its notes.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "machine/profile.hpp"
#include "polygon/region.hpp"
#include "surface/sheet.hpp"
#include "toolpath/path.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace filum::report {

using Column = std::vector<std::int32_t>;

// Points in the order of the path, um. A segment leads from each point to the next, except after the last of a span.
struct Points {
    Column x, y, z;
    Column width, height; // um; 0 where nothing is extruded
    Column speed;         // um/s, of the segment that begins at the point
    Column nx, ny, nz;    // tool axis in thousandths, for a path that leans the tool; else empty
};

struct Spans {
    Column start; // index of the first point
    Column role, feature, stroke, layer, tool, retraction;
};

// Closed outlines of layers or regions.
struct Outlines {
    Column x, y; // um
    Column start, layer, z, stroke;
};

struct Field {
    std::string name;
    double low = 0, high = 0; // the amounts that `value` 0 and 65535 stand for
    Column value;             // per vertex, 0 to 65535; -1 where unknown
};

struct Surface {
    Column x, y, z, corner;
    std::vector<Field> fields;
};

// A place that the reader can go to, mm.
struct Spot {
    std::string kind, what;
    double x = 0, y = 0, z = 0;
    std::int64_t layer = -1;
};

struct StageRecord {
    std::string program;
    std::vector<std::array<std::string, 3>> settings; // name, value, "changed" or ""
};

struct Content {
    std::string name, payload; // name of the file without folders, and payload of the stream
    Points points;
    Spans spans;
    Outlines outlines;
    std::vector<Surface> surfaces;
    std::vector<Spot> spots;
    std::vector<StageRecord> made;
    std::string script;                              // shell script that makes the stream
    std::vector<std::array<std::string, 4>> figures; // group, name, value, unit
    std::string machine;                             // description of the machine
};

// Adds data to the content. Speeds are taken from `profile`, if given.
void add(Content& to, const toolpath::Span& span, const machine::Profile* profile);
void add(Content& to, const toolpath::RegionPaths& paths, const machine::Profile* profile);
void add(Content& to, const polygon::Region& region);
void add(Content& to, const polygon::Layer& layer);
void add(Content& to, const surface::Sheet& sheet);

// Adds the notes that have a place as spots. A missing height is taken from the layer, so call it after all layers were
// added.
void add(Content& to, const Notes& notes);

} // namespace filum::report
