// What a program comes in: text, binary G-code (.bgcode), or a project with one program a plate (.gcode.3mf).
#pragma once

#include "base/note.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace filum::ingest {

// The program as text.  Of binary G-code with its tables of settings behind it as comments, as text has them.  Of a
// project that of `plate`, from 1; 0: the first there is, and how many others there are is a note.  `name` is for
// messages.  `kept` holds text that is not part of `bytes`.  Throws Error(bad_input) if it is damaged, holds no
// program, or is no text; Error(usage) if a plate is asked for that is not there.
std::string_view program_in(std::string_view bytes, const std::string& name, std::uint32_t plate, std::string& kept,
                            Notes& notes);

} // namespace filum::ingest
