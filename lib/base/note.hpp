// What a stage dropped, repaired, merged or could not place: carried in the stream, summed up on stderr.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace filum {

struct Note {
    std::string stage;       // the program that says it
    std::string what;        // a short fixed phrase: "gap closed"
    double amount = 0;       // in `unit`, summed over `count` cases
    std::string unit;        // "mm", "mm2", "triangles"
    std::uint64_t count = 1; //
    std::int64_t layer = -1; // -1 if it is no layer's
    double x = std::nan(""); // where the worst case is, mm; nan if nowhere
    double y = std::nan(""); //
    double z = std::nan(""); // of a place in space; nan where a layer says how high, or nothing does
};

using Notes = std::vector<Note>;

} // namespace filum
