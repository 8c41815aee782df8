// Text of machine code: numbers as whole multiples of the last decimal, and comments that a controller cannot execute.
#pragma once

#include "machine/profile.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace filum::postproc {

// Appends units * 10^-decimals without trailing zeros: 12500, 3 -> "12.5".
inline void append_units(std::string& out, std::int64_t units, int decimals) {
    if (units < 0) out.push_back('-');
    auto left = units < 0 ? 0 - static_cast<std::uint64_t>(units) : static_cast<std::uint64_t>(units);
    while (decimals > 0 && left % 10 == 0) {
        left /= 10;
        --decimals;
    }
    char buffer[32];
    char* const end = buffer + sizeof buffer;
    char* at = end;
    for (int k = 0; k < decimals; ++k, left /= 10) *--at = static_cast<char>('0' + left % 10);
    if (decimals > 0) *--at = '.';
    do {
        *--at = static_cast<char>('0' + left % 10);
        left /= 10;
    } while (left != 0);
    out.append(at, static_cast<std::size_t>(end - at));
}

// Appends `text` as a comment without a line end: ";text" or "(text)".  Control characters become escapes such as \n.
// Parentheses become brackets where they would end the comment.  Comments that LinuxCNC would execute, such as
// "(logopen,FILE)", get a '-' in front.
void append_comment(std::string& out, std::string_view text, machine::CommentStyle style);

// `text` broken at spaces into lines of at most `width` characters; lines after the first begin with `indent`.  A word
// longer than a line is cut.
std::vector<std::string> wrapped(std::string_view text, std::size_t width, std::string_view indent);

// A duration as "1d 2h 3m 4s"; seconds are rounded up.
std::string duration(double seconds);

} // namespace filum::postproc
