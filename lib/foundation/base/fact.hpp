// Facts: results about the whole job. The stream carries them beside the notes, which report losses.
#pragma once

#include <string>
#include <vector>

namespace filum {

struct Fact {
    std::string stage; // the program that made the fact
    std::string name;  // lower case, words joined by '-': "strokes", "lower-bound"
    double value = 0;
    std::string unit; // "mm", "strokes"; empty for a pure number
};

using Facts = std::vector<Fact>;

} // namespace filum
