// Lines of macro languages: labels, loops, jumps, conditions, and the firmware's own commands with named values.
#pragma once

#include <string>
#include <string_view>

namespace filum::ingest {

inline constexpr const char* kRepeats = "calls or repeats a part of the program, which is not followed";

// Whether the line begins with an O-word: "O1000", "o<main>", "o100 while [#1 lt 5]".
bool is_label(std::string_view code);

// Whether a line begins or ends a loop, jumps, or calls or defines a part of the program: an O-word with a keyword
// (LinuxCNC), WHILE, GOTO, IF ... GOTO (Fanuc), while (RepRapFirmware). A label alone is the number or name of the
// program.
bool controls_flow(std::string_view code);

// A command with a name and values, as Klipper has them: "SET_GCODE_OFFSET Z=0.1 MOVE=1".
class OwnCommand {
  public:
    explicit OwnCommand(std::string_view code) : code_(code) {}
    [[nodiscard]] bool is(std::string_view name) const;
    // The value of a key, without quotes; empty if there is none. Names and keys may be in lower case.
    [[nodiscard]] std::string value(std::string_view key) const;
    // Whether the command shifts this axis: KEY or KEY_ADJUST with another value than 0.
    [[nodiscard]] bool shifts(std::string_view axis) const;

  private:
    std::string_view code_;
};

// The blocks of RepRapFirmware's if, elif and else: lines indented deeper than these.
class Condition {
  public:
    void line(std::string_view text);                    // the next line, with its indentation
    void command(std::string_view code);                 // of the same line, if it has a name
    [[nodiscard]] bool holds() const { return inside_; } // whether the line is in a block

  private:
    std::size_t indent_ = 0; // of the line
    std::size_t outer_ = 0;  // of the line with the condition
    bool open_ = false, inside_ = false;
};

} // namespace filum::ingest
