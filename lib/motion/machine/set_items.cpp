#include "machine/set_items.hpp"

#include "base/error.hpp"
#include "base/printable.hpp"

#include <algorithm>

namespace filum::machine {

namespace {

// The length of the item of `set` that begins at `at`: up to a comma that is not in brackets or in quotes.
std::size_t item_length(std::string_view set, std::size_t at) {
    int open = 0;
    bool quoted = false;
    std::size_t i = at;
    for (; i < set.size(); ++i) {
        if (quoted && set[i] == '\\') {
            ++i;
        } else if (set[i] == '"') {
            quoted = !quoted;
        } else if (!quoted) {
            open += set[i] == '[' ? 1 : set[i] == ']' ? -1 : 0;
            if (set[i] == ',' && open <= 0) break;
        }
    }
    return std::min(i, set.size()) - at;
}

} // namespace

std::string shown(std::string_view text) { return printable(text.substr(0, 60)); }

void cannot_change(std::string_view item, const std::string& why) {
    throw Error(Exit::usage, "cannot set '" + shown(item) + "': " + why);
}

std::vector<std::pair<std::string, std::string>> set_items(std::string_view set) {
    std::vector<std::pair<std::string, std::string>> out;
    for (std::size_t at = 0; at < set.size();) {
        const std::string_view item = set.substr(at, item_length(set, at));
        at += item.size() + 1;
        const auto equals = item.find('=');
        if (equals == std::string_view::npos || equals == 0) cannot_change(item, "it is not KEY=VALUE");
        std::string key(item.substr(0, equals));
        if (key.find('.') == std::string::npos) key = "values." + key;
        if (key.starts_with('.') || key.ends_with('.') || key.find("..") != std::string::npos)
            cannot_change(item, "it is no key");
        out.emplace_back(std::move(key), item.substr(equals + 1));
    }
    return out;
}

} // namespace filum::machine
