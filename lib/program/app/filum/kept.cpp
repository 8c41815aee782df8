#include "app/filum/kept.hpp"

#include "app/filum/process.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace filum::app::filum {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kStream = "stream ";

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

} // namespace

KeptStreams::KeptStreams(const Request& request, const std::vector<Stage>& stages) {
    std::error_code failed;
    if (!request.keep.empty() && (fs::create_directories(request.keep, failed), failed))
        throw Error(Exit::io, "cannot make the folder '" + request.keep + "': " + failed.message());
    for (const auto& words : request.arguments)
        scaffold_ = scaffold_ || std::find(words.begin(), words.end(), "--pattern=scaffold") != words.end();
    const std::string own =
        std::to_string(::getpid()) + ".part"; // another process may keep its streams in the same folder
    for (std::size_t s = 0; s < stages.size(); ++s) {
        const bool stream = stages[s].out.starts_with(kStream);
        payloads_.push_back(stream ? stages[s].out.substr(kStream.size()) : "");
        const std::string name = std::to_string(s + 1) + "-" + stages[s].name + "." + lower(payloads_.back());
        const bool wanted = request.keep.empty() ? request.shows() : true;
        names_.push_back(stream && !request.keep.empty() ? request.keep + "/" + name : "");
        files_.push_back(!stream || !wanted     ? ""
                         : request.keep.empty() ? folder_.file(name)
                                                : names_.back() + "." + own);
        if (names_.back().empty()) continue;
        unfinished_.push_back(files_.back());
        watched_.push_back(std::make_unique<stream::UnfinishedPath>(files_.back()));
    }
}

KeptStreams::~KeptStreams() {
    std::error_code failed;
    for (const std::string& file : unfinished_) fs::remove(file, failed);
}

void KeptStreams::commit() {
    for (std::size_t s = 0; s < files_.size(); ++s) {
        if (names_[s].empty()) continue;
        std::error_code failed;
        fs::rename(files_[s], names_[s], failed);
        if (failed) throw Error(Exit::io, "cannot write '" + names_[s] + "': " + failed.message());
        files_[s] = names_[s];
    }
    unfinished_.clear();
    watched_.clear();
}

std::string KeptStreams::last(const std::string& payload) const {
    for (std::size_t s = files_.size(); s-- > 0;)
        if (payloads_[s] == payload) return files_[s];
    return "";
}

void KeptStreams::draw(const std::vector<std::string>& words, const std::string& output) const {
    Command command{stage_program("render"), last("Toolpath"), "--output=" + output};
    command.insert(command.end(), words.begin(), words.end());
    const ProcessEnd ended = run_piped({command}, {""}).front();
    const bool known = !ended.by_signal && ended.code <= static_cast<int>(Exit::io);
    if (ended.code != 0)
        throw Error(known ? static_cast<Exit>(ended.code) : Exit::failure,
                    "cannot draw '" + output + "': render ended with " + std::to_string(ended.code));
}

void KeptStreams::report(const std::string& input, const std::string& machine, const std::string& output) const {
    const std::string figures = folder_.file("figures.tsv"), regions = last("Regions");
    std::vector<std::string> words;
    if (!machine.empty()) words.push_back("--machine=" + machine);
    if (!regions.empty()) words.push_back("--regions=" + regions);
    Command measure{stage_program("metrics"), last("Toolpath"), "--format=tsv", "--output=" + figures};
    measure.insert(measure.end(), words.begin(), words.end());
    if (scaffold_) measure.emplace_back("--pores");
    if (const ProcessEnd ended = run_piped({measure}).front(); ended.code != 0)
        throw Error(Exit::failure,
                    "cannot make the report '" + output + "': metrics ended with " + std::to_string(ended.code));
    words.push_back("--figures=" + figures);
    words.push_back("--title=" + fs::path(input).filename().string());
    draw(words, output);
}

std::string KeptStreams::told(const std::string& output) const {
    std::string out = (output == "-" ? "standard output" : printable(output)) + "\n";
    std::ifstream text(summary());
    for (std::string line; std::getline(text, line);) out += "  " + printable(line) + "\n";
    return out;
}

} // namespace filum::app::filum
