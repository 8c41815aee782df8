// Sizes of the blocks that are read and written at once; private to lib/program/stream.
#pragma once

#include <cstddef>

#include <cerrno>
#include <poll.h>

namespace filum::stream {

// Call it after a read or write that failed. Returns true if it failed only because the descriptor does not block and
// the other side was not ready. In this case it waits until the other side is ready.
inline bool waited(int fd, short event) {
    if (errno != EAGAIN && errno != EWOULDBLOCK) return false;
    pollfd one{fd, event, 0};
    while (::poll(&one, 1, -1) < 0 && errno == EINTR) {
    }
    return true;
}

inline constexpr std::size_t kBlock = std::size_t{256}
                                      << 10; // bytes; stays in the cache between read() and the copy out of it
// Bytes, the most that Linux allows to every user: fewer switches between processes.
inline constexpr int kPipe = 1 << 20;

} // namespace filum::stream
