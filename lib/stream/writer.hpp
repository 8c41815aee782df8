// Writing a stream; nothing counts until close() has written the end frame.
#pragma once

#include "stream/frame.hpp"

#include <memory>

namespace filum::stream {

// A byte sink with commit: a named file is written under a temporary name and renamed by commit(); "" or "-" is
// standard output.  Without commit() a named file never appears.  Throws Error(io); refuses to write binary to a
// terminal with Error(usage).
class Sink {
  public:
    enum class Content { text, binary };
    Sink(const std::string& path, Content content);
    ~Sink();
    Sink(Sink&&) noexcept;
    Sink& operator=(Sink&&) noexcept;

    void write(std::string_view bytes);
    void commit();
    [[nodiscard]] const std::string& name() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

class Writer {
  public:
    // Writes preamble and header to `path` ("" or "-": standard output).
    Writer(const std::string& path, const Header& header);

    void write(const RawFrame& frame);
    void write(Tag tag, std::string_view body);
    void write(const Note& note);
    void write(const Fact& fact);

    // Writes the end frame and commits.  Call it only when all input was read to its own end frame.
    void close();

  private:
    void put(std::string_view bytes);
    Sink sink_;
    std::uint64_t frames_ = 0;
    std::uint32_t crc_ = 0;
};

} // namespace filum::stream
