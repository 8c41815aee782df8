// The comments at the head of a program: what it is, how it was made, what it takes.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "postproc/first_pass.hpp"

#include <string>
#include <vector>

namespace filum::postproc {

// One stage of the pipeline that made the toolpath, as a command line; no paths, no dates, so equal work gives equal
// text.
struct Stage {
    std::string program;
    std::vector<std::pair<std::string, std::string>> settings;
};

// What the axes cost the path, as notes and facts of `stage`: added where there is any.
void add_efforts(const machine::Profile& profile, const FirstPass& first_pass, const std::string& stage, Notes& notes,
                 Facts& facts);

// The lines, without comment marks.  `notes` (of all stages) are summed by stage and phrase, in the order they came;
// `facts` stand as they are.
std::vector<std::string> about(const machine::Profile& profile, const FirstPass& first_pass,
                               const std::vector<Stage>& stages, const Notes& notes, const Facts& facts);

} // namespace filum::postproc
