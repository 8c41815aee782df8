// Which arrays of a VTK file hold stresses, and in what order; private to lib/stressfield.
#pragma once

#include "base/note.hpp"
#include "stressfield/components.hpp"
#include "stressfield/read.hpp"

#include <string>
#include <vector>

namespace filum::stressfield {

// What a file says of an array of points before its numbers.
struct ArrayHead {
    std::string name;
    std::size_t width = 1;               // numbers per point
    std::vector<std::string> components; // their names; empty: none has one

    friend bool operator==(const ArrayHead&, const ArrayHead&) = default;
};

// The source of a load case: one array, or arrays of one number each.
struct CaseSource {
    std::string name; // letters, digits, '-' and '_'
    std::vector<std::string> arrays;
    std::size_t width = 0;    // numbers per point of an array
    Order order;              // of the numbers of all arrays; empty: they are a vector
    bool assumed = false;     // nothing in the file says this order: it is VTK's
    bool both_halves = false; // xy and yx are averaged whatever they are, as --order asks for
    double factor = 1;        // to MPa
    std::string unit;
};

// The load cases of a grid whose points have `heads`.  Without --columns these are all arrays that hold stresses by
// their name or by those of their components, also six arrays of a number each.  Noted: an order that is assumed,
// arrays of 6 or 9 numbers that are left out.  Throws Error: bad_input where names leave a doubt, naming the option
// that decides it; usage if --columns or --order does not fit.  Empty if there is none.
std::vector<CaseSource> cases_of(const std::vector<ArrayHead>& heads, const ReadOptions& options,
                                 const std::string& writer, const std::string& file, Notes& notes);

} // namespace filum::stressfield
