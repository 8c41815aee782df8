#include "stream/writer.hpp"

#include "base/error.hpp"
#include "stream/crc32c.hpp"
#include "stream/wireformat.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace filum::stream {

namespace {

constexpr std::size_t kBlock = std::size_t{256} << 10;

bool is_standard(const std::string& path) { return path.empty() || path == "-"; }

} // namespace

struct Sink::State {
    std::string name;      // for messages
    std::string path;      // final name, "" for standard output
    std::string temporary; // name until commit
    int fd = -1;
    bool committed = false;
    std::string buffer;

    void drain(const char* data, std::size_t size) const {
        while (size > 0) {
            const ssize_t n = ::write(fd, data, size);
            if (n < 0 && errno == EINTR) continue;
            if (n < 0) throw Error(Exit::io, "cannot write to " + name + ": " + std::strerror(errno));
            data += n;
            size -= static_cast<std::size_t>(n);
        }
    }
    void flush() {
        drain(buffer.data(), buffer.size());
        buffer.clear();
    }
    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (path.empty() || fd < 0) return;
        ::close(fd);
        if (!committed) ::unlink(temporary.c_str());
    }
};

Sink::Sink(const std::string& path, Content content) : state_(std::make_unique<State>()) {
    if (is_standard(path)) {
        state_->name = "standard output";
        state_->fd = STDOUT_FILENO;
        if (content == Content::binary && ::isatty(STDOUT_FILENO) != 0)
            throw Error(Exit::usage, "cannot write a binary stream to a terminal; pipe it on or give --output FILE");
#ifdef F_SETPIPE_SZ
        ::fcntl(STDOUT_FILENO, F_SETPIPE_SZ, 1 << 20); // fails harmlessly where it is no pipe
#endif
        return;
    }
    state_->name = "'" + path + "'";
    struct stat info {};
    const bool special = ::stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode);
    state_->path = path;
    state_->temporary = special ? "" : path + ".part" + std::to_string(::getpid());
    const char* opened = special ? path.c_str() : state_->temporary.c_str();
    state_->fd = ::open(opened, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (state_->fd < 0) throw Error(Exit::io, "cannot create " + state_->name + ": " + std::strerror(errno));
    if (special) state_->committed = true; // a device or a fifo: there is nothing to rename or to remove
}

Sink::~Sink() = default;
Sink::Sink(Sink&&) noexcept = default;
Sink& Sink::operator=(Sink&&) noexcept = default;

const std::string& Sink::name() const { return state_->name; }

void Sink::write(std::string_view bytes) {
    State& s = *state_;
    if (s.buffer.size() + bytes.size() > kBlock) s.flush();
    if (bytes.size() >= kBlock)
        s.drain(bytes.data(), bytes.size());
    else
        s.buffer.append(bytes);
}

void Sink::commit() {
    State& s = *state_;
    s.flush();
    if (s.path.empty()) {
        // a full disk may show only here
        if (::close(::dup(s.fd)) != 0) throw Error(Exit::io, "cannot write to " + s.name + ": " + std::strerror(errno));
        return;
    }
    const int fd = std::exchange(s.fd, -1);
    if (::close(fd) != 0) {
        const int cause = errno;
        if (!s.temporary.empty()) ::unlink(s.temporary.c_str());
        throw Error(Exit::io, "cannot write to " + s.name + ": " + std::strerror(cause));
    }
    if (s.temporary.empty()) return;
    if (std::rename(s.temporary.c_str(), s.path.c_str()) != 0) {
        const int cause = errno;
        ::unlink(s.temporary.c_str());
        throw Error(Exit::io, "cannot create " + s.name + ": " + std::strerror(cause));
    }
    s.committed = true;
}

Writer::Writer(const std::string& path, const Header& header) : sink_(path, Sink::Content::binary) {
    put(preamble());
    write(Tag::header, serialise(header));
}

void Writer::put(std::string_view bytes) {
    crc_ = crc32c(crc_, bytes.data(), bytes.size());
    sink_.write(bytes);
}

void Writer::write(Tag tag, std::string_view body) {
    const std::string prefix = frame_prefix(tag, body.size());
    if (prefix.size() + body.size() > kMaxFrame)
        throw Error(Exit::failure, "cannot write a frame of more than 64 MiB; the part is too large");
    put(prefix);
    put(body);
    ++frames_;
}

void Writer::write(const RawFrame& frame) { write(frame.tag, frame.body); }

void Writer::write(const Note& note) { write(Tag::note, serialise(note)); }

void Writer::write(const Fact& fact) { write(Tag::fact, serialise(fact)); }

void Writer::close() {
    const std::string body = serialise(EndRecord{frames_, crc_});
    sink_.write(frame_prefix(Tag::end, body.size()));
    sink_.write(body);
    sink_.commit();
}

} // namespace filum::stream
