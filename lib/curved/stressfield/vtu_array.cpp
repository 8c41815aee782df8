// Binary data: the number of bytes, then the bytes. Compressed: the number of blocks, the size of a block and of the
// last one if that is shorter (otherwise 0), the compressed size of each, then the blocks. In base64 the counts may be
// encoded separately, padded, or together with the data ("VTK XML Formats", wiki of Kitware).
#include "stressfield/vtu_array.hpp"

#include "stressfield/formats.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <zlib.h>

namespace filum::stressfield {

namespace {

constexpr std::uint64_t kMostPacked = 1100; // the greatest compression ratio of zlib

class Reader {
  public:
    Reader(const Array& array, const Encoding& encoding, const std::string& file)
        : array_(array), encoding_(encoding), file_(file), text_(array.text) {
        raw_ = array.format == "appended" && encoding.raw;
        if (array.format != "appended") return;
        std::uint64_t offset = 0;
        const auto [stop, error] =
            std::from_chars(array.offset.data(), array.offset.data() + array.offset.size(), offset);
        if (error != std::errc() || stop == array.offset.data()) fail("has no offset");
        if (offset > encoding.appended.size()) too_short();
        text_ = encoding.appended.substr(offset);
    }

    std::string bytes() {
        const std::uint64_t first = count();
        if (!encoding_.packed) return take(first);
        const std::uint64_t block = count(), last = count();
        std::vector<std::uint64_t> sizes;
        if (first > text_.size()) too_short();
        for (std::uint64_t k = 0; k < first; ++k) sizes.push_back(count());
        std::string out;
        for (std::uint64_t k = 0; k < first; ++k)
            unpack(take(sizes[k]), k + 1 == first && last > 0 ? last : block, out);
        return out;
    }

    [[noreturn]] void fail(const std::string& why) const { bad(file_, "its array '" + array_.name + "' " + why); }

  private:
    [[noreturn]] void too_short() const { cut(file_, "it ends inside its array '" + array_.name + "'"); }

    std::uint64_t count() {
        const std::string b = take(encoding_.wide ? 8 : 4);
        std::uint64_t out = 0;
        for (std::size_t k = 0; k < b.size(); ++k)
            out = out << 8U | static_cast<unsigned char>(b[encoding_.big_endian ? k : b.size() - 1 - k]);
        return out;
    }

    std::string take(std::uint64_t n) {
        if (n > text_.size() - at_ + decoded_.size()) too_short(); // base64 is larger
        if (raw_) {
            at_ += n;
            return std::string(text_.substr(at_ - n, n));
        }
        decode(n);
        used_ += n;
        return decoded_.substr(used_ - n, n);
    }

    // Decodes until n bytes are ready.
    void decode(std::uint64_t n) {
        if (used_ == decoded_.size()) {
            decoded_.clear();
            used_ = 0;
        }
        while (decoded_.size() - used_ < n) {
            std::uint32_t group = 0;
            int digits = 0, padding = 0;
            while (digits < 4) {
                if (at_ == text_.size()) too_short();
                const char c = text_[at_++];
                if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
                const int d = c == '=' ? 0 : digit(c);
                if (d < 0) fail("is no base64");
                padding += c == '=' ? 1 : 0;
                group = group << 6U | static_cast<std::uint32_t>(d);
                ++digits;
            }
            for (int k = 0; k < 3 - padding; ++k)
                decoded_ += static_cast<char>(group >> (16U - 8U * static_cast<unsigned>(k)));
        }
    }

    static int digit(char c) {
        if (c >= 'A' && c <= 'Z') return c - 'A';
        if (c >= 'a' && c <= 'z') return c - 'a' + 26;
        if (c >= '0' && c <= '9') return c - '0' + 52;
        return c == '+' ? 62 : c == '/' ? 63 : -1;
    }

    void unpack(const std::string& packed, std::uint64_t size, std::string& out) {
        const std::size_t before = out.size();
        if (size > kMostPacked * (packed.size() + 1)) fail("has a block larger than its data can hold");
        out.resize(before + size);
        uLongf made = size;
        const int state = uncompress(reinterpret_cast<Bytef*>(out.data() + before), &made,
                                     reinterpret_cast<const Bytef*>(packed.data()), packed.size());
        if (state != Z_OK || made != size) fail("is not what zlib packs");
    }

    const Array& array_;
    const Encoding& encoding_;
    const std::string& file_;
    std::string_view text_;
    bool raw_ = false;
    std::size_t at_ = 0;
    std::string decoded_;
    std::size_t used_ = 0;
};

template <class T>
std::vector<double> numbers_of(const std::string& bytes, bool big_endian, const Reader& reader) {
    if (bytes.size() % sizeof(T) != 0) reader.fail("holds no whole numbers");
    std::vector<double> out(bytes.size() / sizeof(T));
    for (std::size_t i = 0; i < out.size(); ++i) {
        char b[sizeof(T)];
        std::memcpy(b, bytes.data() + i * sizeof(T), sizeof(T));
        if (big_endian) std::reverse(b, b + sizeof(T));
        T value;
        std::memcpy(&value, b, sizeof(T));
        out[i] = static_cast<double>(value);
    }
    return out;
}

std::vector<double> words(const Array& array, const std::string& file) {
    std::vector<double> out;
    const char *at = array.text.data(), *const end = at + array.text.size();
    for (;;) {
        while (at < end && (*at == ' ' || *at == '\n' || *at == '\r' || *at == '\t')) ++at;
        if (at == end) return out;
        double value = 0;
        const auto [stop, error] = std::from_chars(at, end, value);
        if (error == std::errc::invalid_argument)
            bad(file, "its array '" + array.name + "' has something that is no number");
        if (error == std::errc::result_out_of_range) { // it would round to 0, or to no number
            const std::string_view own(at, static_cast<std::size_t>(stop - at));
            value = own.find("e-") != own.npos || own.find("E-") != own.npos ? 0 : std::nan("");
        }
        out.push_back(value);
        at = stop;
    }
}

} // namespace

std::vector<double> values(const Array& array, const Encoding& encoding, const std::string& file) {
    if (array.format == "ascii") return words(array, file);
    if (array.format != "binary" && array.format != "appended")
        bad(file, "its array '" + array.name + "' has the unknown format '" + array.format + "'");
    Reader reader(array, encoding, file);
    const std::string b = reader.bytes();
    const bool big = encoding.big_endian;
    if (array.type == "Float32") return numbers_of<float>(b, big, reader);
    if (array.type == "Float64") return numbers_of<double>(b, big, reader);
    if (array.type == "Int8") return numbers_of<std::int8_t>(b, big, reader);
    if (array.type == "UInt8") return numbers_of<std::uint8_t>(b, big, reader);
    if (array.type == "Int16") return numbers_of<std::int16_t>(b, big, reader);
    if (array.type == "UInt16") return numbers_of<std::uint16_t>(b, big, reader);
    if (array.type == "Int32") return numbers_of<std::int32_t>(b, big, reader);
    if (array.type == "UInt32") return numbers_of<std::uint32_t>(b, big, reader);
    if (array.type == "Int64") return numbers_of<std::int64_t>(b, big, reader);
    if (array.type == "UInt64") return numbers_of<std::uint64_t>(b, big, reader);
    reader.fail("is of the unknown type '" + array.type + "'");
}

} // namespace filum::stressfield
