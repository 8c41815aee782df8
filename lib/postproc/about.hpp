// The comments at the head and the end of a program: what it is, what it takes, how it was made.
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

// What the pauses of a program cost it.
void add_waits(const FirstPass& first_pass, Notes& notes);

// What the axes cost the path, as notes, and facts of `stage`: added where there is any.
void add_efforts(const machine::Profile& profile, const FirstPass& first_pass, const std::string& stage, Notes& notes,
                 Facts& facts);

// What the program makes: its strokes, the fewest that there can be and its stops; time and material; size and place on
// the bed, which is the first pass's moved by `shift`; a line that says so where all notes are harmless.  The number of
// strokes is that of the finished program.
std::vector<std::string> summary(const machine::Profile& profile, const FirstPass& first_pass, Vec2 shift,
                                 const Notes& notes, const Facts& facts);

// The lines at the head of the program, without comment marks: what it is for, the summary, notes that are not harmless
// (of all stages), what its numbers mean.
std::vector<std::string> about(const machine::Profile& profile, const FirstPass& first_pass,
                               const std::vector<std::string>& summary, const Notes& notes);

// Those at its end: how it was made.  `facts` stand as they are.
std::vector<std::string> history(const std::vector<Stage>& stages, const Notes& notes, const Facts& facts);

} // namespace filum::postproc
