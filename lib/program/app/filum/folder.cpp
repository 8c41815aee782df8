#include "app/filum/folder.hpp"

#include "base/error.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace filum::app::filum {

std::string Folder::file(const std::string& name) const {
    if (path_.empty()) {
        const char* where = std::getenv("TMPDIR");
        std::string path = std::string(where != nullptr && *where != 0 ? where : "/tmp") + "/filum-XXXXXX";
        if (::mkdtemp(path.data()) == nullptr)
            throw Error(Exit::io, "cannot make a folder in '" + std::filesystem::path(path).parent_path().string() +
                                      "': " + std::strerror(errno) + "; name another by TMPDIR");
        path_ = path;
        unfinished_ = std::make_unique<stream::UnfinishedPath>(path_);
    }
    return path_ + "/" + name;
}

Folder::~Folder() {
    std::error_code failed;
    if (!path_.empty()) std::filesystem::remove_all(path_, failed);
}

} // namespace filum::app::filum
