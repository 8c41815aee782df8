// Where bytes go: standard output, or a named file that appears only when it is complete.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace filum::stream {

// A byte sink with commit: a named file appears under its name only by commit(), whole; "-" (or "") is standard
// output.  A process killed before commit() leaves nothing behind where the file system knows unnamed files.  A device
// or a fifo is written directly, and so is what is open already, by /dev/stdout, /dev/stderr or /dev/fd/N.  A file that
// is replaced keeps its permissions, a link its place: what it leads to is replaced, or made.  Throws Error(io);
// refuses to write binary to a terminal with Error(usage).
class Sink {
  public:
    enum class Content { text, binary };
    Sink(const std::string& path, Content content);
    ~Sink();
    Sink(Sink&&) noexcept;
    Sink& operator=(Sink&&) noexcept;

    void write(std::string_view bytes);
    void commit();
    [[nodiscard]] const std::string& name() const; // for messages: 'part.gcode' or standard output

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace filum::stream
