// The comments at the head and the end of a program: what it prints, time and material, and how it was made.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "postproc/first_pass.hpp"

#include <string>
#include <vector>

namespace filum::postproc {

// One stage of the pipeline that made the toolpath, as a command line.  It holds no paths and no dates, so that equal
// work gives equal text.
struct Stage {
    std::string program;
    std::vector<std::pair<std::string, std::string>> settings;
};

// Adds the notes on pauses within a stroke, and on layers printed after a pause that should come after them.
void add_waits(const FirstPass& first_pass, Notes& notes);

// Adds what the machine does to the path: facts of `stage` on moves and merging, and with rotary axes on unwinding and
// lean; notes on what exceeds 0.01 degrees or breaks a stroke.
void add_efforts(const machine::Profile& profile, const FirstPass& first_pass, const std::string& stage, Notes& notes,
                 Facts& facts);

// The result in a few lines: strokes with their lower bound, and stops; time and material; size, and place on the bed.
// The place is that of the first pass moved by `shift`.  A line says so if all notes are harmless.  Strokes are those
// of the finished program.
std::vector<std::string> summary(const machine::Profile& profile, const FirstPass& first_pass, Vec2 shift,
                                 const Notes& notes, const Facts& facts);

// The lines at the head of the program, without comment marks: the machine, the summary, the notes of all stages that
// are not harmless, and the meaning of the numbers.
std::vector<std::string> about(const machine::Profile& profile, const FirstPass& first_pass,
                               const std::vector<std::string>& summary, const Notes& notes);

// The lines at the end of the program, without comment marks: the stages, the notes, and all `facts` unchanged.
std::vector<std::string> history(const std::vector<Stage>& stages, const Notes& notes, const Facts& facts);

} // namespace filum::postproc
