// Checks whether an option has an effect together with the other options (Option::when), and puts its conditions into
// words.
#pragma once

#include "cli/spec.hpp"

#include <functional>
#include <optional>
#include <span>

namespace filum::cli {

// The value of an option in this run.
struct OptionState {
    std::string value;
    bool changed = false; // whether it differs from the default
};
using Lookup = std::function<OptionState(const std::string& option)>;

// The conditions in words: "with --pattern scaffold, not with --surface"; "" without conditions.
std::string needs_text(const std::string& needs);

// The conditions that all of `needs` share, in the order of the first; "" if they share none.
std::string shared_needs(std::span<const std::string> needs);

// `needs` without the conditions of `shared`.
std::string needs_without(const std::string& needs, const std::string& shared);

// Why the option `name` has no effect, and what to do: text for the first of its needs that is not met. None if all are
// met.
std::optional<std::string> fault(const std::string& name, const std::string& needs, const Lookup& lookup);

} // namespace filum::cli
