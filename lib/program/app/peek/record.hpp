// The content of a frame, as `peek` prints it.
#pragma once

#include "wire/record.hpp"

namespace filum::app::peek {

using wire::Record;
using wire::Table;
using wire::Word;

// The content of the frame.  For a surface the record also has derived values: components, area, and rims as nested
// records.  Throws Error as wire::record.
Record record(const stream::RawFrame& frame);

} // namespace filum::app::peek
