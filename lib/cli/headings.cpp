#include "cli/headings.hpp"

#include "cli/needs.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace filum::cli {

namespace {

std::vector<std::string> words(const std::string& needs) {
    std::istringstream in(needs);
    std::vector<std::string> out;
    for (std::string word; in >> word;) out.push_back(word);
    return out;
}

std::string joined(const std::vector<std::string>& words) {
    std::string out;
    for (const auto& word : words) out += (out.empty() ? "" : " ") + word;
    return out;
}

bool has(const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

// Moves what all options need to the heading, if there are several.
void share_needs(Section& s) {
    if (s.options.size() < 2) return;
    auto shared = words(s.options.front().needs);
    for (const Option& o : s.options)
        std::erase_if(shared, [&](const auto& word) { return !has(words(o.needs), word); });
    for (Option& o : s.options) {
        auto own = words(o.needs);
        std::erase_if(own, [&](const auto& word) { return has(shared, word); });
        o.needs = joined(own);
    }
    s.needs = joined(shared);
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
