#include "partition/names.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cctype>
#include <set>

namespace filum::partition {

std::string letters(std::size_t i) {
    std::string out;
    for (++i; i > 0; i = (i - 1) / 26) out.insert(out.begin(), static_cast<char>('A' + (i - 1) % 26));
    return out;
}

std::vector<std::string> words(std::string_view list, std::string_view option) {
    std::vector<std::string> out;
    const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '.' || c == '_' || c == '-'; };
    while (!list.empty()) {
        const std::size_t end = std::min(list.find(','), list.size());
        const std::string word(list.substr(0, end));
        const bool last = end == list.size();
        list.remove_prefix(last ? end : end + 1);
        if (word.empty() || word.size() > 64 || !std::all_of(word.begin(), word.end(), plain) ||
            (!last && list.empty()))
            throw Error(Exit::usage, "cannot use --" + std::string(option) + " '" + word +
                                         "': names consist of letters, digits and '._-' and are separated by commas");
        out.push_back(word);
    }
    return out;
}

void name(std::vector<surface::Sheet>& patches, const std::vector<std::string>& names) {
    std::set<std::string> taken(names.begin(), names.end());
    for (const auto& p : patches)
        if (!p.name.empty()) taken.insert(p.name);
    std::size_t used = 0, letter = 0;
    for (auto& p : patches) {
        if (!p.name.empty()) continue;
        if (used < names.size()) {
            p.name = names[used++];
            continue;
        }
        while (taken.contains(letters(letter))) ++letter;
        p.name = letters(letter++);
    }
    if (used < names.size())
        throw Error(Exit::usage, "cannot use --names: there are more names than patches without one, the first is '" +
                                     names[used] + "'; leave it out");
    std::set<std::string> seen;
    for (const auto& p : patches)
        if (!seen.insert(p.name).second)
            throw Error(Exit::usage, "cannot name the patches: two have the name '" + p.name + "'");
}

void keep_only(std::vector<surface::Sheet>& patches, const std::vector<std::string>& names) {
    if (names.empty()) return;
    std::string all;
    for (const auto& p : patches) all += (all.empty() ? "" : ", ") + p.name;
    for (const auto& n : names)
        if (std::none_of(patches.begin(), patches.end(), [&](const auto& p) { return p.name == n; }))
            throw Error(
                Exit::usage,
                std::string("cannot use --only: there is no patch '").append(n).append("'; there are ").append(all));
    std::erase_if(patches, [&](const auto& p) { return std::find(names.begin(), names.end(), p.name) == names.end(); });
}

} // namespace filum::partition
