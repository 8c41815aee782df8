// Text from files, safe for a terminal, a log or a line of a program.
#pragma once

#include <string>
#include <string_view>

namespace filum {

// `text` on one line and without control codes: each of them (C0, DEL, C1, line and paragraph separators, marks that
// turn the direction of writing) and each byte that is no UTF-8 becomes \n, \t, \r or \xHH, byte by byte.
std::string printable(std::string_view text);

} // namespace filum
