#include "cli/headings.hpp"

#include "cli/needs.hpp"

#include <algorithm>
#include <stdexcept>

namespace filum::cli {

namespace {

// Moves the conditions that all options share to the heading, if there are several options.
void share_needs(Section& s) {
    if (s.options.size() < 2) return;
    std::vector<std::string> all;
    for (const Option& o : s.options) all.push_back(o.needs);
    s.needs = shared_needs(all);
    for (Option& o : s.options) o.needs = needs_without(o.needs, s.needs);
}

} // namespace

std::vector<Section> sections(const Spec& spec, const std::vector<Option>& common) {
    std::vector<Option> left = spec.options;
    std::vector<Section> out(1);
    for (const Group& group : spec.groups) {
        Section section{group.heading, "", {}};
        for (const auto& name : group.options) {
            const auto found = std::find_if(left.begin(), left.end(), [&](const Option& o) { return o.name == name; });
            if (found == left.end())
                throw std::logic_error(spec.name + ": no option '" + name + "' for '" + group.heading + "'");
            section.options.push_back(std::move(*found));
            left.erase(found);
        }
        share_needs(section);
        out.push_back(std::move(section));
    }
    out.front().options = std::move(left);
    if (out.front().options.empty()) out.erase(out.begin());
    out.push_back({"every command", "", common});
    return out;
}

std::string heading_text(const Section& section) {
    if (section.heading.empty()) return "options";
    return section.heading + (section.needs.empty() ? "" : " (" + needs_text(section.needs) + ")");
}

} // namespace filum::cli
