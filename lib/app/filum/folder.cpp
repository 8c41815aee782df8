#include "app/filum/folder.hpp"

#include "base/error.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace filum::app::filum {

Folder::Folder() {
    const char* where = std::getenv("TMPDIR");
    path_ = std::string(where != nullptr && *where != 0 ? where : "/tmp") + "/filum-XXXXXX";
    if (::mkdtemp(path_.data()) == nullptr)
        throw Error(Exit::io, "cannot make a folder in '" + std::filesystem::path(path_).parent_path().string() +
                                  "': " + std::strerror(errno) + "; name another by TMPDIR");
}

Folder::~Folder() {
    std::error_code failed;
    std::filesystem::remove_all(path_, failed);
}

} // namespace filum::app::filum
