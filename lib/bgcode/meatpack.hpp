// MeatPack: G-code with its fifteen commonest characters in four bits each.  Bytes 255 255 and a third are commands.
#pragma once

#include <string>
#include <string_view>

namespace filum::bgcode {

// Text as it was, without empty lines, and without blanks in lines of G codes if the packer left them out.
std::string unpacked(std::string_view data);

// Lines that are comments stay as they are; other lines lose comments behind their code, and G codes their blanks.
// Empty lines are left out.
std::string packed(std::string_view text);

} // namespace filum::bgcode
