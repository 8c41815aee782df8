// Selection of the arrays of a VTK file with stresses, and the order of their components; private to
// lib/curved/stressfield.
#pragma once

#include "base/note.hpp"
#include "stressfield/components.hpp"
#include "stressfield/read.hpp"

#include <string>
#include <vector>

namespace filum::stressfield {

// The properties of an array of point data.
struct ArrayHead {
    std::string name;
    std::size_t width = 1;               // numbers per point
    std::vector<std::string> components; // their names; empty: none has a name

    friend bool operator==(const ArrayHead&, const ArrayHead&) = default;
};

// The source of a load case: one array, or arrays of one number each.
struct CaseSource {
    std::string name; // letters, digits, '-' and '_'
    std::vector<std::string> arrays;
    std::size_t width = 0;    // numbers per point of an array
    Order order;              // of the numbers of all arrays; empty: the array is a vector
    bool assumed = false;     // nothing in the file states the order; VTK's is used
    bool both_halves = false; // xy and yx are averaged even if they differ, as --order requests
    double factor = 1;        // to MPa
    std::string unit;
    bool unit_named = false; // by the array, not by default
};

// The load cases of a grid with the arrays `heads`. Without --columns these are all arrays with stresses by their name
// or by those of their components, and groups of six arrays of one number. Notes: an assumed order, ignored arrays of
// 6 or 9 numbers. Throws Error: bad_input if names are ambiguous, naming the option that decides; usage if --columns
// or --order does not suit the file. Empty if there are none.
std::vector<CaseSource> cases_of(const std::vector<ArrayHead>& heads, const ReadOptions& options,
                                 const std::string& writer, const std::string& file, Notes& notes);

} // namespace filum::stressfield
