// The bodies of a part that are printed by different tools.
//
// All bodies stand in one frame: they are placed together, as one mesh would be.  Where bodies of different tools
// overlap, the later one has the material.
#pragma once

#include "app/slice/plate.hpp"

namespace filum::app::slice {

// One item of --body: "FILE", "FILE:tool=1" or "FILE:tool=1,width=0.6,height=0.4"; without a tool it is tool 0.
struct BodyItem {
    std::string file;
    std::uint32_t tool = 0;
    double width = 0;   // mm; 0: as the stages say
    double height = 0;  // mm, of its layers; 0: as all
    bool named = false; // the tool is named; otherwise each material of a 3MF is a body with a tool of its number
};

// The items of --body, with ';' between.  Throws Error(usage) for an item that is none of these forms.
std::vector<BodyItem> body_items(const std::string& text);

// Reads the input, if there is one, as body 0 with tool 0, and the bodies of options.body after it.  Throws Error as
// the readers, and Error(usage) for several inputs, for bodies of one tool with different widths or heights, for
// heights that are no whole number of layers, and for negative bodies.
std::vector<BedPart> read_bodies(const Options& options, cli::Io& self);

// All bodies together as one thing on the bed.
BedPart joint(const std::vector<BedPart>& bodies);

// Cuts the contours of later bodies from those of earlier ones with other tools.  `tools`: per body.  Adds a note with
// the volume that this takes where they overlap by more than a `hairline` (mm).
void cut_by_later(std::vector<polygon::Loops>& contours, const std::vector<std::uint32_t>& tools, double height,
                  double hairline, std::uint32_t layer, Notes& notes);

// Adds a note for each body that later ones hide completely.  `kept`: mm2 that are left, per body and layer.
void tell_hidden(const std::vector<BedPart>& bodies, const std::vector<std::vector<double>>& kept,
                 std::span<const filum::slice::Level> levels, Notes& notes);

} // namespace filum::app::slice
