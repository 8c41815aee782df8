// A frame as `peek` shows it.
#pragma once

#include "wire/record.hpp"

namespace filum::app::peek {

using wire::Record;
using wire::Table;
using wire::Word;

// All that the frame says, and of a surface what follows from it: components, area, and rims as records.
// Throws Error as wire::record.
Record record(const stream::RawFrame& frame);

} // namespace filum::app::peek
