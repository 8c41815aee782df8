// What the ending of an output's name promises.
#pragma once

#include <string>
#include <string_view>

namespace filum::cli {

// Throws Error(usage) for a name whose ending stands for a format that is not written: part.pdf,
// part.stl, ...  `program` writes `what`, as its help says it: "machine code", "a PNG picture, SVG or VTP".
// Names without an ending, and endings that stand for no other format, are free.
void check_output_name(const std::string& name, std::string_view program, const std::string& what);

} // namespace filum::cli
