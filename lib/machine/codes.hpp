// Lines of machine programs as text: words, comments, and which codes mean what to a machine.
#pragma once

#include "kinematics/chain.hpp"
#include "machine/profile.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace filum::machine {

// `s` without blanks and line ends at both ends.
std::string_view trimmed(std::string_view s);
std::string first_line(const std::string& text);

// A line without its comments (behind ';', in parentheses) and checksum; the comments, one after the other.
class CodeLine {
  public:
    explicit CodeLine(std::string_view text); // which it may refer to
    [[nodiscard]] std::string_view code() const { return own_.empty() ? code_ : std::string_view(own_); }
    [[nodiscard]] std::string_view comment() const { return inner_.empty() ? comment_ : std::string_view(inner_); }

  private:
    std::string_view code_, comment_;
    std::string own_, inner_;
};

struct Word {
    char letter = 0; // upper case
    double value = 0;
    int decimals = 0;  // behind the point, as written
    bool flag = false; // has no number, as X in "G28 X"
};

// What a line without comments holds.
struct Words {
    std::vector<Word> words;
    bool own = false;       // a command by a name of the controller's own, such as Klipper's: it has no words
    const char* fault = ""; // why the line cannot move anything: "holds a word without a proper number"
};

// Splits a line into words.  Numbers beyond 1e7 are none.  Words end where something stands that is no word.  A fault
// matters on a line that moves: other commands have flags and text.  `to` is reused from line to line.
void split(std::string_view code, Words& to);

// True if the words of the line belong to its M code, as in "M84 X Y E", and move nothing.  The M codes of NIST's
// RS274/NGC are an exception: other codes may follow them, as in "M3 G1 X10".
bool is_command(const Words& line);
// It begins with a G without a number: what the line does is unknown.
bool lacks_code(const Words& line);

// The line of each tool's codes by which it is known: the first that no other tool's codes hold.
std::map<std::string, std::uint32_t> tool_lines(const Profile& profile);

// X Y Z, tilt, turn: the numbers of a program, mm and degrees.
using AxisNumbers = std::array<double, 5>;

// What they mean for a tool; `tip`: X Y Z are the tip in the part's frame, else where the axes stand.
kinematics::Joints joints_of(const Profile& profile, std::uint32_t tool, const AxisNumbers& numbers, bool tip);

// Which of the axes a letter names; none: 5.
std::size_t axis_of(const Profile& profile, char letter);

} // namespace filum::machine
