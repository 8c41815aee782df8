// The same surface in other triangles, or elsewhere, is filled the same.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace filum::trials {

struct Likeness {
    std::string words;               // what was compared, for a person
    std::vector<std::string> faults; // in what they differ, one line each
};

// Lays one path on a random surface, on that with its triangles shuffled, with each split in four, and turned about,
// and compares coverage, length and strokes.  Throws Error if no surface or no path comes of it.
Likeness compare(std::uint64_t seed, std::uint64_t number);

} // namespace filum::trials
