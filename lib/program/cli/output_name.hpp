// Checks that the ending of an output's name fits its format.
#pragma once

#include <string>
#include <string_view>

namespace filum::cli {

// Throws Error(usage) if the ending of `name` stands for a format that the program does not write: part.pdf, part.stl,
// ... `what` describes the output as the help of `program` does: "machine code", "a PNG picture, SVG or VTP". Names
// without an ending are accepted, and so are endings of no known format.
void check_output_name(const std::string& name, std::string_view program, const std::string& what);

} // namespace filum::cli
