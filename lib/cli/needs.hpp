// Whether an option has an effect beside the others: what Option::when says, judged and put into words.
#pragma once

#include "cli/spec.hpp"

#include <functional>
#include <optional>

namespace filum::cli {

// How an option stands.
struct Standing {
    std::string value;
    bool changed = false; // from its default
};
using Lookup = std::function<Standing(const std::string& option)>;

// "with --pattern scaffold, not with --surface"; "" for no needs.
std::string needs_text(const std::string& needs);

// Why the option `name` cannot be used, if it cannot: the first of its needs that does not hold, and what to do.
std::optional<std::string> fault(const std::string& name, const std::string& needs, const Lookup& lookup);

} // namespace filum::cli
