// Unpacks programs: text, binary G-code (.bgcode), or a project with one program per plate (.gcode.3mf).
#pragma once

#include "base/note.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace filum::ingest {

// Returns the program as text. For binary G-code, its tables of settings follow as comments, as in text programs. For a
// project, returns the program of `plate`, counted from 1; 0 takes the first one, with a note on the number of others.
// Its lines end with LF. `name` is for messages. `kept` holds the text if it is not part of `bytes`. Throws
// Error(bad_input) if the content is damaged, holds no program, or is not text. Throws Error(usage) if `plate` does not
// exist.
std::string_view program_in(std::string_view bytes, const std::string& name, std::uint32_t plate, std::string& kept,
                            Notes& notes);

} // namespace filum::ingest
