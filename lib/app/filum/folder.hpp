// A folder for a while.
#pragma once

#include <string>

namespace filum::app::filum {

// In the folder that TMPDIR names, else in /tmp; taken away with all that is in it when this ends.
class Folder {
  public:
    Folder(); // throws Error(io)
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }

  private:
    std::string path_;
};

} // namespace filum::app::filum
