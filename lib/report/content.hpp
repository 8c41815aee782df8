// What a report shows of one stream: its geometry as columns, and what is said of it.
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

// Points in the order of the path, um; a segment leads from each to the next, but for the last of a span.
struct Points {
    Column x, y, z;
    Column width, height; // um; 0 where nothing is laid
    Column speed;         // um/s, of the segment that begins there
    Column nx, ny, nz;    // of a path that leans the tool, thousandths; else none
};

struct Spans {
    Column start; // of points
    Column role, feature, stroke, layer, tool, retraction;
};

// Closed outlines, of layers or regions.
struct Outlines {
    Column x, y; // um
    Column start, layer, z, stroke;
};

struct Field {
    std::string name;
    double low = 0, high = 0; // of `value` 0 and 65535
    Column value;             // per vertex; -1 where nothing is known
};

struct Surface {
    Column x, y, z, corner;
    std::vector<Field> fields;
};

// A place that a reader may fly to.
struct Spot {
    std::string kind, what;
    double x = 0, y = 0, z = 0;
    std::int64_t layer = -1;
};

struct Made {
    std::string program;
    std::vector<std::array<std::string, 3>> settings; // name, value, "changed" or ""
};

struct Content {
    std::string name, payload; // of the file, without folders; of the stream
    Points points;
    Spans spans;
    Outlines outlines;
    std::vector<Surface> surfaces;
    std::vector<Spot> spots;
    std::vector<Made> made;
    std::string script;                              // shell, that makes it
    std::vector<std::array<std::string, 4>> figures; // group, name, value, unit
    std::string machine;                             // what to say of it
};

// Adds to the content.  Of `profile`, if any, speeds are taken.
void add(Content& to, const toolpath::Span& span, const machine::Profile* profile);
void add(Content& to, const toolpath::RegionPaths& paths, const machine::Profile* profile);
void add(Content& to, const polygon::Region& region);
void add(Content& to, const polygon::Layer& layer);
void add(Content& to, const surface::Sheet& sheet);

// Notes that say where they are become places.  Layers tell their heights where a note has none: so come last.
void add(Content& to, const Notes& notes);

} // namespace filum::report
