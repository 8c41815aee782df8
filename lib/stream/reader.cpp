#include "stream/reader.hpp"

#include "base/error.hpp"
#include "stream/crc32c.hpp"
#include "stream/wireformat.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace filum::stream {

namespace {

constexpr std::size_t kBlock = std::size_t{256} << 10;

} // namespace

struct Reader::State {
    std::string name;
    int fd = -1;
    std::string buffer = std::string(kBlock, '\0');
    std::size_t at = 0, filled = 0;
    std::uint32_t crc = 0;
    std::uint64_t frames = 0;
    Header header;
    bool ended = false;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (fd > STDIN_FILENO) ::close(fd);
    }

    [[noreturn]] void bad(const std::string& why) const {
        throw Error(Exit::bad_input, "cannot read " + name + ": " + why);
    }
    [[noreturn]] void cut(const std::string& where) const {
        throw Error(Exit::truncated,
                    "cannot read " + name + ": it ends " + where + "; the stage before did not finish");
    }

    std::size_t read_some(char* to, std::size_t size) const {
        for (;;) {
            const ssize_t n = ::read(fd, to, size);
            if (n >= 0) return static_cast<std::size_t>(n);
            if (errno != EINTR) throw Error(Exit::io, "cannot read " + name + ": " + std::strerror(errno));
        }
    }

    // Up to `size` bytes; fewer only at the end of the input.
    std::size_t take(char* to, std::size_t size) {
        std::size_t got = 0;
        while (got < size) {
            if (at == filled) {
                if (size - got >= kBlock) { // straight to where it is wanted
                    const std::size_t n = read_some(to + got, size - got);
                    if (n == 0) return got;
                    got += n;
                    continue;
                }
                at = 0;
                filled = read_some(buffer.data(), kBlock);
                if (filled == 0) return got;
            }
            const std::size_t n = std::min(size - got, filled - at);
            std::memcpy(to + got, buffer.data() + at, n);
            at += n;
            got += n;
        }
        return got;
    }

    // A varint whose bytes are appended to `raw`; nullopt at a clean end of input.
    std::optional<std::uint64_t> varint(std::string& raw) {
        std::uint64_t value = 0;
        for (int shift = 0; shift < 64; shift += 7) {
            char c = 0;
            if (take(&c, 1) == 0) {
                if (shift == 0) return std::nullopt;
                cut("inside a frame");
            }
            raw.push_back(c);
            value |= static_cast<std::uint64_t>(static_cast<unsigned char>(c) & 0x7f) << shift;
            if ((static_cast<unsigned char>(c) & 0x80) == 0) return value;
        }
        bad("a frame length is malformed");
    }

    // One frame.  Its bytes enter the checksum, but for those of an end frame.
    RawFrame frame() {
        std::string raw;
        const auto length = varint(raw);
        if (!length) cut("before its end frame");
        if (*length > kMaxFrame) bad("a frame is longer than 64 MiB");
        const std::size_t prefix = raw.size();
        const auto key = varint(raw);
        const auto size = key ? varint(raw) : key;
        if (!size) cut("inside a frame");
        if ((*key & 7) != 2 || raw.size() - prefix + *size != *length) bad("a frame is malformed");
        RawFrame out{static_cast<Tag>(*key >> 3), {}};
        fill(out.body, *size);
        if (out.tag == Tag::end) return out;
        crc = crc32c(crc, raw.data(), raw.size());
        crc = crc32c(crc, out.body.data(), out.body.size());
        ++frames;
        return out;
    }

    // Grows with what really arrives, so that a false length costs no memory.
    void fill(std::string& body, std::size_t size) {
        constexpr std::size_t kStep = std::size_t{4} << 20;
        while (body.size() < size) {
            const std::size_t from = body.size(), step = std::min(kStep, size - from);
            body.resize(from + step);
            if (take(body.data() + from, step) < step) cut("inside a frame");
        }
    }

    void finish(const RawFrame& end) {
        const EndRecord record = parse_end(end.body);
        if (record.frames != frames) bad("its end frame counts other frames than were read; it is corrupt");
        if (record.crc != crc) bad("its checksum is wrong; it is corrupt");
        char c = 0;
        if (take(&c, 1) != 0) bad("something follows its end frame");
        ended = true;
    }
};

Reader::Reader(const std::string& path, Payload expected) : state_(std::make_unique<State>()) {
    State& s = *state_;
    const bool standard = path.empty() || path == "-";
    s.name = standard ? "standard input" : "'" + path + "'";
    s.fd = standard ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (s.fd < 0) throw Error(Exit::io, "cannot open " + s.name + ": " + std::strerror(errno));
    if (standard && ::isatty(STDIN_FILENO) != 0)
        throw Error(Exit::usage, "cannot read a stream from a terminal; pipe one in or name a file");

    char head[kPreambleSize];
    const std::size_t got = s.take(head, kPreambleSize);
    if (got == 0)
        throw Error(Exit::truncated, "cannot read " + s.name + ": it is empty; did the stage before it fail?");
    const std::string wanted = preamble();
    const std::size_t magic = std::min<std::size_t>(got, 10);
    if (wanted.compare(0, magic, head, magic) != 0) s.bad("it is no Filum stream");
    if (got < kPreambleSize) s.cut("inside its preamble");
    if (wanted.compare(0, kPreambleSize, head, kPreambleSize) != 0) s.bad("its format version is not 1");
    s.crc = crc32c(0, head, kPreambleSize);

    const RawFrame first = s.frame();
    if (first.tag != Tag::header) s.bad("its first frame is no header");
    s.header = parse_header(first.body);
    if (expected != Payload::unknown && s.header.payload != expected)
        s.bad("it carries " + std::string(stream::name(s.header.payload)) + ", not " +
              std::string(stream::name(expected)) + "; is a stage missing?");
}

Reader::~Reader() = default;
Reader::Reader(Reader&&) noexcept = default;
Reader& Reader::operator=(Reader&&) noexcept = default;

const Header& Reader::header() const { return state_->header; }
const std::string& Reader::name() const { return state_->name; }

std::optional<RawFrame> Reader::next() {
    State& s = *state_;
    if (s.ended) return std::nullopt;
    RawFrame f = s.frame();
    if (f.tag == Tag::end) {
        s.finish(f);
        return std::nullopt;
    }
    if (!is_remark(f.tag) && f.tag != tag_of(s.header.payload)) s.bad("it holds a frame of another kind");
    return f;
}

} // namespace filum::stream
