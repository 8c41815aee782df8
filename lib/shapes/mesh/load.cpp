#include "base/error.hpp"
#include "mesh/read.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace filum::mesh {

namespace {

constexpr std::size_t kMaxFile = std::size_t{1} << 32;
constexpr std::size_t kFirst = std::size_t{1} << 20;

struct Descriptor {
    int fd;
    bool owned;
    Descriptor(int f, bool o) : fd(f), owned(o) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (owned && fd >= 0) ::close(fd);
    }
};

void enlarge(Bytes& bytes, std::size_t capacity) {
    auto bigger = std::make_unique_for_overwrite<char[]>(capacity);
    if (bytes.size > 0) std::memcpy(bigger.get(), bytes.data.get(), bytes.size);
    bytes.data = std::move(bigger);
}

} // namespace

std::string spoken_name(const std::string& path) {
    return path.empty() || path == "-" ? "standard input" : "'" + path + "'";
}

Bytes load(const std::string& path) {
    const bool standard = path.empty() || path == "-";
    const std::string name = spoken_name(path);
    const Descriptor in(standard ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC), !standard);
    if (in.fd < 0) throw Error(Exit::io, "cannot open " + name + ": " + std::strerror(errno));
    struct stat info {};
    std::size_t capacity = kFirst;
    if (::fstat(in.fd, &info) == 0 && S_ISREG(info.st_mode) && info.st_size > 0)
        capacity = std::min(kMaxFile, static_cast<std::size_t>(info.st_size)) + 1; // one more, to meet the end at once
    Bytes out;
    enlarge(out, capacity);
    for (;;) {
        if (out.size == capacity) enlarge(out, capacity = std::min(2 * capacity, kMaxFile + 1));
        const ssize_t n = ::read(in.fd, out.data.get() + out.size, capacity - out.size);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) throw Error(Exit::io, "cannot read " + name + ": " + std::strerror(errno));
        if (n == 0) return out;
        out.size += static_cast<std::size_t>(n);
        if (out.size > kMaxFile) throw Error(Exit::bad_input, "cannot read " + name + ": it is larger than 4 GiB");
    }
}

} // namespace filum::mesh
