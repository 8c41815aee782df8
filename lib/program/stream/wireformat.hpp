// The parts of the protobuf wire format that framing needs; private to lib/program/stream.
#pragma once

#include "stream/frame.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace filum::stream {

inline constexpr std::uint64_t kMagic = 0x0a6d756c69468900; // bytes 00 89 'F' 'i' 'l' 'u' 'm' 0a
inline constexpr std::uint32_t kVersion = 1;
inline constexpr std::size_t kPreambleSize = 15;

inline void append_varint(std::string& out, std::uint64_t v) {
    for (; v >= 0x80; v >>= 7) out.push_back(static_cast<char>(v | 0x80));
    out.push_back(static_cast<char>(v));
}

// Stops protobuf from printing messages about malformed input on standard error, since Filum reports them itself.
void be_quiet();

// The preamble of this version, with its length prefix.
std::string preamble();

// The length prefix, tag and inner length of a frame whose message has `body` bytes.
std::string frame_prefix(Tag tag, std::size_t body);

std::string serialise(const Header& header);
Header parse_header(std::string_view body); // throws Error(bad_input)

struct EndRecord {
    std::uint64_t frames = 0;
    std::uint32_t crc = 0;
};
std::string serialise(const EndRecord& end);
EndRecord parse_end(std::string_view body); // throws Error(bad_input)

} // namespace filum::stream
