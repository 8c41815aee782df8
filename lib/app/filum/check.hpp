// `filum check FILE --as STAGE`: whether somebody's own program keeps the promises of a stage.
#pragma once

#include <string>
#include <vector>

namespace filum::app::filum {

// Runs the program on a small part and on damaged streams, says a line per promise on standard output, and returns 0 if
// it keeps all of them, else 1.  Throws Error(usage) for wrong words.
int check_foreign(const std::vector<std::string>& words);

} // namespace filum::app::filum
