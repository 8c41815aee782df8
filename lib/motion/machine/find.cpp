// Finds and loads profiles and models of robots.
#include "base/error.hpp"
#include "base/nearest.hpp"
#include "machine/profile.hpp"
#include "machine/reader.hpp"
#include "machine/robot.hpp"

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

// The text of a file.  `shown` is its name in messages, and `kind` the kind of file that they mention.
std::string contents(const fs::path& path, const std::string& shown, const std::string& kind = "profile") {
    constexpr std::uintmax_t kMax = 1 << 20;
    const std::string file = kind + " '" + shown + "'";
    std::error_code status;
    if (fs::is_directory(path, status)) throw Error(Exit::io, "cannot read " + file + ": it is a folder");
    std::ifstream in(path, std::ios::binary);
    if (!in) throw Error(Exit::io, "cannot open " + file + "; see postproc --help for where they are sought");
    std::string text(kMax + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (in.bad()) throw Error(Exit::io, "cannot read " + file);
    text.resize(static_cast<std::size_t>(in.gcount()));
    if (text.size() > kMax) throw Error(Exit::bad_input, "cannot use " + file + ": it is above 1 MiB");
    return text;
}

// The folders of robot models, which are within the folders of profiles or beside them.
std::vector<fs::path> model_folders() {
    std::vector<fs::path> out;
    for (const auto& folder : folders()) {
        out.push_back(folder / "robots");
        out.push_back(folder / ".." / "robots");
    }
    return out;
}

std::vector<std::string> names_in(const std::vector<fs::path>& folders) {
    std::vector<std::string> names;
    for (const auto& folder : folders) {
        std::error_code none;
        for (const auto& entry : fs::directory_iterator(folder, none))
            if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

} // namespace

std::vector<std::string> profile_names() { return names_in(folders()); }

std::vector<std::string> robot_names() { return names_in(model_folders()); }

kinematics::Arm load_robot(const std::string& name_or_path, const std::string& beside, const RobotLinks& links) {
    const std::string kind = "robot model";
    const auto parsed = [&](const fs::path& path, const std::string& shown) {
        const std::string text = contents(path, shown, kind);
        return path.extension() == ".urdf" ? urdf_robot(text, shown, links) : table_robot(text, shown);
    };
    if (is_path(name_or_path) || name_or_path.ends_with(".urdf")) {
        const fs::path path(name_or_path);
        return parsed(path.is_absolute() ? path : fs::path(beside).parent_path() / path, name_or_path);
    }
    for (const auto& folder : model_folders()) {
        const fs::path path = folder / (name_or_path + ".toml");
        std::error_code none;
        if (!name_or_path.empty() && fs::exists(path, none)) return parsed(path, path.filename().string());
    }
    std::string known;
    for (const auto& name : robot_names()) known += (known.empty() ? "" : ", ") + name;
    throw Error(Exit::bad_input, "unknown robot model '" + name_or_path + "'; known are " +
                                     (known.empty() ? "none" : known) + ", or give a .toml or .urdf file");
}

namespace {

ProfileText text_of(const std::string& name_or_path) {
    if (is_path(name_or_path)) return {contents(name_or_path, name_or_path), name_or_path};
    for (const auto& folder : folders()) {
        const fs::path path = folder / (name_or_path + ".toml");
        std::error_code none;
        if (!name_or_path.empty() && fs::exists(path, none))
            return {contents(path, path.filename().string()), path.filename().string()};
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

// The name of the base in the text of a profile; "" if it has none.
std::string base_of(const ProfileText& profile) {
    std::string out;
    Document(profile.text, profile.file, "").text("base", out);
    return out;
}

} // namespace

std::string profile_text(const std::string& name_or_path) { return text_of(name_or_path).text; }

std::vector<ProfileText> profile_texts(const std::string& name_or_path) {
    constexpr std::size_t kMostBases = 8;
    std::vector<ProfileText> out{text_of(name_or_path)};
    fs::path folder = is_path(name_or_path) ? fs::path(name_or_path).parent_path() : fs::path();
    for (std::string base = base_of(out.back()); !base.empty(); base = base_of(out.back())) {
        if (out.size() > kMostBases)
            throw Error(Exit::bad_input, "cannot use profile '" + out.front().file + "': its base '" + base +
                                             "' has more than " + std::to_string(kMostBases) +
                                             " bases, or is its own base; remove that line");
        const fs::path file = folder / base;
        out.push_back(text_of(is_path(base) ? file.string() : base));
        folder = is_path(base) ? file.parent_path() : fs::path();
    }
    return out;
}

Profile load_profile(const std::string& name_or_path, const std::string& set) {
    return parse_profile(profile_texts(name_or_path), set);
}

} // namespace filum::machine
