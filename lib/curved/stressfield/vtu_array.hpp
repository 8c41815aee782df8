// Arrays of a VTK XML file in all encodings; private to lib/curved/stressfield.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace filum::stressfield {

// Properties common to all arrays of a file.
struct Encoding {
    bool big_endian = false;
    bool wide = false;         // counts before data have 64 bits
    bool packed = false;       // compressed by zlib, in blocks
    bool raw = false;          // appended data is not base64
    std::string_view appended; // data after the mark '_'
};

struct Array {
    std::string name;
    std::string type;      // "Float32"
    std::string format;    // "ascii", "binary" or "appended"
    std::string_view text; // between its tags
    std::string offset;    // its position in the appended data
};

// The numbers of an array; `file` is for messages. Throws Error: truncated if data ends too early, bad_input if it is
// malformed.
std::vector<double> values(const Array& array, const Encoding& encoding, const std::string& file);

} // namespace filum::stressfield
