// From a scene to the bytes of a picture.
#pragma once

#include "machine/head.hpp"
#include "render/scene.hpp"

#include <string>

namespace filum::render {

struct Options {
    std::string color = "auto"; // auto | progress | stroke | layer | width | speed | class
    std::string view = "auto";  // auto | iso | top | ... | X,Y,Z: render::looks; auto: face for a surface, else iso
    std::string views = {};     // several of these, instead
    std::string machine = "marlin";
    std::string regions = {};                                       // file of outlines for a layer
    std::string surface = {};                                       // file of the surface under a toolpath
    std::string by = {}, arrows = {};                               // fields of the surface
    bool voids = false, overlap = false;                            // marked on the surface
    std::int64_t layer = -1, from_layer = 0, to_layer = UINT32_MAX; // layer -1: all, in perspective
    std::int64_t samples = 4;                                       // per pixel
    std::vector<double> size = {1024, 768};                         // pixels
    std::string collisions = {};           // file of the places where the head meets something: collisions.hpp
    std::string figures = {}, beside = {}; // files for a report: figures as TSV, another stream
    std::string title = {};                // of a report
    std::string part = {};                 // mesh files that stand there then, commas between
    machine::HeadChoice head = {};         // what meets them
    std::vector<double> around = {};       // x, y, z, radius in mm: what a surface's picture shows
    bool html = false;                     // a report is made instead of a picture
    bool svg = false, vtp = false, travels = false, no_centres = false, no_table = false;

    [[nodiscard]] bool flat() const { return layer >= 0; }
    [[nodiscard]] Range range() const; // of the layers to draw
};

// Throws Error(usage) if the options do not fit together; for a look before anything is read.
void check(const Options& options);

// A PNG file; an SVG one if `options.svg`, a VTP one if `options.vtp`.  `by_default`: what "auto" colours by.
std::string draw(Scene scene, const Options& options, const std::string& by_default, int threads);

} // namespace filum::render
