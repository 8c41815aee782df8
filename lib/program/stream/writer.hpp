// Writes a stream. It is complete only after close() has written the end frame.
#pragma once

#include "stream/frame.hpp"
#include "stream/sink.hpp"

namespace filum::stream {

class Writer {
  public:
    // Writes the preamble and the header to `path` ("" or "-": standard output). Throws as Sink does.
    Writer(const std::string& path, const Header& header);

    void write(const RawFrame& frame);
    void write(Tag tag, std::string_view body);
    void write(const Note& note);
    void write(const Fact& fact);

    // Writes the end frame and commits the file. Call it only after all input was read to its own end frame.
    void close();

  private:
    void put(std::string_view bytes);
    Sink sink_;
    std::uint64_t frames_ = 0;
    std::uint32_t crc_ = 0;
};

} // namespace filum::stream
