// How much is read and written at once; private to lib/stream.
#pragma once

#include <cstddef>

namespace filum::stream {

inline constexpr std::size_t kBlock = std::size_t{256}
                                      << 10; // stays in the cache between read() and the copy out of it
inline constexpr int kPipe = 1 << 20;        // what Linux allows to everyone: fewer changes of process

} // namespace filum::stream
