// Writes bytes to standard output, or to a named file that appears only when it is complete.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace filum::stream {

// A destination of bytes; "-" or "" is standard output. A named file appears under its name only at commit(), complete.
// If the process is killed before, nothing is left behind on file systems that support unnamed files. Devices and fifos
// are written directly, and so are open files named /dev/stdout, /dev/stderr or /dev/fd/N. A file that is replaced
// keeps its permissions. A symbolic link stays, and its target is replaced or created. Throws Error(io); Error(usage)
// for binary content on a terminal.
class Sink {
  public:
    enum class Content { text, binary };
    Sink(const std::string& path, Content content);
    ~Sink();
    Sink(Sink&&) noexcept;
    Sink& operator=(Sink&&) noexcept;

    void write(std::string_view bytes);
    void commit();
    [[nodiscard]] const std::string& name() const; // name in messages: 'part.gcode' or standard output

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace filum::stream
