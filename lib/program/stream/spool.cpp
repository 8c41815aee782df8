#include "stream/spool.hpp"

#include "base/error.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <unistd.h>
#include <vector>

namespace filum::stream {

namespace {

// Written before each body in the file. Only the process that wrote it reads it.
struct Head {
    std::uint64_t size;
    std::uint32_t tag;
};

[[noreturn]] void failed(const char* verb) {
    throw Error(Exit::io, std::string("cannot ") + verb + " a temporary file: " + std::strerror(errno) +
                              "; set TMPDIR to a folder with room");
}

void write_all(int fd, const char* data, std::size_t size) {
    while (size > 0) {
        const ssize_t n = ::write(fd, data, size);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) failed("write");
        data += n;
        size -= static_cast<std::size_t>(n);
    }
}

} // namespace

struct Spool::State {
    std::size_t memory = 0, kept = 0;
    std::vector<RawFrame> frames;
    std::size_t at = 0; // index of the next frame in memory
    int fd = -1;
    std::string buffer; // bytes to be written, or bytes that were read
    std::size_t begin = 0;
    bool reading = false;

    void open() {
        const char* folder = std::getenv("TMPDIR");
        std::string name = (folder != nullptr && *folder != '\0' ? std::string(folder) : "/tmp") + "/filum.XXXXXX";
        fd = ::mkstemp(name.data());
        if (fd < 0) failed("create");
        ::unlink(name.c_str());
    }
    void drain() {
        write_all(fd, buffer.data(), buffer.size());
        buffer.clear();
    }
    // Reads until buffer[begin..] holds at least `size` bytes. Returns false at the end of the file.
    bool fill(std::size_t size) {
        if (buffer.size() - begin >= size) return true;
        buffer.erase(0, begin);
        begin = 0;
        while (buffer.size() < size) {
            const std::size_t had = buffer.size();
            buffer.resize(std::max(size, had + (std::size_t{1} << 18)));
            const ssize_t n = ::read(fd, buffer.data() + had, buffer.size() - had);
            if (n < 0 && errno != EINTR) failed("read");
            buffer.resize(had + static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
            if (n == 0) return false;
        }
        return true;
    }
    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (fd >= 0) ::close(fd);
    }
};

Spool::Spool(std::size_t memory) : state_(std::make_unique<State>()) { state_->memory = memory; }

Spool::~Spool() = default;

void Spool::add(RawFrame frame) {
    State& s = *state_;
    if (s.fd < 0 && s.kept + frame.body.size() <= s.memory) {
        s.kept += frame.body.size() + sizeof(RawFrame);
        s.frames.push_back(std::move(frame));
        return;
    }
    if (s.fd < 0) s.open();
    const Head head{frame.body.size(), static_cast<std::uint32_t>(frame.tag)};
    s.buffer.append(reinterpret_cast<const char*>(&head), sizeof head);
    s.buffer.append(frame.body);
    if (s.buffer.size() >= (std::size_t{1} << 18)) s.drain();
}

void Spool::rewind() {
    State& s = *state_;
    if (!s.reading) return;
    s.at = 0;
    s.begin = 0;
    s.buffer.clear();
    if (s.fd >= 0 && ::lseek(s.fd, 0, SEEK_SET) != 0) failed("read");
}

std::optional<RawFrame> Spool::next() {
    State& s = *state_;
    if (!s.reading) {
        if (s.fd >= 0) {
            s.drain();
            if (::lseek(s.fd, 0, SEEK_SET) != 0) failed("read");
        }
        s.reading = true;
    }
    if (s.at < s.frames.size()) return s.frames[s.at++];
    if (s.fd < 0) return std::nullopt;
    Head head{};
    if (!s.fill(sizeof head)) {
        if (s.buffer.size() > s.begin) failed("read");
        return std::nullopt;
    }
    std::memcpy(&head, s.buffer.data() + s.begin, sizeof head);
    s.begin += sizeof head;
    if (!s.fill(head.size)) failed("read");
    RawFrame out{static_cast<Tag>(head.tag), s.buffer.substr(s.begin, head.size)};
    s.begin += head.size;
    return out;
}

} // namespace filum::stream
