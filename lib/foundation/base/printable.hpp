// Makes text from files safe for a terminal, a log or a line of a program.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace filum {

// `text` on one line without control codes. Each control code and each byte that is not UTF-8 becomes \n, \t, \r or
// \xHH, byte by byte. Control codes are C0, DEL, C1, line and paragraph separators, marks that change the direction of
// writing, and codes that Unicode reserves as noncharacters.
std::string printable(std::string_view text);

// The length in bytes of the UTF-8 character at the start of `text`; 0 if `text` is empty or starts with no UTF-8.
std::size_t utf8_character(std::string_view text);

// `text` as one word of ASCII letters, digits, '-' and '_', at most 64 of them. Any other byte becomes '_'. So every
// machine language and table format reads it as one word. `otherwise` replaces an empty text.
std::string plain_word(std::string_view text, std::string_view otherwise);

// Makes the words of a list distinct: the second "a" becomes a_2 and the third a_3. Words that the list already holds
// are skipped.
std::vector<std::string> told_apart(const std::vector<std::string>& words);

} // namespace filum
