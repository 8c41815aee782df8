// Draws a scene as the bytes of a picture file.
#pragma once

#include "machine/head.hpp"
#include "render/scene.hpp"

#include <string>

namespace filum::render {

struct Options {
    std::string color = "auto"; // auto | progress | stroke | tool | layer | width | speed | class
    std::string view = "auto";  // auto | iso | top | ... | X,Y,Z: render::looks; auto: face for a surface, else iso
    std::string views = {};     // several of these instead of one
    std::string machine = "marlin";
    std::string regions = {};                                       // file with the outlines of a layer
    std::string surface = {};                                       // file with the surface under a toolpath
    std::string by = {}, arrows = {};                               // fields of the surface to draw
    bool voids = false, overlap = false;                            // what to mark on the surface
    std::int64_t layer = -1, from_layer = 0, to_layer = UINT32_MAX; // layer -1: all, in perspective
    std::int64_t samples = 4;                                       // samples per pixel
    std::vector<double> size = {1024, 768};                         // width and height in pixels
    std::string collisions = {};           // file with the places of collisions: see collisions.hpp
    std::string figures = {}, beside = {}; // files for a report: figures as TSV, another stream
    std::string title = {};                // title of a report
    std::string part = {};                 // mesh files to draw with collisions, separated by commas
    machine::HeadChoice head = {};         // the head of the collisions
    std::vector<double> around = {};       // x, y, z, radius in mm: the ball that fills the picture
    bool html = false;                     // makes a report instead of a picture
    std::string format = "auto";           // auto | png | svg | pdf; auto: png
    bool vtp = false, travels = false, no_centres = false, no_table = false;

    [[nodiscard]] bool flat() const { return layer >= 0; }
    [[nodiscard]] Range range() const; // the layers to draw
};

// Throws Error(usage) if the options contradict each other. Call it before anything is read.
void check(const Options& options);

// The bytes of a file in `options.format`, or of a VTP file if `options.vtp`. `by_default` says how "auto" colours.
std::string draw(Scene scene, const Options& options, const std::string& by_default, int threads);

} // namespace filum::render
