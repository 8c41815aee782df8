// Reads expressions of templates.
#pragma once

#include "macro/cursor.hpp"

namespace filum::macro {

// `depth`: how many brackets it stands in.  Throws FaultAt.
Expression parse_expression(Cursor& in, int depth = 0);

// What may stand on the right of an assignment's index: sums, products, names, numbers.
Expression parse_sum(Cursor& in, int depth = 0);

constexpr int kDeepestTemplate = 100; // brackets within brackets, conditions within conditions

} // namespace filum::macro
