// `filum check FILE --as STAGE`: tests whether a program of the user's own can replace a stage.
#pragma once

#include <string>
#include <vector>

namespace filum::app::filum {

// Runs the program on a small part and on damaged streams.  Prints a line for each promise on standard output: kept or
// broken.  Returns 0 if the program keeps all promises, else 1.  Throws Error(usage) for wrong words.
int check_foreign(const std::vector<std::string>& words);

} // namespace filum::app::filum
