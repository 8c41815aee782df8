// Small pictures at the head of a program, as PrusaSlicer writes them.
#pragma once

#include "stream/spool.hpp"

#include <string>
#include <vector>

namespace filum::app::postproc {

struct PictureSize {
    int width = 0, height = 0; // pixels
};

// "220x124,16x16".  Throws Error(usage) for anything else, and for sides below 8 or above 2000.
std::vector<PictureSize> thumbnail_sizes(const std::string& text);

// PNG pictures of the spans that `spool` still has.
std::vector<std::string> thumbnails(stream::Spool& spool, const std::vector<PictureSize>& sizes, int threads);

// Comment lines that hold them: "thumbnail begin 16x16 LENGTH", base64 in lines of 78 letters, "thumbnail end".
std::vector<std::string> thumbnail_lines(const std::vector<PictureSize>& sizes,
                                         const std::vector<std::string>& pictures);

} // namespace filum::app::postproc
