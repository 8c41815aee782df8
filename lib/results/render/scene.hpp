// The content of a picture: any planar stream as spans, the outlines of layers, a surface, meshes.
#pragma once

#include "mesh/mesh.hpp"
#include "polygon/region.hpp"
#include "render/colour.hpp"
#include "surface/sheet.hpp"
#include "toolpath/path.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace filum::render {

struct Outline {
    std::uint32_t layer = 0, stroke = 0;
    double z = 0, height = 0;
    polygon::Loops loops;
    std::uint32_t tool = 0;
};

// A solid object besides the beads.
struct Thing {
    mesh::Mesh mesh;
    Rgb colour;
};

struct Scene {
    std::vector<toolpath::Span> spans;
    std::vector<Outline> outlines;
    bool solid = false; // spans only fill the outlines, and there are no real beads
    // the surface that the spans lie on, or a surface alone; several surfaces are merged
    std::optional<surface::Sheet> sheet = {};
    std::vector<std::string> patches = {}; // the names of the surfaces, in the order of adding
    std::vector<std::uint32_t> patch = {}; // per triangle: index of its surface in `patches`
    std::vector<Thing> meshes = {};        // drawn in perspective only

    [[nodiscard]] bool empty() const { return spans.empty() && outlines.empty() && !sheet; }
};

// A range of layers, both ends included.
struct Range {
    std::uint32_t from = 0, to = UINT32_MAX;
    [[nodiscard]] bool has(std::uint32_t layer) const { return layer >= from && layer <= to; }
};

void add(Scene& scene, const toolpath::Span& span, Range range);
void add(Scene& scene, const toolpath::RegionPaths& paths, Range range); // adds the curves as beads
void add(Scene& scene, const polygon::Layer& layer, Range range);
void add(Scene& scene, const polygon::Region& region, Range range);

// Adds a surface beside earlier ones. A field that one surface lacks is unknown there. Throws Error(bad_input) if two
// surfaces have fields of one name with different numbers of components.
void add(Scene& scene, surface::Sheet sheet);

// Adds beads that stand for the solid inside the outlines: their borders, and lines one layer height apart. The beads
// are as wide as high. For perspective pictures of streams without beads.
void fill_outlines(Scene& scene);

} // namespace filum::render
