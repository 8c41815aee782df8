// Whether an option has an effect beside the others: what Option::when says, judged and put into words.
#pragma once

#include "cli/spec.hpp"

#include <functional>
#include <optional>
#include <span>

namespace filum::cli {

// How an option stands.
struct Standing {
    std::string value;
    bool changed = false; // from its default
};
using Lookup = std::function<Standing(const std::string& option)>;

// "with --pattern scaffold, not with --surface"; "" for no needs.
std::string needs_text(const std::string& needs);

// The conditions that all of `needs` have, in the order of the first; "" for none.
std::string shared_needs(std::span<const std::string> needs);

// `needs` but for the conditions of `shared`.
std::string needs_without(const std::string& needs, const std::string& shared);

// Why the option `name` cannot be used, if it cannot: the first of its needs that does not hold, and what to do.
std::optional<std::string> fault(const std::string& name, const std::string& needs, const Lookup& lookup);

} // namespace filum::cli
