// Names of patches.
#pragma once

#include "surface/sheet.hpp"

#include <string_view>

namespace filum::partition {

// The `i`-th of A, B, ... Z, AA, AB, ..., from 0.
std::string letters(std::size_t i);

// The words of a list separated by commas; none for an empty text. Throws Error(usage), naming `option`, if a word is
// empty, longer than 64 characters, or contains anything except letters, digits and '._-'.
std::vector<std::string> words(std::string_view list, std::string_view option);

// Names the patches without a name, in their order: by `names`, then by letters that no other patch has.
// Throws Error(usage) if two have the same name, or if there are more names than patches without one.
void name(std::vector<surface::Sheet>& patches, const std::vector<std::string>& names);

// Keeps only the patches with these names, in their own order; all if there are none. Throws Error(usage), listing the
// names, if one is missing.
void keep_only(std::vector<surface::Sheet>& patches, const std::vector<std::string>& names);

} // namespace filum::partition
