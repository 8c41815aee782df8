// The streams that `filum print` keeps of its stages, and the report and picture that it makes of them.
#pragma once

#include "app/filum/distribute.hpp"
#include "app/filum/folder.hpp"

#include <memory>
#include <string>
#include <vector>

namespace filum::app::filum {

class KeptStreams {
  public:
    // Makes the folder of --keep, if it does not exist, and a temporary one.  Throws Error(io).
    KeptStreams(const Request& request, const std::vector<Stage>& stages);
    ~KeptStreams(); // removes the streams that commit() has not kept
    KeptStreams(const KeptStreams&) = delete;
    KeptStreams& operator=(const KeptStreams&) = delete;

    // One file for each stage: the copy of its output, or "" if none is needed.
    [[nodiscard]] const std::vector<std::string>& files() const { return files_; }
    [[nodiscard]] std::string summary() const { return folder_.file("summary"); }
    // Gives the streams of --keep their final names.  Throws Error(io).
    void commit();
    // Runs `render` on the toolpath with further options `words`, and writes `output`.  Throws Error with the exit code
    // of `render` if that fails; `render` itself has reported why.
    void draw(const std::vector<std::string>& words, const std::string& output) const;
    // Measures the toolpath and writes a page (HTML) of it to `output`, with outlines and figures.  `input`: the file
    // of the part, for the title; `machine`: the machine profile, or "".  Throws Error.
    void report(const std::string& input, const std::string& machine, const std::string& output) const;
    // The text at the end of a print: the output's name, then the lines of the summary, which also begin the program.
    [[nodiscard]] std::string told(const std::string& output) const;

    // The file of the last stream that carries `payload`, or "".
    [[nodiscard]] std::string last(const std::string& payload) const;

  private:
    Folder folder_;
    bool scaffold_ = false; // --pattern=scaffold: the report measures its pores
    std::vector<std::string> files_, names_, payloads_;
    std::vector<std::string> unfinished_; // files that may be incomplete; commit() empties the list
    std::vector<std::unique_ptr<stream::UnfinishedPath>> watched_;
};

} // namespace filum::app::filum
