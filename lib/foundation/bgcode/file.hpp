// Binary G-code (.bgcode): blocks of metadata, pictures and G-code, as in libbgcode's specification.
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
    Table about, printer, print, slicer; // producer; printer; amounts of the print; settings of the slicer
    std::vector<Thumbnail> thumbnails;
    std::string gcode;
};

// True if `bytes` begin like binary G-code.
bool begins(std::string_view bytes);

// Reads a whole file. `name` is for messages. Throws Error(truncated) if it ends within a block. Throws
// Error(bad_input) if a checksum differs, a block is damaged or of an unknown kind, there is no G-code, or the content
// exceeds 512 MiB.
File read(std::string_view bytes, const std::string& name);

// The bytes of a file, with checksums.  Tables are deflated if that is shorter.  G-code is compressed by MeatPack and
// Heatshrink, in blocks of 64 KiB of text.
std::string written(const File& file);

} // namespace filum::bgcode
