// Files and folders that a signal must not leave behind.
#pragma once

#include <cstddef>
#include <string>

namespace filum::stream {

// While this lives, SIGINT, SIGTERM and SIGHUP remove `path`, a file or a folder with all that is in it, before they
// end the program; a signal that was ignored when the program began stays so.  What is not watched for lack of a free
// slot, or since the path is too long, is left behind.
class Unfinished {
  public:
    explicit Unfinished(const std::string& path);
    ~Unfinished();
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;

  private:
    std::size_t slot_;
};

} // namespace filum::stream
