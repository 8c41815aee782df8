// Text from files, safe for a terminal, a log or a line of a program.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace filum {

// `text` on one line and without control codes: each of them (C0, DEL, C1, line and paragraph separators, marks that
// turn the direction of writing, codes that Unicode keeps free of characters) and each byte that is no UTF-8 becomes
// \n, \t, \r or \xHH, byte by byte.
std::string printable(std::string_view text);

// The length in bytes of the UTF-8 character at the start of `text`; 0 if `text` is empty or starts with no UTF-8.
std::size_t utf8_character(std::string_view text);

// `text` as a word that no language of machines or tables reads as more than a word: ASCII letters, digits, '-' and
// '_', every other byte replaced by '_', at most 64 of them.  `otherwise`: the word for an empty text.
std::string plain_word(std::string_view text, std::string_view otherwise);

// Tells words of a list apart: the second "a" becomes a_2, the third a_3, skipping words that the list holds already.
std::vector<std::string> told_apart(const std::vector<std::string>& words);

} // namespace filum
