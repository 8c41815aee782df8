// The section [preset] of a machine profile.
#pragma once

#include "machine/profile.hpp"
#include "machine/reader.hpp"

namespace filum::machine {

// Reads the slicer's profile whose G-code the program gets.  Throws as Document does.
void read_preset(Document& doc, Profile& profile);

} // namespace filum::machine
