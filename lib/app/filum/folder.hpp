// A folder for a while.
#pragma once

#include "stream/unfinished.hpp"

#include <memory>
#include <string>

namespace filum::app::filum {

// In the folder that TMPDIR names, else in /tmp; made when a file in it is first asked for, removed with all that is in
// it when this ends or a signal ends the program.
class Folder {
  public:
    Folder() = default;
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] std::string file(const std::string& name) const; // throws Error(io)

  private:
    mutable std::string path_; // empty: not made yet
    mutable std::unique_ptr<stream::Unfinished> unfinished_;
};

} // namespace filum::app::filum
