// Binary G-code (.bgcode): blocks of metadata, pictures and G-code, as libbgcode's specification has them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace filum::bgcode {

using Table = std::vector<std::pair<std::string, std::string>>; // keys and values, in the order of the file

enum class Picture : std::uint8_t { png, jpg, qoi };

struct Thumbnail {
    Picture format = Picture::png;
    std::uint16_t width = 0, height = 0; // pixels
    std::string bytes;
};

struct File {
    Table about, printer, print, slicer; // who made it; for which printer; what the print takes; the slicer's settings
    std::vector<Thumbnail> thumbnails;
    std::string gcode;
};

// True for bytes that begin as such a file does.
bool begins(std::string_view bytes);

// Reads a whole file.  `name` is for messages.  Throws Error(truncated) if it ends within a block, Error(bad_input) if
// a checksum differs, a block is of an unknown kind or damaged, there is no G-code, or it comes to more than 512 MiB.
File read(std::string_view bytes, const std::string& name);

// With checksums; tables deflated where that is shorter, G-code packed and shrunk in blocks of 64 KiB.
std::string written(const File& file);

} // namespace filum::bgcode
