// What a stage found out about the whole job: carried in the stream beside the notes, which are for losses.
#pragma once

#include <string>
#include <vector>

namespace filum {

struct Fact {
    std::string stage; // the program that says it
    std::string name;  // lower case, words joined by '-': "strokes", "lower-bound"
    double value = 0;
    std::string unit; // "mm", "strokes"; empty for a pure number
};

using Facts = std::vector<Fact>;

} // namespace filum
