// The name that somebody may have meant.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace filum {

// How many letters must be changed, added, dropped or swapped with their neighbour to get from `a` to `b`: the
// restricted Damerau-Levenshtein distance, of bytes.
std::size_t edit_distance(std::string_view a, std::string_view b);

// Of `names` the nearest to `word`, if at most a third of the longer one's letters differ; else the only one that
// `word`, of three letters at least, is a part of, or that is a part of it; else "".  Ties: the first.
std::string nearest(std::string_view word, std::span<const std::string> names);

// "; did you mean 'NAME'?" of the nearest, with `before` in front of it; "" without one.
std::string did_you_mean(std::string_view word, std::span<const std::string> names, const std::string& before = "");

} // namespace filum
