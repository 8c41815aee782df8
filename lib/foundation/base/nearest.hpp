// Finds the name that a misspelt word may stand for.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace filum {

// The restricted Damerau-Levenshtein distance of two texts, in bytes. It is the number of letters that must be changed,
// added, dropped or swapped with their neighbour to turn `a` into `b`.
std::size_t edit_distance(std::string_view a, std::string_view b);

// The name in `names` that is nearest to `word`, if at most a third of the letters of the longer one differ. Ties: the
// first. Otherwise the only name that contains `word` or is contained in it, if both have at least three letters.
// Otherwise "".
std::string nearest(std::string_view word, std::span<const std::string> names);

// "; did you mean 'NAME'?" for the nearest name, with `before` in front of the name; "" if there is none.
std::string did_you_mean(std::string_view word, std::span<const std::string> names, const std::string& before = "");

} // namespace filum
