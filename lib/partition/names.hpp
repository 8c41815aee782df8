// What patches are called.
#pragma once

#include "surface/sheet.hpp"

#include <string_view>

namespace filum::partition {

// A, B, ... Z, AA, AB, ...: the `i`-th, from 0.
std::string letters(std::size_t i);

// The words of a list with commas between; none of an empty text.  Throws Error(usage) naming `option` if one is empty,
// longer than 64, or of anything but letters, digits and '._-'.
std::vector<std::string> words(std::string_view list, std::string_view option);

// Names the patches that have none, in their order: by `names`, then by letters that no other has.
// Throws Error(usage) if two are named alike, or there are more names than patches without.
void name(std::vector<surface::Sheet>& patches, const std::vector<std::string>& names);

// Leaves only the patches of these names, in their own order; all if there are none.  Throws Error(usage), with the
// names that there are, if one is missing.
void keep_only(std::vector<surface::Sheet>& patches, const std::vector<std::string>& names);

} // namespace filum::partition
