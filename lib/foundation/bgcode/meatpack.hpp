// MeatPack: G-code with its fifteen most common characters in four bits each. The bytes 255 255 and a third one are a
// command.
#pragma once

#include <string>
#include <string_view>

namespace filum::bgcode {

// Unpacks text.  Empty lines are dropped.  Blanks in lines of G codes stay out if the packer removed them.
std::string unpacked(std::string_view data);

// Packs text. Comment lines stay unchanged. Other lines lose comments after their code and blanks at their ends; G
// codes lose all blanks. Empty lines are dropped.
std::string packed(std::string_view text);

} // namespace filum::bgcode
