// Where profiles live.
#include "base/error.hpp"
#include "base/nearest.hpp"
#include "machine/profile.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace filum::machine {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> folders() {
    std::vector<fs::path> out;
    if (const char* list = std::getenv("FILUM_PROFILES"); list != nullptr) {
        std::istringstream in(list);
        for (std::string folder; std::getline(in, folder, ':');)
            if (!folder.empty()) out.emplace_back(folder);
    }
    std::error_code none;
    const fs::path self = fs::read_symlink("/proc/self/exe", none);
    if (none) return out;
    const fs::path home = self.parent_path();
    out.push_back(home / ".." / "share" / "filum" / "profiles");
    out.push_back(home / ".." / ".." / "share" / "filum" / "profiles");
    return out;
}

bool is_path(const std::string& name) { return name.find('/') != std::string::npos || name.ends_with(".toml"); }

// `shown` is what messages call the file.
std::string contents(const fs::path& path, const std::string& shown) {
    constexpr std::uintmax_t kMax = 1 << 20;
    std::error_code status;
    if (fs::is_directory(path, status)) throw Error(Exit::io, "cannot read profile '" + shown + "': it is a folder");
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw Error(Exit::io, "cannot open profile '" + shown + "'; see postproc --help for where they are sought");
    std::string text(kMax + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (in.bad()) throw Error(Exit::io, "cannot read profile '" + shown + "'");
    text.resize(static_cast<std::size_t>(in.gcount()));
    if (text.size() > kMax) throw Error(Exit::bad_input, "cannot use profile '" + shown + "': it is above 1 MiB");
    return text;
}

} // namespace

std::vector<std::string> profile_names() {
    std::vector<std::string> names;
    for (const auto& folder : folders()) {
        std::error_code none;
        for (const auto& entry : fs::directory_iterator(folder, none))
            if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

Profile load_profile(const std::string& name_or_path, const std::string& set) {
    if (is_path(name_or_path)) return parse_profile(contents(name_or_path, name_or_path), name_or_path, set);
    for (const auto& folder : folders()) {
        const fs::path path = folder / (name_or_path + ".toml");
        std::error_code none;
        if (!name_or_path.empty() && fs::exists(path, none))
            return parse_profile(contents(path, path.filename().string()), path.filename().string(), set);
    }
    std::string known;
    const auto names = profile_names();
    for (const auto& name : names) known += (known.empty() ? "" : ", ") + name;
    if (known.empty())
        throw Error(Exit::usage, "unknown machine '" + name_or_path +
                                     "': there are no profiles; set FILUM_PROFILES to their folder");
    if (const auto meant = did_you_mean(name_or_path, names); !meant.empty())
        throw Error(Exit::usage, "unknown machine '" + name_or_path + "'" + meant);
    throw Error(Exit::usage, "unknown machine '" + name_or_path + "'; known are " + known + ", or give a .toml file");
}

} // namespace filum::machine
