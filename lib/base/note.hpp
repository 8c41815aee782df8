// What a stage dropped, repaired, merged or could not place: carried in the stream, summed up on standard error.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace filum {

// How much a note matters to the print.
enum class Grade : std::uint8_t { harmless, look, will_fail };

// What a note is about: a row of base/notes.def.  `foreign`: a note by a program that has no row there, which brings
// its own text.
enum class NoteCode : std::uint16_t {
    foreign,
#define NOTE(code, grade, unit, sum, sentence, advice) code,
#include "base/notes.def"
#undef NOTE
};

// What a program of another make says in a note of its own.
struct ForeignNote {
    std::string code, text, unit; // the code may be empty
    Grade grade = Grade::look;
};

struct Note {
    NoteCode code = NoteCode::foreign;
    double amount = 0;       // in the unit of the code
    std::uint64_t count = 1; // cases
    std::int64_t layer = -1; // -1 if it is not on a layer
    double x = std::nan(""); // where the worst case is, mm; nan if nowhere
    double y = std::nan(""); //
    double z = std::nan(""); // of a place in space; nan where the layer gives the height, or nothing does
    std::string detail{};    // what {d} in the sentence stands for
    std::string patch{};     // the patch that it is about, if there are several
    std::string stage{};     // the program that says it; set by what writes the stream
    ForeignNote foreign{};   // where the code is foreign
};

using Notes = std::vector<Note>;

// "will fail", "look", "harmless".
std::string_view name(Grade grade);

// The code as texts have it: "hairline-gap-closed".  A foreign note without a code has its text, made a name.
std::string code_name(const Note& note);
// The code of that name; `foreign` if there is none.
NoteCode note_code(std::string_view name);

Grade grade(const Note& note);
std::string unit(const Note& note);

// The note as one sentence, without its place: "12 hairline gaps were closed (0.04 mm2)".
std::string sentence(const Note& note);
// What the user can do about it: "add --support".  Empty for harmless and foreign notes.
std::string advice(const Note& note);
// Sentence, place and advice, as programs say it: "...; worst on layer 3 at 1.25,7; add --support [overhang]".
std::string line(const Note& note);

// Adds a case to a sum of the same kind; the place is that of the worst case.
void add(Note& sum, const Note& note);
// Whether two notes add up: the same code, detail and patch, by the same stage.
bool same_kind(const Note& a, const Note& b);
// Sums by kind: those that fail first, then those to look at, then harmless ones; else in the order of first cases.
Notes summed(const Notes& notes);

// The page docs/notes.md: a table of all codes.
std::string notes_page();

} // namespace filum
