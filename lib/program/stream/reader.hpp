// Reads a stream from a file, a pipe or memory, and checks its framing: checksum, frame count, order and sizes.
#pragma once

#include "stream/frame.hpp"

#include <memory>
#include <optional>

namespace filum::stream {

// Returns true if `bytes`, the beginning of a file or all of it, begin a stream of any version.
bool is_stream(std::string_view bytes);

class Reader {
  public:
    // Opens `path` ("" or "-": standard input) and reads the preamble and the header frame. Throws Error: io if it
    // cannot be opened or read, truncated if it is empty or ends early. Throws bad_input if it is no Filum stream, has
    // another version, or carries a payload other than `expected` (unknown: any).
    Reader(const std::string& path, Payload expected);
    // Reads a stream in memory, which must outlive this object. `name` is for messages. Throws like the constructor
    // above.
    Reader(std::string_view bytes, std::string name, Payload expected);
    ~Reader();
    Reader(Reader&&) noexcept;
    Reader& operator=(Reader&&) noexcept;

    [[nodiscard]] const Header& header() const;
    // The name of the input in messages: 'part.layers' or 'standard input'.
    [[nodiscard]] const std::string& name() const;
    // The number of bytes read so far. It is the border between two frames, except at the end of the input.
    [[nodiscard]] std::uint64_t offset() const;

    // Returns the next payload, note or fact frame; nullopt once the end frame was read and is correct. Throws Error:
    // truncated if the stream ends before its end frame. Throws bad_input if the checksum or frame count is wrong, a
    // frame is malformed, too long or of another kind, or bytes follow the end.
    std::optional<RawFrame> next();

  private:
    void open(Payload expected);
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace filum::stream
