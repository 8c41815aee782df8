// The arrays of a VTK XML file in all their encodings; private to lib/stressfield.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace filum::stressfield {

// What the file says of all its arrays.
struct Encoding {
    bool big_endian = false;
    bool wide = false;         // counts in front of data have 64 bits
    bool packed = false;       // by zlib, in blocks
    bool raw = false;          // appended data is not base64
    std::string_view appended; // data behind the mark '_'
};

struct Array {
    std::string name;
    std::string type;      // "Float32"
    std::string format;    // "ascii", "binary" or "appended"
    std::string_view text; // between its tags
    std::string offset;    // where it begins in the appended data
};

// Its numbers; `file` is for messages.  Throws Error: truncated if data ends too early, bad_input if it is malformed.
std::vector<double> values(const Array& array, const Encoding& encoding, const std::string& file);

} // namespace filum::stressfield
