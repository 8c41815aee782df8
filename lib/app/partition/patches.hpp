// Several surfaces as one stream.
#pragma once

#include "cli/command.hpp"
#include "surface/sheet.hpp"

namespace filum::app::partition {

// Writes the surfaces behind the notes and facts of the streams they come from, and `notes` and `facts` as this
// program's.  Facts of the same program that came by the streams are left out: they speak of what was before.
void write(const std::vector<cli::Whole>& before, const std::vector<surface::Sheet>& sheets, Notes notes,
           const Facts& facts, const cli::Io& self);

} // namespace filum::app::partition
