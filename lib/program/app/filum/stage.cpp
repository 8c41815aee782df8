#include "app/filum/stage.hpp"

#include "app/filum/process.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <unistd.h>

namespace filum::app::filum {

namespace fs = std::filesystem;

namespace {

fs::path own_folder() {
    std::error_code failed;
    const fs::path self = fs::read_symlink("/proc/self/exe", failed);
    if (failed) throw Error(Exit::failure, "cannot find the stages: " + failed.message());
    return self.parent_path();
}

bool is_program(const fs::path& file) {
    std::error_code failed;
    return fs::is_regular_file(file, failed) && ::access(file.c_str(), X_OK) == 0;
}

constexpr std::string_view kExtra = "filum-";

std::vector<std::string> path_folders() {
    const char* path = std::getenv("PATH");
    std::vector<std::string> out;
    std::istringstream all(path != nullptr ? path : "");
    for (std::string folder; std::getline(all, folder, ':');)
        if (!folder.empty()) out.push_back(folder);
    return out;
}

// The path of the first program of that name on the PATH, or "".
std::string on_path(const std::string& name) {
    for (const std::string& folder : path_folders())
        if (const fs::path file = fs::path(folder) / name; is_program(file)) return file.string();
    return "";
}

} // namespace

std::string prefix() { return own_folder().parent_path().string(); }

std::string stage_folder() {
    const fs::path installed = own_folder().parent_path() / "libexec" / "filum";
    std::error_code failed;
    return (fs::is_directory(installed, failed) ? installed : own_folder()).string();
}

bool is_stage(const std::string& name) {
    return !name.empty() && name != "filum" && name.find('/') == std::string::npos &&
           is_program(fs::path(stage_folder()) / name);
}

std::string stage_program(const std::string& name) {
    const fs::path file = fs::path(stage_folder()) / name;
    if (!is_stage(name)) {
        std::vector<std::string> names = stage_names();
        for (const char* own : {"print", "list", "env", "help", "machines", "patterns", "check", "settings", "compare"})
            names.emplace_back(own);
        for (const std::string& extra : extra_names()) names.push_back(extra);
        const std::string meant = did_you_mean(name, names);
        throw Error(Exit::usage, "unknown command '" + name + "'" + (meant.empty() ? "; see 'filum list'" : meant));
    }
    return file.string();
}

std::vector<std::string> stage_names() {
    std::vector<std::string> out;
    for (const auto& entry : fs::directory_iterator(stage_folder())) {
        const std::string name = entry.path().filename();
        if (is_program(entry.path()) && name != "filum" && !name.starts_with('.')) out.push_back(name); // not .loader
    }
    std::sort(out.begin(), out.end());
    return out;
}

namespace {

// Parses the line "NAME REST" and adds REST to the option NAME: as its default if `key` is "default", else as its
// condition.
void add_to_option(Stage& stage, const std::string& key, const std::string& line) {
    const auto space = std::min(line.find(' '), line.size());
    const std::string rest = line.substr(std::min(space + 1, line.size()));
    for (StageOption& o : stage.options) {
        if (o.name != line.substr(0, space)) continue;
        if (key == "default")
            o.value = rest;
        else
            o.needs = rest;
    }
}

} // namespace

namespace {

Stage answered(Stage out, const std::string& text) {
    std::istringstream answer(text);
    for (std::string line; std::getline(answer, line);) {
        const auto space = std::min(line.find(' '), line.size());
        const std::string key = line.substr(0, space), rest = line.substr(std::min(space + 1, line.size()));
        if (key == "synopsis")
            out.synopsis = rest;
        else if (key == "in")
            out.in = rest;
        else if (key == "out")
            out.out = rest;
        else if (key == "flag")
            out.options.push_back({rest, false});
        else if (key == "option")
            out.options.push_back({rest.substr(0, rest.find(' ')), true});
        else if (key == "default" || key == "needs")
            add_to_option(out, key, rest);
    }
    return out;
}

} // namespace

Stage ask(const std::string& name) {
    const std::string program = stage_program(name);
    Stage out = answered({name, program, "", "", "", {}}, output_of({program, "--print-contract"}));
    if (out.in.empty())
        throw Error(Exit::failure, "cannot use '" + out.program + "' as a stage: it says nothing about itself");
    return out;
}

Stage foreign(const Stage& stage, const std::string& file) {
    const std::string found = file.find('/') != std::string::npos ? file
                              : is_stage(file)                    ? stage_program(file)
                                                                  : on_path(file);
    if (!is_program(found))
        throw Error(Exit::usage, "cannot use '" + file + "' as the stage '" + stage.name +
                                     "': it is no program; name its file, as ./mine, and make it executable");
    Stage out{stage.name, found, stage.synopsis, stage.in, stage.out, {}};
    std::string text;
    try {
        text = output_of({found, "--print-contract"}, true);
    } catch (const Error&) {
        return out; // it has no contract, so it takes no options
    }
    Stage said = answered(out, text);
    const std::vector<StageOption> options = said.options;
    out.options = options;
    return out;
}

std::vector<std::string> extra_names() {
    std::vector<std::string> out;
    const std::vector<std::string> own = stage_names();
    for (const std::string& folder : path_folders()) {
        std::error_code failed;
        for (const auto& entry : fs::directory_iterator(folder, failed)) {
            const std::string name = entry.path().filename();
            if (!name.starts_with(kExtra) || !is_program(entry.path())) continue;
            const std::string bare = name.substr(kExtra.size());
            if (!bare.empty() && std::find(own.begin(), own.end(), bare) == own.end()) out.push_back(bare);
        }
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

std::string extra_program(const std::string& name) {
    const bool plain = !name.empty() && name.find('/') == std::string::npos;
    return plain ? on_path(std::string(kExtra) + name) : "";
}

} // namespace filum::app::filum
