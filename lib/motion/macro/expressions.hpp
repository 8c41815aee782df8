// Parses expressions of templates.
#pragma once

#include "macro/cursor.hpp"

namespace filum::macro {

// Parses an expression.  `depth`: the number of brackets around it.  Throws FaultAt.
Expression parse_expression(Cursor& in, int depth = 0);

// Parses the index of an item or assignment: sums, products, names, numbers.  Throws FaultAt.
Expression parse_sum(Cursor& in, int depth = 0);

constexpr int kDeepestTemplate = 100; // deepest nesting of brackets, and of conditions

} // namespace filum::macro
