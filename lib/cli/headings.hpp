// Options as help and pages show them: in groups, each under a heading that says what all of its options need.
#pragma once

#include "cli/spec.hpp"

namespace filum::cli {

struct Section {
    std::string heading;         // "" for options in no group
    std::string needs;           // conditions that all of them have, as Option::needs; shown once, in the heading
    std::vector<Option> options; // without these in their own needs
};

// The options of `spec` in the order of its groups, those in none first, then `common` under "every command".  Throws
// std::logic_error for a group that names an option twice, or one that there is not.
std::vector<Section> sections(const Spec& spec, const std::vector<Option>& common);

// "options", "rows and strands (with --pattern scaffold)".
std::string heading_text(const Section& section);

} // namespace filum::cli
