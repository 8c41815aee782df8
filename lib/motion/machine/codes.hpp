// Lines of machine programs as text: words, comments, and the meaning of codes for a machine.
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

// `s` without the blanks and line ends at its beginning and end.
std::string_view trimmed(std::string_view s);
std::string first_line(const std::string& text);

// A line of G-code divided into two: the code without comments and checksum, and all comments joined.  A comment stands
// after ';' or in parentheses.
class CodeLine {
  public:
    explicit CodeLine(std::string_view text); // `text` must outlive the CodeLine
    [[nodiscard]] std::string_view code() const { return own_.empty() ? code_ : std::string_view(own_); }
    [[nodiscard]] std::string_view comment() const { return inner_.empty() ? comment_ : std::string_view(inner_); }

  private:
    std::string_view code_, comment_;
    std::string own_, inner_;
};

struct Word {
    char letter = 0; // upper case
    double value = 0;
    int decimals = 0;  // after the point, as written
    bool flag = false; // it has no number, as X in "G28 X"
};

// The contents of a line without comments.
struct Words {
    std::vector<Word> words;
    bool own = false;       // a command with a name, such as Klipper's: it has no words
    bool cut = false;       // a number has a second point; what stands behind it does not count, as in Marlin
    const char* fault = ""; // why the line cannot move anything: "holds a word without a proper number"
};

// Splits a line into words, up to the first text that is no word.  Numbers beyond 1e7 count as no numbers.  A fault
// matters only on a line that moves, as other commands have flags and text.  `to` is reused from line to line.
void split(std::string_view code, Words& to);

// True if the words of the line belong to its M code, as in "M84 X Y E", and move nothing.  The M codes of NIST's
// RS274/NGC are an exception: other codes may follow them, as in "M3 G1 X10".
bool is_command(const Words& line);
// True if the line begins with a G without a number, so that its effect is unknown.
bool lacks_code(const Words& line);

// The line that identifies each tool: the first line of its codes that is in no other tool's codes.  Lines with
// placeholders other than {tool_no} do not count; a tool without such a line is left out.
std::map<std::string, std::uint32_t> tool_lines(const Profile& profile);

// X Y Z, tilt, turn: the numbers of a program, mm and degrees.
using AxisNumbers = std::array<double, 5>;

// The positions of the axes for these numbers of a tool.  `tip`: X Y Z are the tip in the part's frame, else the
// positions of the linear axes.
kinematics::Joints joints_of(const Profile& profile, std::uint32_t tool, const AxisNumbers& numbers, bool tip);

// The index in AxisNumbers of the axis that a letter names; 5: none.
std::size_t axis_of(const Profile& profile, char letter);

} // namespace filum::machine
