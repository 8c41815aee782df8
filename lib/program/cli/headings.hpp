// Options as help and pages show them: in groups, each under a heading that states the conditions of all its options.
#pragma once

#include "cli/spec.hpp"

namespace filum::cli {

struct Section {
    std::string heading; // "" for options in no group
    std::string needs; // conditions that all options share, in the syntax of Option::needs; the heading shows them once
    std::vector<Option> options; // their own needs leave out the shared conditions
};

// The sections of the help, in order: options without a group, the groups of `spec`, then `common` under "every
// command". Throws std::logic_error for a group that names an option twice or names an unknown option.
std::vector<Section> sections(const Spec& spec, const std::vector<Option>& common);

// The heading as it is printed: "options", "rows and strands (with --pattern scaffold)".
std::string heading_text(const Section& section);

} // namespace filum::cli
