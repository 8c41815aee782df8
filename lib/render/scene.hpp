// What is drawn: any planar stream as spans, the outlines of layers, a surface.
#pragma once

#include "polygon/region.hpp"
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
};

struct Scene {
    std::vector<toolpath::Span> spans;
    std::vector<Outline> outlines;
    bool solid = false;                       // spans only stand for the outlines' solid: there are no beads
    std::optional<surface::Sheet> sheet = {}; // that the spans lie on, or alone; of several surfaces all triangles
    std::vector<std::string> patches = {};    // the names of several surfaces, else none
    std::vector<std::uint32_t> patch = {};    // per triangle: which of them

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

// Another surface beside those before.  Fields that one of them has not are unknown there.  Throws Error(bad_input) if
// they have a field of different kinds.
void add(Scene& scene, surface::Sheet sheet);

// Stands for the solid of the outlines: their borders, and lines a layer height apart that fill them, as beads as wide
// as high.  For pictures in perspective of what has no beads yet.
void fill_outlines(Scene& scene);

} // namespace filum::render
