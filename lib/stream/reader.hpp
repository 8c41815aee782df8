// Reading a stream from a file or a pipe, checking everything that the framing promises.
#pragma once

#include "stream/frame.hpp"

#include <memory>
#include <optional>

namespace filum::stream {

// Whether `bytes`, the begin of a file or all of it, are those of a stream, of any version.
bool is_stream(std::string_view bytes);

class Reader {
  public:
    // Opens `path` ("" or "-": standard input) and reads the preamble and the header frame.
    // Throws Error: io if it cannot be opened or read, truncated if it is empty or ends early, bad_input if it is no
    // Filum stream, has another version, or carries another payload than `expected` (unknown: any will do).
    Reader(const std::string& path, Payload expected);
    // The same, of a stream in memory, which must outlive it; `name` is for messages.
    Reader(std::string_view bytes, std::string name, Payload expected);
    ~Reader();
    Reader(Reader&&) noexcept;
    Reader& operator=(Reader&&) noexcept;

    [[nodiscard]] const Header& header() const;
    // What to call the input in a message: 'part.layers' or 'standard input'.
    [[nodiscard]] const std::string& name() const;
    // How many bytes of the stream were read: a frame border, but for the end of the input.
    [[nodiscard]] std::uint64_t offset() const;

    // The next payload, note or fact frame; nullopt once the end frame was read and found right.
    // Throws Error: truncated if the stream ends before its end frame; bad_input if the checksum or the frame count is
    // wrong, a frame is malformed, too long or of another kind, or something follows the end.
    std::optional<RawFrame> next();

  private:
    void open(Payload expected);
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace filum::stream
