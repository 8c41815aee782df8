// Reads JSON of other programs.
#pragma once

#include <map>
#include <string>

namespace filum::wire {

// The values of a JSON object as text, by name. A list becomes its values separated by commas, true becomes 1, false 0,
// and a nested object "". If one of several values in a list holds a comma, a quote or a line end, they are in quotes,
// with semicolons between: "a, b";"c\n". Of several equal names the last one counts. Empty if `text` is not a JSON
// object.
std::map<std::string, std::string> json_values(const std::string& text);

// All values of a JSON object and of the objects within it, by path: "a/b" is the value of b in the object a.  Items
// of a list are named by their place, from 0, as "a/0"; the list as a whole has a value as above, too.  Empty if
// `text` is not a JSON object.
std::map<std::string, std::string> json_leaves(const std::string& text);

} // namespace filum::wire
