// The section [preset] of a machine profile.
#pragma once

#include "machine/profile.hpp"
#include "machine/reader.hpp"

namespace filum::machine {

// A slicer's profile, whose G-code the program is to have.  Throws as Document.
void read_preset(Document& doc, Profile& profile);

} // namespace filum::machine
