// Small pictures at the head of a program, as PrusaSlicer writes them.
#pragma once

#include "stream/spool.hpp"

#include <string>
#include <vector>

namespace filum::app::postproc {

struct PictureSize {
    int width = 0, height = 0; // pixels
};

// Parses a list such as "220x124,16x16".  Throws Error(usage) for other text, and for sides below 8 or above 2000
// pixels.
std::vector<PictureSize> thumbnail_sizes(const std::string& text);

// PNG pictures of the remaining spans of `spool`, one for each size.
std::vector<std::string> thumbnails(stream::Spool& spool, const std::vector<PictureSize>& sizes, int threads);

// Comment lines with the pictures: "thumbnail begin 16x16 LENGTH", base64 in lines of 78 letters, "thumbnail end".
std::vector<std::string> thumbnail_lines(const std::vector<PictureSize>& sizes,
                                         const std::vector<std::string>& pictures);

} // namespace filum::app::postproc
