// Options that had another name before.
#pragma once

#include <string>
#include <vector>

namespace filum::cli {

// "; it is called '--min-radius' now" for "least-radius", if that is one of `names` and the old one is none; else "".
// `prefix` is what such options begin with.
std::string renamed(const std::string& old, const std::vector<std::string>& names, const std::string& prefix = "--");

} // namespace filum::cli
