// JSON that others wrote.
#pragma once

#include <map>
#include <string>

namespace filum::wire {

// What the names of a JSON object say, as text: of a list its values with commas between, of true and false 1 and 0, of
// an object "". Empty if `text` is no JSON object.
std::map<std::string, std::string> json_values(const std::string& text);

} // namespace filum::wire
