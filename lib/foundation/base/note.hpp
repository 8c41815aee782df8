// Notes: records of what a stage dropped, repaired, merged or could not place. The stream carries them, and the summary
// on standard error counts them.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace filum {

// How much a note matters to the print.
enum class Grade : std::uint8_t { harmless, look, will_fail };

// The kind of a note: a row of base/notes.def. `foreign`: a note of a program that has no row there and brings its own
// text.
enum class NoteCode : std::uint16_t {
    foreign,
#define NOTE(code, grade, unit, sum, sentence, advice) code,
#include "base/notes.def"
#undef NOTE
};

// The text of a note by a program that is not part of Filum.
struct ForeignNote {
    std::string code, text, unit; // the code may be empty
    Grade grade = Grade::look;
};

struct Note {
    NoteCode code = NoteCode::foreign;
    double amount = 0;       // in the unit of the code; notes.def says how amounts of cases add up
    std::uint64_t count = 1; // number of cases
    std::int64_t layer = -1; // the layer of the worst case; -1 if it is not on a layer
    double x = std::nan(""); // the place of the worst case, mm; nan if there is none
    double y = std::nan(""); //
    double z = std::nan(""); // height of the place, mm; nan if it follows from the layer or is unknown
    std::string detail{};    // the text for {d} in the sentence
    std::string patch{};     // the patch that the note is about, if there are several
    std::string stage{};     // the program that made the note; set by the writer of the stream
    double bead = 0;         // width of the job's beads, mm; 0: unknown or not needed. Set by the writer of the stream
    ForeignNote foreign{};   // its text, if the code is foreign
};

using Notes = std::vector<Note>;

// The name of the grade: "will fail", "look" or "harmless".
std::string_view name(Grade grade);

// The name of the note's code in texts: "hairline-gap-closed". A foreign note without a code gets a name made from its
// text.
std::string code_name(const Note& note);
// The code with that name; `foreign` if there is none.
NoteCode note_code(std::string_view name);

// The grade of the note's code, or the one that a foreign note brings; that of any amount.
Grade code_grade(const Note& note);
// Whether the note's amounts add up to an area or a length, and less than a dot of it is harmless. True for foreign
// notes in mm2 and mm; codes of `every`, `most` and `least` in notes.def are excepted.
bool goes_by_amount(const Note& note);
// The grade of a sum of notes. It is harmless, of any code that goes by its amount, if all of it is less than the dot
// of a bead: an area below pi/4 w^2, or a length below w, for beads w wide. Otherwise it is code_grade(). Nothing is
// less than a bead of unknown width.
Grade grade(const Note& sum);
std::string unit(const Note& note);

// The note as one sentence, without its place: "12 hairline gaps were closed (0.04 mm2)".
std::string sentence(const Note& note);
// What the user can do about it: "add --support".  Empty for harmless and foreign notes.
std::string advice(const Note& note);
// Sentence, place, advice and code, as programs print them: "...; worst on layer 3 at 1.25,7; add --support
// [overhang]".
std::string line(const Note& note);

// Adds `note` to a sum of the same kind. The sum keeps the place of the worst case, and the narrower bead.
void add(Note& sum, const Note& note);
// True if two notes can be summed: the same code, detail and patch, by the same stage. Foreign notes also need the same
// unit, and the same text if they have no code.
bool same_kind(const Note& a, const Note& b);
// The notes summed by kind, ordered by grade: will_fail, look, harmless. Within a grade they keep the order of their
// first cases.
Notes summed(const Notes& notes);

// The page docs/notes.md: a table of all codes.
std::string notes_page();

} // namespace filum
