// A temporary folder.
#pragma once

#include "stream/unfinished.hpp"

#include <memory>
#include <string>

namespace filum::app::filum {

// A temporary folder in the folder that TMPDIR names, else in /tmp.  The first call of file() makes it.  The destructor
// removes it with its content; so does a signal that ends the program.
class Folder {
  public:
    Folder() = default;
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    // The path of the file `name` in the folder.  Throws Error(io) if the folder cannot be made.
    [[nodiscard]] std::string file(const std::string& name) const;

  private:
    mutable std::string path_; // empty: not made yet
    mutable std::unique_ptr<stream::UnfinishedPath> unfinished_;
};

} // namespace filum::app::filum
