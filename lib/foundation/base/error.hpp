// The one exception type and the exit codes of every command.
#pragma once

#include <stdexcept>
#include <string>

namespace filum {

// The exit code of a command; documented in every man page.
enum class Exit : int {
    ok = 0,
    failure = 1,   // the work could not be done
    usage = 2,     // the command line is wrong
    bad_input = 3, // the input is not what it should be
    truncated = 4, // the input ends before its end frame
    io = 5,        // reading or writing failed
};

// An error with its exit code. Grammar of the message: lower case, no full stop. It names what failed, then the subject
// in single quotes, then the cause; the next move follows after a semicolon.
class Error : public std::runtime_error {
  public:
    Error(Exit exit, const std::string& what) : std::runtime_error(what), exit_(exit) {}
    [[nodiscard]] Exit exit() const { return exit_; }

  private:
    Exit exit_;
};

} // namespace filum
