// What is drawn: any planar stream as spans, the outlines of layers, a surface.
#pragma once

#include "mesh/mesh.hpp"
#include "polygon/region.hpp"
#include "render/colour.hpp"
#include "surface/sheet.hpp"
#include "toolpath/path.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace filum::render {

struct Outline {
    std::uint32_t layer = 0, stroke = 0;
    double z = 0, height = 0;
    polygon::Loops loops;
};

// A solid thing beside the beads.
struct Thing {
    mesh::Mesh mesh;
    Rgb colour;
};

struct Scene {
    std::vector<toolpath::Span> spans;
    std::vector<Outline> outlines;
    bool solid = false;                       // spans only stand for the outlines' solid: there are no beads
    std::optional<surface::Sheet> sheet = {}; // that the spans lie on, or alone
    std::vector<Thing> meshes = {};           // in perspective only

    [[nodiscard]] bool empty() const { return spans.empty() && outlines.empty() && !sheet; }
};

// A layer range, both ends included.
struct Range {
    std::uint32_t from = 0, to = UINT32_MAX;
    [[nodiscard]] bool has(std::uint32_t layer) const { return layer >= from && layer <= to; }
};

void add(Scene& scene, const toolpath::Span& span, Range range);
void add(Scene& scene, const toolpath::RegionPaths& paths, Range range); // curves as beads
void add(Scene& scene, const polygon::Layer& layer, Range range);
void add(Scene& scene, const polygon::Region& region, Range range);
void add(Scene& scene, surface::Sheet sheet); // throws Error(bad_input) if there is one already

// Stands for the solid of the outlines: their borders, and lines a layer height apart that fill them, as beads as wide
// as high.  For pictures in perspective of what has no beads yet.
void fill_outlines(Scene& scene);

} // namespace filum::render
