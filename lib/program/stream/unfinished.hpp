// Removes files and folders when a signal ends the program.
#pragma once

#include <cstddef>
#include <string>

namespace filum::stream {

// While this object exists, SIGINT, SIGTERM and SIGHUP remove `path` before they end the program. `path` is a file, or
// a folder that is removed with its contents. A signal that was ignored when the program began stays ignored. A path is
// not removed if it is too long, or if all slots are taken.
class UnfinishedPath {
  public:
    explicit UnfinishedPath(const std::string& path);
    ~UnfinishedPath();
    UnfinishedPath(const UnfinishedPath&) = delete;
    UnfinishedPath& operator=(const UnfinishedPath&) = delete;

  private:
    std::size_t slot_;
};

} // namespace filum::stream
