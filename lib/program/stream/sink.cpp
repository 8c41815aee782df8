#include "stream/sink.hpp"

#include "base/error.hpp"
#include "stream/block.hpp"
#include "stream/unfinished.hpp"

#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>
#include <utility>

namespace filum::stream {

namespace {

[[noreturn]] void fail(const std::string& what, const std::string& name, int cause) {
    throw Error(Exit::io, "cannot " + what + " " + name + ": " + std::strerror(cause));
}

std::string folder_of(const std::string& path) {
    const auto slash = path.rfind('/');
    if (slash == std::string::npos) return ".";
    return slash == 0 ? "/" : path.substr(0, slash);
}

// The path with symbolic links at its end resolved, whether or not the target exists. The target is written, and the
// link stays.
std::string without_links(std::string path) {
    constexpr int kMost = 40; // the number of links that the kernel follows; longer chains fail when the file is opened
    char target[PATH_MAX];
    for (int i = 0; i < kMost; ++i) {
        const ssize_t n = ::readlink(path.c_str(), target, sizeof target);
        if (n <= 0 || n == sizeof target) break;
        const std::string next(target, static_cast<std::size_t>(n));
        path = next.front() == '/' ? next : folder_of(path) + "/" + next;
    }
    return path;
}

// The file descriptor that a name such as /dev/stdout or /dev/fd/3 stands for; -1 for other names.
int open_file_named(const std::string& path) {
    if (path == "/dev/stdout") return STDOUT_FILENO;
    if (path == "/dev/stderr") return STDERR_FILENO;
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
        if (!path.starts_with(folder)) continue;
        const std::string number = path.substr(folder.size());
        const bool whole =
            !number.empty() && number.size() < 7 && number.find_first_not_of("0123456789") == std::string::npos;
        if (whole) return std::atoi(number.c_str());
    }
    return -1;
}

} // namespace

struct Sink::State {
    std::string name;      // for messages
    std::string path;      // final name; "" if nothing is to be renamed
    std::string temporary; // name until commit(); "" while the file has none
    int fd = -1;
    bool owned = false;                         // whether this object closes fd
    std::unique_ptr<UnfinishedPath> unfinished; // removes the temporary file on a signal
    std::string buffer;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (owned && fd >= 0) ::close(fd);
        if (!temporary.empty()) ::unlink(temporary.c_str());
    }

    void open(const std::string& wanted) {
        struct stat info {};
        owned = true;
        if (const int open = open_file_named(wanted); open >= 0) { // it is open already, with flags of its own
            fd = ::fcntl(open, F_DUPFD_CLOEXEC, 0);
            if (fd < 0) fail("create", name, errno);
            return;
        }
        const bool exists = ::stat(wanted.c_str(), &info) == 0;
        if (!exists && errno == ELOOP) fail("create", name, errno); // links that form a loop
        if (exists && !S_ISREG(info.st_mode)) {
            fd = ::open(wanted.c_str(), O_WRONLY | O_CLOEXEC);
            if (fd < 0) fail("create", name, errno);
            return;
        }
        path = without_links(wanted);
        begin();
        // a replaced file keeps its permissions, so a private file stays private
        if (exists && ::fchmod(fd, info.st_mode & 0777) != 0) fail("create", name, errno);
    }

    // Creates a new file in the folder of `path`, without a name if the file system supports it.
    void begin() {
        fd = ::open(folder_of(path).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
        if (fd >= 0) return;
        name_anew([&](const char* wanted) {
            fd = ::open(wanted, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            return fd >= 0;
        });
    }

    // Finds an unused name in the folder of the final name. `make` creates the file of that name, or returns false and
    // sets errno. The name is short, because the final name may be as long as the file system allows.
    template <class Make>
    void name_anew(const Make& make) {
        constexpr int kTries = 1000; // files left by earlier processes with the same number
        for (int n = 0; n < kTries; ++n) {
            const std::string wanted =
                folder_of(path) + "/filum-" + std::to_string(::getpid()) + "-" + std::to_string(n) + ".part";
            auto watched = std::make_unique<UnfinishedPath>(wanted);
            if (make(wanted.c_str())) {
                temporary = wanted;
                unfinished = std::move(watched);
                return;
            }
            if (errno != EEXIST) break;
        }
        fail("create", name, errno);
    }

    // Writes the buffer, then `more`, and empties the buffer.
    void drain(std::string_view more) {
        iovec parts[2] = {{buffer.data(), buffer.size()}, {const_cast<char*>(more.data()), more.size()}};
        iovec* at = parts;
        iovec* const end = parts + 2;
        for (;;) {
            while (at != end && at->iov_len == 0) ++at;
            if (at == end) break;
            const ssize_t n = ::writev(fd, at, static_cast<int>(end - at));
            if (n < 0 && (errno == EINTR || waited(fd, POLLOUT))) continue;
            if (n < 0) fail("write to", name, errno);
            auto left = static_cast<std::size_t>(n);
            for (iovec* p = at; left > 0; ++p) {
                const std::size_t step = std::min(left, p->iov_len);
                p->iov_base = static_cast<char*>(p->iov_base) + step;
                p->iov_len -= step;
                left -= step;
            }
        }
        buffer.clear();
    }

    // Gives the unnamed file a temporary name in the folder of the final one, because linkat cannot replace a file.
    void name_it() {
        const std::string self = "/proc/self/fd/" + std::to_string(fd);
        name_anew([&](const char* wanted) {
            return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, wanted, AT_SYMLINK_FOLLOW) == 0;
        });
    }
};

Sink::Sink(const std::string& path, Content content) : state_(std::make_unique<State>()) {
    State& s = *state_;
    s.buffer.reserve(kBlock);
    if (path.empty() || path == "-") {
        s.name = "standard output";
        s.fd = STDOUT_FILENO;
        ::fcntl(s.fd, F_SETPIPE_SZ, kPipe); // has no effect if it is not a pipe
    } else {
        s.name = "'" + path + "'";
        s.open(path);
    }
    if (content == Content::binary && ::isatty(s.fd) != 0)
        throw Error(Exit::usage, "cannot write a binary stream to a terminal; pipe it on or give --output FILE");
}

Sink::~Sink() = default;
Sink::Sink(Sink&&) noexcept = default;
Sink& Sink::operator=(Sink&&) noexcept = default;

const std::string& Sink::name() const { return state_->name; }

void Sink::write(std::string_view bytes) {
    State& s = *state_;
    if (s.buffer.size() + bytes.size() > kBlock)
        s.drain(bytes);
    else
        s.buffer.append(bytes);
}

void Sink::commit() {
    State& s = *state_;
    s.drain({});
    if (!s.owned) {
        // a full disk may be reported only when the file is closed
        if (::close(::dup(s.fd)) != 0) fail("write to", s.name, errno);
        return;
    }
    // The contents are written to disk before the rename. Otherwise a power cut could leave an incomplete file in place
    // of a good one.
    if (!s.path.empty() && ::fsync(s.fd) != 0 && errno != EINVAL && errno != EROFS) fail("write to", s.name, errno);
    if (!s.path.empty() && s.temporary.empty()) s.name_it();
    const int fd = std::exchange(s.fd, -1);
    if (::close(fd) != 0) fail("write to", s.name, errno);
    if (s.path.empty()) return;
    if (std::rename(s.temporary.c_str(), s.path.c_str()) != 0) fail("create", s.name, errno);
    s.temporary.clear();
    s.unfinished.reset();
}

} // namespace filum::stream
