// The text of a machine program, line by line.
#pragma once

#include "machine/profile.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace filum::collision {

bool is_blank(char c); // a space, a tab or a carriage return
std::string_view trimmed(std::string_view text);
std::string first_line(const std::string& text); // trimmed

// A line without its comments; those go to `comment`, one after the other.
struct ProgramLine {
    std::string code, comment;
    explicit ProgramLine(std::string_view text);
};

// The line of each tool's codes by which it is known: the first that no other tool's codes hold.
std::map<std::string, std::uint32_t> tool_lines(const machine::Profile& profile);

} // namespace filum::collision
