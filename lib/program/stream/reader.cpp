#include "stream/reader.hpp"

#include "base/error.hpp"
#include "stream/crc32c.hpp"
#include "stream/input.hpp"
#include "stream/wireformat.hpp"

namespace filum::stream {

namespace {

constexpr std::size_t kMaxPrefix = 30; // bytes of three varints
constexpr std::size_t kMagicSize = 10; // bytes at the start of the preamble; the rest is the version

// Reads a varint from the front of `bytes` and removes it. If it is longer than ten bytes, `fine` becomes false.
// Returns nullopt then, and also if the varint is cut short.
std::optional<std::uint64_t> take_varint(std::string_view& bytes, bool& fine) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (i == 10) break;
        const auto c = static_cast<unsigned char>(bytes[i]);
        value |= static_cast<std::uint64_t>(c & 0x7f) << (7 * i);
        if ((c & 0x80) != 0) continue;
        bytes.remove_prefix(i + 1);
        return value;
    }
    fine = fine && bytes.size() < 10;
    return std::nullopt;
}

} // namespace

struct Reader::State {
    Input input;
    std::uint32_t crc = 0;
    std::uint64_t frames = 0;
    Header header;
    bool ended = false;

    explicit State(const std::string& path) : input(path) { be_quiet(); }
    State(std::string_view bytes, std::string name) : input(bytes, std::move(name)) { be_quiet(); }

    [[noreturn]] void bad(const std::string& why) const {
        throw Error(Exit::bad_input, "cannot read " + input.name() + ": " + why);
    }
    [[noreturn]] void cut(const std::string& where) const {
        throw Error(Exit::truncated,
                    "cannot read " + input.name() + ": it ends " + where + "; the stage before did not finish");
    }

    void check_preamble() {
        const std::string wanted = preamble();
        const auto head = input.ahead(kPreambleSize);
        if (head.empty())
            throw Error(Exit::truncated,
                        "cannot read " + input.name() + ": it is empty; did the stage before it fail?");
        const std::size_t magic = std::min(head.size(), kMagicSize);
        if (head.substr(0, magic) != std::string_view(wanted).substr(0, magic))
            bad("it is no Filum stream; meshes are read by 'slice' and 'geodesic'");
        if (head.size() < kPreambleSize) cut("inside its preamble");
        if (head != wanted) bad("its format version is not " + std::to_string(kVersion));
        crc = crc32c(0, head.data(), head.size());
        input.drop(head.size());
    }

    // Reads one frame. Its bytes enter the checksum, except those of an end frame.
    RawFrame frame() {
        const auto window = input.ahead(kMaxPrefix);
        if (window.empty()) cut("before its end frame");
        auto rest = window;
        bool fine = true;
        const auto length = take_varint(rest, fine);
        const auto inner = rest.size();
        const auto key = length ? take_varint(rest, fine) : length;
        const auto size = key ? take_varint(rest, fine) : key;
        if (!fine) bad("a frame is malformed");
        if (length && *length > kMaxFrame) bad("a frame is longer than 64 MiB");
        if (!size) cut("inside a frame");
        if ((*key & 7) != 2 || *key >> 35 != 0 || *size > kMaxFrame || inner - rest.size() + *size != *length)
            bad("a frame is malformed");
        RawFrame out{static_cast<Tag>(*key >> 3), {}};
        const std::size_t prefix = window.size() - rest.size();
        std::uint32_t sum = crc32c(crc, window.data(), prefix);
        input.drop(prefix);
        if (!input.append(out.body, *size, sum)) cut("inside a frame");
        if (out.tag == Tag::end) return out;
        crc = sum;
        ++frames;
        return out;
    }

    void finish(const RawFrame& end) {
        const EndRecord record = parse_end(end.body);
        if (record.frames != frames) bad("its end frame counts other frames than were read; it is corrupt");
        if (record.crc != crc) bad("its checksum is wrong; it is corrupt");
        if (!input.ahead(1).empty()) bad("something follows its end frame");
        ended = true;
    }
};

bool is_stream(std::string_view bytes) { return bytes.starts_with(std::string_view(preamble()).substr(0, kMagicSize)); }

Reader::Reader(const std::string& path, Payload expected) : state_(std::make_unique<State>(path)) { open(expected); }

Reader::Reader(std::string_view bytes, std::string name, Payload expected)
    : state_(std::make_unique<State>(bytes, std::move(name))) {
    open(expected);
}

namespace {

// The advice in a message: which stages turn a stream of `here` into one of `wanted`.
std::string next_move(Payload here, Payload wanted) {
    constexpr const char* kStages[] = {"", "slice", "regions | sequence", "fill", "link3d", "geodesic"};
    const auto at = static_cast<int>(here), to = static_cast<int>(wanted);
    const int last = static_cast<int>(Payload::toolpath);
    if (here == Payload::surface && wanted == Payload::toolpath) return "; run 'surfpath' on it first";
    if (here == Payload::unknown || at > last || to > last)
        return "; give what '" + std::string(kStages[to]) + "' writes";
    if (at > to) return "; give what '" + std::string(kStages[to]) + "' writes, this is further on";
    std::string chain;
    for (int k = at + 1; k <= to; ++k) chain += (chain.empty() ? "" : " | ") + std::string(kStages[k]);
    return "; run '" + chain + "' on it first";
}

} // namespace

void Reader::open(Payload expected) {
    State& s = *state_;
    s.check_preamble();
    const RawFrame first = s.frame();
    if (first.tag != Tag::header) s.bad("its first frame is no header");
    s.header = parse_header(first.body);
    if (expected != Payload::unknown && s.header.payload != expected)
        s.bad("it carries " + std::string(stream::name(s.header.payload)) + ", not " +
              std::string(stream::name(expected)) + next_move(s.header.payload, expected));
}

Reader::~Reader() = default;
Reader::Reader(Reader&&) noexcept = default;
Reader& Reader::operator=(Reader&&) noexcept = default;

const Header& Reader::header() const { return state_->header; }
const std::string& Reader::name() const { return state_->input.name(); }
std::uint64_t Reader::offset() const { return state_->input.offset(); }

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
