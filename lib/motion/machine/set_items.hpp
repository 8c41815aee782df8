// The changes that --set makes to a profile, as text. Private to lib/motion/machine.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace filum::machine {

// The beginning of a text, for messages.
std::string shown(std::string_view text);

// The keys and values of `set`, "a.b=1,c=[2,3],d=\"x, y\"", in their order. A key without a section gets that of
// values. Throws Error(usage) for an item that is no key and value.
std::vector<std::pair<std::string, std::string>> set_items(std::string_view set);

// Throws Error(usage) for an item of `set`.
[[noreturn]] void cannot_change(std::string_view item, const std::string& why);

} // namespace filum::machine
