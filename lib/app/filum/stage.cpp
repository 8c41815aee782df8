#include "app/filum/stage.hpp"

#include "app/filum/process.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"

#include <algorithm>
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

} // namespace

std::string prefix() { return own_folder().parent_path().string(); }

std::string stage_folder() {
    const fs::path installed = own_folder().parent_path() / "libexec" / "filum";
    std::error_code failed;
    return (fs::is_directory(installed, failed) ? installed : own_folder()).string();
}

std::string stage_program(const std::string& name) {
    const fs::path file = fs::path(stage_folder()) / name;
    if (name.empty() || name == "filum" || name.find('/') != std::string::npos || !is_program(file)) {
        std::vector<std::string> names = stage_names();
        for (const char* own : {"print", "list", "env", "help"}) names.emplace_back(own);
        const std::string meant = did_you_mean(name, names);
        throw Error(Exit::usage, "unknown command '" + name + "'" + (meant.empty() ? "; see 'filum list'" : meant));
    }
    return file.string();
}

std::vector<std::string> stage_names() {
    std::vector<std::string> out;
    for (const auto& entry : fs::directory_iterator(stage_folder()))
        if (is_program(entry.path()) && entry.path().filename() != "filum") out.push_back(entry.path().filename());
    std::sort(out.begin(), out.end());
    return out;
}

namespace {

// "NAME REST" for the option of that name.
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

Stage ask(const std::string& name) {
    Stage out{name, stage_program(name), "", "", "", {}};
    std::istringstream answer(output_of({out.program, "--print-contract"}));
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
    if (out.in.empty())
        throw Error(Exit::failure, "cannot use '" + out.program + "' as a stage: it says nothing about itself");
    return out;
}

} // namespace filum::app::filum
