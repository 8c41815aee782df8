// The one exception type and the exit codes of every command.
#pragma once

#include <stdexcept>
#include <string>

namespace filum {

// What a command tells its caller; documented in every man page.
enum class Exit : int {
    ok = 0,
    failure = 1,   // the work could not be done
    usage = 2,     // the command line is wrong
    bad_input = 3, // input is not what it should be
    truncated = 4, // input ends before its end frame
    io = 5,        // reading or writing failed
};

// Message grammar: lower case, no full stop, what failed first, the subject in single quotes, then the cause, then the
// next move after a semicolon.
class Error : public std::runtime_error {
  public:
    Error(Exit exit, const std::string& what) : std::runtime_error(what), exit_(exit) {}
    [[nodiscard]] Exit exit() const { return exit_; }

  private:
    Exit exit_;
};

} // namespace filum
