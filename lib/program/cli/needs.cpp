#include "cli/needs.hpp"

#include <algorithm>
#include <string_view>

namespace filum::cli {

namespace {

std::vector<std::string> split(const std::string& text, char between) {
    std::vector<std::string> out;
    for (std::size_t at = 0; at <= text.size() && !text.empty();) {
        const std::size_t end = std::min(text.find(between, at), text.size());
        out.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return out;
}

// A condition on the value of another option.
struct Setting {
    std::string option;
    std::vector<std::string> values; // the option has one of these values; empty: any value except its default
};

// A condition: at least one of `any` holds, or, if `none` is set, none of them holds.
struct Need {
    std::vector<Setting> any;
    bool none = false;
};

std::vector<Need> parse(const std::string& needs) {
    std::vector<Need> out;
    for (const std::string& word : split(needs, ' ')) {
        Need need{{}, word.starts_with('!')};
        for (const std::string& one : split(need.none ? word.substr(1) : word, '/')) {
            const auto equal = std::min(one.find('='), one.size());
            need.any.push_back({one.substr(0, equal), split(one.substr(std::min(equal + 1, one.size())), '|')});
        }
        out.push_back(std::move(need));
    }
    return out;
}

// The conditions of `needs` for which `keeps` returns true.
std::string picked(const std::string& needs, const std::function<bool(const std::string&)>& keeps) {
    std::string out;
    for (const std::string& word : split(needs, ' '))
        if (keeps(word)) out += (out.empty() ? "" : " ") + word;
    return out;
}

bool has(const std::string& needs, const std::string& condition) {
    const auto all = split(needs, ' ');
    return std::find(all.begin(), all.end(), condition) != all.end();
}

std::string listed(const std::vector<std::string>& words) {
    std::string out;
    for (std::size_t i = 0; i < words.size(); ++i)
        out += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    return out;
}

// The alternatives as they are typed: "--pattern scaffold or --rings".
std::string typed(const Need& need) {
    std::vector<std::string> words;
    for (const Setting& s : need.any)
        words.push_back("--" + s.option + (s.values.empty() ? "" : " " + listed(s.values)));
    return listed(words);
}

bool is_so(const Setting& s, const Lookup& lookup) {
    const OptionState now = lookup(s.option);
    if (s.values.empty()) return now.changed;
    return std::find(s.values.begin(), s.values.end(), now.value) != s.values.end();
}

bool holds(const Need& need, const Lookup& lookup) {
    return need.none != std::any_of(need.any.begin(), need.any.end(), [&](const auto& s) { return is_so(s, lookup); });
}

} // namespace

std::vector<Option> when(const std::string& condition, std::vector<Option> options) {
    for (Option& o : options) o.when(condition);
    return options;
}

std::string needs_text(const std::string& needs) {
    std::string out;
    for (const Need& n : parse(needs))
        out += (out.empty() ? "" : ", ") + std::string(n.none ? "not " : "") + "with " + typed(n);
    return out;
}

std::string shared_needs(std::span<const std::string> needs) {
    if (needs.empty()) return "";
    return picked(needs.front(), [&](const auto& condition) {
        return std::all_of(needs.begin(), needs.end(), [&](const auto& other) { return has(other, condition); });
    });
}

std::string needs_without(const std::string& needs, const std::string& shared) {
    return picked(needs, [&](const auto& condition) { return !has(shared, condition); });
}

std::optional<std::string> fault(const std::string& name, const std::string& needs, const Lookup& lookup) {
    for (const Need& n : parse(needs)) {
        if (holds(n, lookup)) continue;
        std::string out = "cannot use --" + name + ": it does nothing ";
        out += (n.none ? "with " : "without ") + typed(n);
        out += n.none ? "; leave one out" : "; add that, or leave out --";
        if (!n.none) out += name;
        return out;
    }
    return std::nullopt;
}

} // namespace filum::cli
