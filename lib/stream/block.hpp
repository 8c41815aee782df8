// How much is read and written at once; private to lib/stream.
#pragma once

#include <cstddef>

#include <cerrno>
#include <poll.h>

namespace filum::stream {

// After a read or a write that failed: whether it failed only since the other side of a descriptor that does not block
// was not ready; then waits until it is.
inline bool waited(int fd, short event) {
    if (errno != EAGAIN && errno != EWOULDBLOCK) return false;
    pollfd one{fd, event, 0};
    while (::poll(&one, 1, -1) < 0 && errno == EINTR) {
    }
    return true;
}

inline constexpr std::size_t kBlock = std::size_t{256}
                                      << 10; // stays in the cache between read() and the copy out of it
inline constexpr int kPipe = 1 << 20;        // what Linux allows to everyone: fewer changes of process

} // namespace filum::stream
