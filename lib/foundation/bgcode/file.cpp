#include "bgcode/file.hpp"

#include "base/error.hpp"
#include "bgcode/heatshrink.hpp"
#include "bgcode/meatpack.hpp"

#include <algorithm>
#include <optional>
#include <zlib.h>

namespace filum::bgcode {

namespace {

constexpr std::string_view kMagic = "GCDE";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kMost = std::size_t{1} << 29;       // bytes, of all expanded content
constexpr std::size_t kGcodeBlock = std::size_t{1} << 16; // bytes of text per block
constexpr int kLengthBits = 4;

enum Kind : std::uint16_t { about, gcode, slicer, printer, print, thumbnail, kinds };
enum Compression : std::uint16_t { none, deflated, heatshrink_11, heatshrink_12, compressions };
enum Encoding : std::uint16_t { plain, meatpack, meatpack_with_comments, encodings };

std::uint32_t crc(std::string_view bytes) {
    return static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

// Inflates `data`; none if it is damaged or does not have `size` bytes.
std::optional<std::string> inflated(std::string_view data, std::size_t size) {
    constexpr std::size_t kMostByByte = 1032; // the largest ratio that deflate can reach
    if (size > kMostByByte * (data.size() + 1)) return std::nullopt;
    std::string out(size, '\0');
    uLongf length = size;
    const int rc = uncompress(reinterpret_cast<Bytef*>(out.data()), &length,
                              reinterpret_cast<const Bytef*>(data.data()), data.size());
    if (rc != Z_OK || length != size) return std::nullopt;
    return out;
}

class Reader {
  public:
    Reader(std::string_view bytes, const std::string& name) : all_(bytes), rest_(bytes), name_(name) {}

    File read() {
        take(kMagic.size());
        if (number<std::uint32_t>() != kVersion) bad("it is of a version other than 1");
        const auto checksum = number<std::uint16_t>();
        if (checksum > 1) bad("it has checksums of an unknown kind");
        bool any = false;
        while (!rest_.empty()) any = block(checksum == 1) || any;
        if (!any) bad("it holds no G-code");
        return std::move(out_);
    }

  private:
    [[noreturn]] void bad(const std::string& why) const {
        throw Error(Exit::bad_input, "cannot read binary G-code from " + name_ + ": " + why);
    }

    std::string_view take(std::size_t size) {
        if (rest_.size() < size)
            throw Error(Exit::truncated, "cannot read binary G-code from " + name_ + ": it ends within a block");
        const auto out = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return out;
    }

    template <class T>
    T number() {
        T out = 0;
        const auto bytes = take(sizeof(T));
        for (std::size_t i = sizeof(T); i > 0; --i)
            out = static_cast<T>((out << 8) | static_cast<unsigned char>(bytes[i - 1]));
        return out;
    }

    // Reads a block.  True if it is G-code.
    bool block(bool has_checksum) {
        const std::size_t begin = all_.size() - rest_.size();
        const std::string where = "its block at byte " + std::to_string(begin);
        const auto kind = number<std::uint16_t>(), compression = number<std::uint16_t>();
        if (kind >= kinds) bad(where + " is of an unknown kind");
        if (compression >= compressions) bad(where + " is compressed in an unknown way");
        const std::size_t size = number<std::uint32_t>(), stored = compression == none ? size : number<std::uint32_t>();
        if (taken_ += size; taken_ > kMost) bad("it holds more than 512 MiB");
        Thumbnail picture;
        const auto parameter = number<std::uint16_t>();
        if (kind == thumbnail) {
            picture.width = number<std::uint16_t>();
            picture.height = number<std::uint16_t>();
        }
        const std::string_view data = take(stored);
        const auto whole = all_.substr(begin, all_.size() - rest_.size() - begin);
        if (has_checksum && number<std::uint32_t>() != crc(whole)) bad(where + " has another checksum than its bytes");
        std::optional<std::string> content;
        if (compression == none) content = std::string(data);
        if (compression == deflated) content = inflated(data, size);
        if (compression == heatshrink_11) content = expanded(data, size, 11, kLengthBits);
        if (compression == heatshrink_12) content = expanded(data, size, 12, kLengthBits);
        if (!content) bad(where + " cannot be expanded to the size that it states");
        if (kind == thumbnail) {
            if (parameter > static_cast<std::uint16_t>(Picture::qoi)) bad(where + " is a picture of an unknown kind");
            picture.format = static_cast<Picture>(parameter);
            picture.bytes = std::move(*content);
            out_.thumbnails.push_back(std::move(picture));
        } else if (kind == gcode) {
            if (parameter >= encodings) bad(where + " is encoded in an unknown way");
            out_.gcode += parameter == plain ? *content : unpacked(*content);
        } else {
            if (parameter != 0) bad(where + " is encoded in an unknown way");
            table(*content, kind);
        }
        return kind == gcode;
    }

    // Reads lines of "key=value".
    void table(std::string_view text, std::uint16_t kind) {
        Table& to = kind == about     ? out_.about
                    : kind == slicer  ? out_.slicer
                    : kind == printer ? out_.printer
                                      : out_.print;
        while (!text.empty()) {
            const std::size_t end = std::min(text.find('\n'), text.size());
            const std::string_view line = text.substr(0, end);
            text.remove_prefix(std::min(end + 1, text.size()));
            const auto equals = line.find('=');
            if (equals == line.npos) continue;
            to.emplace_back(line.substr(0, equals), line.substr(equals + 1));
        }
    }

    std::string_view all_, rest_;
    const std::string& name_;
    File out_;
    std::size_t taken_ = 0;
};

template <class T>
void put(T value, std::string& out) {
    for (std::size_t i = 0; i < sizeof(T); ++i) out += static_cast<char>((value >> (8 * i)) & 0xFF);
}

// Appends a block.  `parameters`: the bytes after the header.
void put_block(Kind kind, Compression compression, std::size_t size, const std::string& parameters,
               std::string_view stored, std::string& out) {
    std::string block;
    put<std::uint16_t>(kind, block);
    put<std::uint16_t>(compression, block);
    put(static_cast<std::uint32_t>(size), block);
    if (compression != none) put(static_cast<std::uint32_t>(stored.size()), block);
    block += parameters;
    block += stored;
    out += block;
    put(crc(block), out);
}

std::string parameter(std::uint16_t value) {
    std::string out;
    put(value, out);
    return out;
}

void put_table(Kind kind, const Table& table, std::string& out) {
    std::string text;
    for (const auto& [key, value] : table) text.append(key).append("=").append(value).append("\n");
    std::string packed(compressBound(text.size()), '\0');
    uLongf length = packed.size();
    const int rc = compress(reinterpret_cast<Bytef*>(packed.data()), &length,
                            reinterpret_cast<const Bytef*>(text.data()), text.size());
    packed.resize(length);
    if (rc == Z_OK && packed.size() < text.size())
        put_block(kind, deflated, text.size(), parameter(plain), packed, out);
    else
        put_block(kind, none, text.size(), parameter(plain), text, out);
}

void put_gcode(std::string_view text, std::string& out) {
    while (!text.empty()) {
        std::size_t size = std::min(text.size(), kGcodeBlock);
        if (size < text.size()) // ends the block after a whole line
            if (const auto end = text.rfind('\n', size - 1); end != text.npos) size = end + 1;
        const std::string code = packed(text.substr(0, size));
        text.remove_prefix(size);
        put_block(gcode, heatshrink_12, code.size(), parameter(meatpack_with_comments), shrunk(code, 12, kLengthBits),
                  out);
    }
}

} // namespace

bool begins(std::string_view bytes) { return bytes.starts_with(kMagic); }

File read(std::string_view bytes, const std::string& name) { return Reader(bytes, name).read(); }

std::string written(const File& file) {
    std::string out(kMagic);
    put(kVersion, out);
    put<std::uint16_t>(1, out);
    if (!file.about.empty()) put_table(about, file.about, out);
    put_table(printer, file.printer, out);
    for (const Thumbnail& picture : file.thumbnails) {
        std::string parameters = parameter(static_cast<std::uint16_t>(picture.format));
        put(picture.width, parameters);
        put(picture.height, parameters);
        put_block(thumbnail, none, picture.bytes.size(), parameters, picture.bytes, out);
    }
    put_table(print, file.print, out);
    put_table(slicer, file.slicer, out);
    put_gcode(file.gcode, out);
    return out;
}

} // namespace filum::bgcode
