#include "stream/input.hpp"

#include "base/error.hpp"
#include "stream/block.hpp"
#include "stream/crc32c.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

namespace filum::stream {

Input::Input(const std::string& path) : block_(std::make_unique_for_overwrite<char[]>(kBlock)) {
    if (path.empty() || path == "-") {
        name_ = "standard input";
        fd_ = STDIN_FILENO;
        if (::isatty(fd_) != 0)
            throw Error(Exit::usage, "cannot read a stream from a terminal; pipe one in or name a file");
        ::fcntl(fd_, F_SETPIPE_SZ, kPipe); // has no effect if it is not a pipe
        return;
    }
    name_ = "'" + path + "'";
    fd_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (fd_ < 0) throw Error(Exit::io, "cannot open " + name_ + ": " + std::strerror(errno));
}

Input::Input(std::string_view bytes, std::string name)
    : name_(std::move(name)), rest_(bytes), block_(std::make_unique_for_overwrite<char[]>(kBlock)) {}

Input::~Input() {
    if (fd_ > STDIN_FILENO) ::close(fd_);
}

// Reads the available bytes, at least one, into block_[from..]. Returns their number, 0 at the end of the input.
std::size_t Input::refill(std::size_t from) {
    if (fd_ < 0) {
        const std::size_t n = rest_.copy(block_.get() + from, kBlock - from);
        rest_.remove_prefix(n);
        filled_ = from + n;
        return n;
    }
    for (;;) {
        const ssize_t n = ::read(fd_, block_.get() + from, kBlock - from);
        if (n >= 0) {
            filled_ = from + static_cast<std::size_t>(n);
            return static_cast<std::size_t>(n);
        }
        if (errno != EINTR && !waited(fd_, POLLIN))
            throw Error(Exit::io, "cannot read " + name_ + ": " + std::strerror(errno));
    }
}

std::string_view Input::ahead(std::size_t size) {
    if (filled_ - at_ < size) {
        std::memmove(block_.get(), block_.get() + at_, filled_ - at_);
        filled_ -= std::exchange(at_, 0);
        while (filled_ < size && refill(filled_) > 0) {
        }
    }
    return {block_.get() + at_, std::min(size, filled_ - at_)};
}

void Input::drop(std::size_t size) {
    at_ += size;
    offset_ += size;
}

bool Input::append(std::string& to, std::size_t size, std::uint32_t& crc) {
    to.reserve(to.size() + size); // reserves address space; memory is used only when bytes arrive
    while (size > 0) {
        if (at_ == filled_) {
            at_ = 0;
            if (refill(0) == 0) return false;
        }
        const std::size_t n = std::min(size, filled_ - at_);
        crc = crc32c(crc, block_.get() + at_, n); // while the bytes are in the cache
        to.append(block_.get() + at_, n);
        drop(n);
        size -= n;
    }
    return true;
}

} // namespace filum::stream
