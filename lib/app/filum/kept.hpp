// What `filum print` keeps of its stages' streams, and makes of them.
#pragma once

#include "app/filum/folder.hpp"
#include "app/filum/route.hpp"

#include <memory>
#include <string>
#include <vector>

namespace filum::app::filum {

class Kept {
  public:
    // Makes the folder of --keep, if it is not there, and one for what is needed for a while.  Throws Error(io).
    Kept(const Request& request, const std::vector<Stage>& stages);
    ~Kept(); // takes away what is not kept
    Kept(const Kept&) = delete;
    Kept& operator=(const Kept&) = delete;

    // A file per stage for its output; "" where nobody needs it.
    [[nodiscard]] const std::vector<std::string>& files() const { return files_; }
    [[nodiscard]] std::string summary() const { return folder_.file("summary"); }
    // Gives the streams of --keep their names.
    void commit();
    // Runs `render` on the toolpath with more words.  Throws Error(failure) if that fails: it has said why.
    void draw(const std::vector<std::string>& words, const std::string& output) const;
    // Measures the toolpath and makes a page of it, with outlines and figures; `machine`: its profile, or "".
    void report(const std::string& input, const std::string& machine, const std::string& output) const;
    // Five lines: the output's name, and what stands first in the program.
    [[nodiscard]] std::string told(const std::string& output) const;

    [[nodiscard]] std::string last(const std::string& payload) const; // the file of the last such stream, or ""

  private:
    Folder folder_;
    bool scaffold_ = false; // its pores are measured for the report
    std::vector<std::string> files_, names_, payloads_;
    std::vector<std::string> unfinished_; // as long as the streams may be incomplete
    std::vector<std::unique_ptr<stream::Unfinished>> watched_;
};

} // namespace filum::app::filum
